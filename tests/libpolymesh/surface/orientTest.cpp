// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/orient.h"

#include "libpolymesh/surface/edges.h"
#include "libpolymesh/surface/measure.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

namespace polymesh {

namespace {

TEST(OrientSurface, leavesWhatIsRightAsItIs) {
    const TriSurface cavity = test::join(test::sphere(2), test::inverted(test::sphere(1, 0.5)));
    for (const TriSurface& given : {test::cuboid(), cavity, TriSurface{}}) {
        TriSurface surface = given;
        const OrientationReport report = orientSurface(surface);
        EXPECT_EQ(surface, given);
        EXPECT_EQ(report.turnedTriangles, 0);
        EXPECT_FALSE(report.turnedAll);
    }
}

TEST(OrientSurface, turnsASurfaceThatIsInsideOut) {
    TriSurface surface = test::inverted(test::cuboid());
    const OrientationReport report = orientSurface(surface);
    EXPECT_EQ(surface, test::cuboid());
    EXPECT_TRUE(report.turnedAll);
    EXPECT_EQ(report.turnedTriangles, 12);
}

TEST(OrientSurface, turnsTrianglesThatDisagree) {
    const TriSurface right = test::shuffled(test::sphere(3));
    TriSurface surface = right;
    for (Label t = 0; t < surface.triangleCount(); t += 3)
        test::turn(surface, t);
    const OrientationReport report = orientSurface(surface);
    EXPECT_EQ(surface, right);
    EXPECT_EQ(report.turnedTriangles, (surface.triangleCount() + 2) / 3);
    EXPECT_EQ(report.shells, 1);
}

TEST(OrientSurface, turnsNestedShellsByTheirDepth) {
    const double pi43 = measure(test::sphere(3)).volume; // of radius 1
    TriSurface surface = test::sphere(3, 4);
    for (double radius : {3.0, 2.0, 1.0})
        surface = test::join(surface, test::sphere(3, radius));
    surface = test::join(surface, test::inverted(test::sphere(3, 1, {10, 0, 0})));
    const OrientationReport report = orientSurface(surface);
    EXPECT_EQ(report.shells, 5);
    EXPECT_EQ(report.nestedShells, 2);
    EXPECT_EQ(report.nestedTurned, 2);
    EXPECT_EQ(report.turnedTriangles, 3 * 512);
    EXPECT_FALSE(report.turnedAll);
    EXPECT_NEAR(measure(surface).volume, pi43 * (64 - 27 + 8 - 1 + 1), 1e-10);
}

TEST(OrientSurface, takesShellsThatTouchForWhatTheyAre) {
    // A cavity may share corners, edges or a face's plane with its shell, and neighbours may share
    // a face; none of that makes a neighbour a cavity or a cavity a neighbour.
    TriSurface neighbours =
        test::join(test::cuboid({0, 0, 0}, {1, 1, 1}), test::cuboid({1, 0, 0}, {2, 1, 1}));
    EXPECT_EQ(orientSurface(neighbours).nestedShells, 0);
    TriSurface cavity =
        test::join(test::cuboid({0, 0, 0}, {3, 3, 3}), test::cuboid({1, 1, 0}, {2, 2, 1}));
    EXPECT_EQ(orientSurface(cavity).nestedTurned, 1);
    TriSurface corner =
        test::join(test::cuboid({0, 0, 0}, {3, 3, 3}), test::cuboid({0, 0, 0}, {1, 1, 1}));
    EXPECT_EQ(orientSurface(corner).nestedTurned, 1);
}

TEST(OrientSurface, leavesShellsThatCrossOutward) {
    TriSurface surface = test::join(test::cuboid({0, 0, 0}, {2, 2, 2}),
                                    test::inverted(test::cuboid({1, 1, 1}, {3, 3, 3})));
    const OrientationReport report = orientSurface(surface);
    EXPECT_EQ(report.nestedShells, 0);
    EXPECT_EQ(report.turnedTriangles, 12);
    EXPECT_DOUBLE_EQ(measure(surface).volume, 16);
}

TEST(OrientSurface, treatsCubesThatShareAnEdgeAsTwoShells) {
    const TriSurface first = test::cuboid({0, 0, 0}, {1, 1, 1});
    TriSurface surface = test::join(first, test::inverted(test::cuboid({1, 1, 0}, {2, 2, 1})));
    const OrientationReport report = orientSurface(surface);
    EXPECT_EQ(report.shells, 2);
    EXPECT_EQ(report.turnedTriangles, 12);
    EXPECT_DOUBLE_EQ(measure(surface).volume, 2);
    EXPECT_TRUE(openEdges(surface).empty());
}

TEST(OrientSurface, makesAnOpenPartConsistentButDoesNotTurnIt) {
    TriSurface surface = test::inverted(test::without(test::cuboid(), 0));
    const TriSurface given = surface;
    test::turn(surface, 4);
    const OrientationReport report = orientSurface(surface);
    EXPECT_EQ(surface, given);
    EXPECT_EQ(report.openParts, 1);
    EXPECT_EQ(report.shells, 0);
}

TEST(OrientSurface, leavesAMoebiusBandAsItIs) {
    std::vector<Vec3> points;
    for (int i = 0; i < 6; ++i) {
        const double angle = std::numbers::pi * i / 3;
        const double half = angle / 2;
        for (double s : {-0.3, 0.3})
            points.push_back({(1 + s * std::cos(half)) * std::cos(angle),
                              (1 + s * std::cos(half)) * std::sin(angle),
                              s * std::sin(half)});
    }
    TriSurface band = test::surfaceOf(
        points,
        {{0, 2, 3, 1}, {2, 4, 5, 3}, {4, 6, 7, 5}, {6, 8, 9, 7}, {8, 10, 11, 9}, {10, 1, 0, 11}});
    const TriSurface given = band;
    const OrientationReport report = orientSurface(band);
    EXPECT_EQ(band, given);
    EXPECT_EQ(report.turnedTriangles, 0);
    EXPECT_EQ(report.openParts, 1);
}

} // namespace

} // namespace polymesh
