// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surfaceRepair/uniteSurface.h"

#include "libpolymesh/surface/check.h"
#include "libpolymesh/surface/measure.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <random>

namespace polymesh::test {
namespace {

/// Turned so that nothing lies on planes of round numbers any more.
TriSurface askew(TriSurface surface) {
    for (Vec3& p : surface.points)
        p = {0.36 * p.x + 0.48 * p.y - 0.8 * p.z,
             -0.8 * p.x + 0.6 * p.y,
             0.48 * p.x + 0.64 * p.y + 0.6 * p.z};
    return surface;
}

/// The united surface, without flaws.
UnitedSurface united(const TriSurface& surface) {
    const auto result = uniteSurface(surface);
    if (!result) {
        ADD_FAILURE() << "the surface could not be united";
        return {};
    }
    EXPECT_TRUE(checkSurface(result->surface).isClosed());
    EXPECT_EQ(findSelfIntersections(result->surface, 1).count, 0);
    EXPECT_EQ(result->pairsLeft, 0);
    EXPECT_EQ(result->surface.regionNames, surface.regionNames);
    return *result;
}

double volumeOf(const TriSurface& surface) {
    return measure(surface).volume;
}

TEST(UniteSurface, leavesASurfaceWithoutSelfIntersectionsAlone) {
    const TriSurface surface = sphere(3);
    const UnitedSurface result = united(surface);
    EXPECT_EQ(result.surface, surface);
    EXPECT_EQ(result.divided, 0);
    EXPECT_EQ(result.rounds, 0);
}

TEST(UniteSurface, takesWhatTwoCubesShareOnce) {
    const TriSurface cubes = join(cuboid({0, 0, 0}, {1, 1, 1}), cuboid({.5, .5, .5}, {2, 2, 2}));
    const UnitedSurface result = united(cubes);
    EXPECT_NEAR(volumeOf(result.surface), 1 + 1.5 * 1.5 * 1.5 - .125, 1e-14);
    EXPECT_NEAR(measure(result.surface).area, 6 + 6 * 2.25 - 6 * .25, 1e-13);
    EXPECT_EQ(result.rounds, 1); // all places are halves
    EXPECT_EQ(result.largestMove, 0);
}

TEST(UniteSurface, agreesWithTheVolumeOfALensWhenSpheresOverlap) {
    const TriSurface spheres = join(sphere(4), sphere(4, 1, {1, 0.3, 0.2}));
    const double distance = std::sqrt(1 + 0.09 + 0.04);
    const double lens = std::numbers::pi * (4 + distance) * (2 - distance) * (2 - distance) / 12;
    const double whole = 4 * std::numbers::pi / 3;
    EXPECT_NEAR(volumeOf(united(spheres).surface), 2 * whole - lens, 0.02 * whole);
}

TEST(UniteSurface, dropsWhatIsInsideAnotherPartAndKeepsCavities) {
    const TriSurface body = cuboid({0, 0, 0}, {4, 4, 4}, "body");
    const TriSurface swallowed = cuboid({1, 1, 1}, {2, 2, 2}, "swallowed");
    const TriSurface cavity = inverted(cuboid({2.5, 2.5, 2.5}, {3.5, 3.5, 3.5}, "cavity"));
    const TriSurface knob = cuboid({3, 1, 1}, {5, 2, 2}, "knob"); // makes it intersect itself
    const UnitedSurface result = united(join(join(join(body, swallowed), cavity), knob));
    EXPECT_NEAR(volumeOf(result.surface), 64 - 1 + 1, 1e-12);
    const std::vector<double> areas = measure(result.surface).regionArea;
    EXPECT_EQ(areas[1], 0); // the region keeps its name, so that its patch is there
    EXPECT_NEAR(areas[2], 6, 1e-12);
    EXPECT_NEAR(areas[3], 5, 1e-12);
}

TEST(UniteSurface, joinsCubesThatTouchWithAFaceOrPartOfIt) {
    EXPECT_NEAR(volumeOf(united(join(cuboid(), cuboid({1, 0, 0}, {2, 1, 1}))).surface), 2, 1e-14);
    const TriSurface shifted = join(cuboid(), cuboid({1, .3, .4}, {2, 1.7, 1.2}));
    EXPECT_NEAR(volumeOf(united(shifted).surface), 1 + 1.4 * .8, 1e-14);
    EXPECT_NEAR(volumeOf(united(askew(shifted)).surface), 1 + 1.4 * .8, 1e-13);
}

TEST(UniteSurface, cutsOffAFoldThatIsInsideOut) {
    // The lid's middle is pushed through the floor: what comes out below is turned inward.
    TriSurface surface = sphere(2);
    for (Vec3& p : surface.points)
        if (p == Vec3{0, 0, 1}) p = {0, 0, -1.5};
    const UnitedSurface result = united(surface);
    for (const Vec3& p : result.surface.points)
        EXPECT_GE(p.z, -1);
    EXPECT_GT(volumeOf(result.surface), 0);
    EXPECT_GT(result.divided, 4);
}

TEST(UniteSurface, dropsTrianglesWithoutAreaThatOthersTouch) {
    // The edge from (0 0 0) to (2 0 0) has a point that only one of its sides knows; a triangle
    // without area closes the surface.
    const TriSurface surface =
        surfaceOf({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}},
                  {{0, 2, 1}, {0, 1, 4}, {0, 4, 3}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}});
    EXPECT_EQ(checkSurface(surface).zeroAreaTriangles.count, 1);
    EXPECT_GT(findSelfIntersections(surface, 1).count, 0);
    const UnitedSurface result = united(surface);
    EXPECT_EQ(checkSurface(result.surface).zeroAreaTriangles.count, 0);
    EXPECT_EQ(result.surface.triangleCount(), 6); // the long triangle is two now
    EXPECT_NEAR(volumeOf(result.surface), 8.0 / 6, 1e-15);
    EXPECT_NEAR(volumeOf(united(askew(surface)).surface), 8.0 / 6, 1e-14);
}

TEST(UniteSurface, findsTheVolumeOfRandomCubesThatOverlap) {
    // Boxes on a grid of halves, counted cell by cell.
    std::mt19937 random(7);
    for (int trial = 0; trial < 20; ++trial) {
        TriSurface surface;
        std::array<std::array<std::array<bool, 8>, 8>, 8> inside{};
        for (int part = 0; part < 4; ++part) {
            std::array<std::size_t, 3> low{};
            std::array<std::size_t, 3> high{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = random() % 6;
                high[axis] = low[axis] + 1 + random() % 2;
            }
            for (std::size_t i = low[0]; i < high[0]; ++i)
                for (std::size_t j = low[1]; j < high[1]; ++j)
                    for (std::size_t k = low[2]; k < high[2]; ++k)
                        inside[i][j][k] = true;
            const auto at = [](const std::array<std::size_t, 3>& p) {
                return Vec3{0.5 * static_cast<double>(p[0]),
                            0.5 * static_cast<double>(p[1]),
                            0.5 * static_cast<double>(p[2])};
            };
            surface =
                part == 0 ? cuboid(at(low), at(high)) : join(surface, cuboid(at(low), at(high)));
        }
        double expected = 0;
        for (const auto& plane : inside)
            for (const auto& row : plane)
                expected += 0.125 * static_cast<double>(std::ranges::count(row, true));
        if (findSelfIntersections(surface, 1).count == 0) continue;
        EXPECT_NEAR(volumeOf(united(surface).surface), expected, 1e-13) << trial;
        EXPECT_NEAR(volumeOf(united(askew(surface)).surface), expected, 1e-12) << trial;
    }
}

TEST(UniteSurface, namesNothingWhereNothingIsInside) {
    const TriSurface surface = join(cuboid(), cuboid({.5, .5, .5}, {2, 2, 2}));
    EXPECT_FALSE(uniteSurface(inverted(surface)).has_value());
}

} // namespace
} // namespace polymesh::test
