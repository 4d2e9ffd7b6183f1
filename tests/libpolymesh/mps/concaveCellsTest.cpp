// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Single concave cells: no part is inverted, and the volume is what TetGen finds.

#include "libpolymesh/mps/makeDivisible.h"
#include "libpolymesh/reference/tetgen.h"
#include "tests/libpolymesh/mps/divided.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace polymesh {

namespace {

using test::Polygon;
using test::Polyhedron;

void dividesWell(const PolyMesh& mesh) {
    const double volume = test::volumeOf(mesh);
    if (hasTetgen()) {
        const auto oracle = tetgenVolumes(mesh, cellFaces(mesh), std::vector<Label>{0});
        ASSERT_TRUE(oracle[0]);
        EXPECT_NEAR(*oracle[0], volume, 1e-12 * volume);
    }
    Divisible work = makeDivisible(mesh, {{}, tetgenTetrahedraliser()});
    EXPECT_TRUE(work.plan.inverted.empty());
    const PolyMesh result = divide(work.mesh, std::move(work.plan));
    EXPECT_TRUE(validate(result).empty());
    EXPECT_NEAR(test::volumeOf(result), volume, 1e-12 * volume);
    EXPECT_GT(test::leastJacobianOfFaces(result), leastJacobian);
}

/// The prism of height 1 over a polygon that runs round to the left.
PolyMesh prismOver(const std::vector<std::array<double, 2>>& base) {
    const Label n = toLabel(base.size());
    std::vector<Vec3> points;
    for (const double z : {0.0, 1.0})
        for (const auto& [x, y] : base)
            points.push_back({x, y, z});
    Polyhedron faces(2);
    for (Label i = 0; i < n; ++i) {
        faces[0].push_back(n - 1 - i);
        faces[1].push_back(n + i);
        faces.push_back({i, (i + 1) % n, (i + 1) % n + n, i + n});
    }
    return test::meshOf(points, {faces});
}

/// A triangular prism with its top turned; the sides are folded inwards (Schoenhardt's polyhedron
/// for a turn of 30 degrees, where no tetrahedron of its corners lies within).
PolyMesh twistedPrism(double degrees) {
    const double turn = degrees * std::numbers::pi / 180;
    std::vector<Vec3> points;
    for (int level = 0; level < 2; ++level)
        for (int i = 0; i < 3; ++i) {
            const double angle = 2 * std::numbers::pi * i / 3 + level * turn;
            points.push_back({std::cos(angle), std::sin(angle), 1.0 * level});
        }
    Polyhedron faces{{0, 2, 1}, {3, 4, 5}};
    for (Label i = 0; i < 3; ++i) {
        const Label next = (i + 1) % 3;
        faces.push_back({i, next, i + 3});
        faces.push_back({next, next + 3, i + 3});
    }
    return test::meshOf(points, {faces});
}

} // namespace

TEST(ConcaveCell, anLDivides) {
    dividesWell(prismOver({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}));
}

TEST(ConcaveCell, aCrossDivides) {
    dividesWell(prismOver({{1, 0},
                           {2, 0},
                           {2, 1},
                           {3, 1},
                           {3, 2},
                           {2, 2},
                           {2, 3},
                           {1, 3},
                           {1, 2},
                           {0, 2},
                           {0, 1},
                           {1, 1}}));
}

TEST(ConcaveCell, reflexEdgesThatMeetAtACornerDivide) {
    // A cube of side 2 without the cube of side 1 at its corner (2, 2, 2).
    const std::vector<Vec3> points{{0, 0, 0},
                                   {2, 0, 0},
                                   {2, 2, 0},
                                   {0, 2, 0},
                                   {0, 0, 2},
                                   {2, 0, 2},
                                   {0, 2, 2},
                                   {1, 1, 1},
                                   {2, 1, 1},
                                   {1, 2, 1},
                                   {2, 2, 1},
                                   {1, 1, 2},
                                   {2, 1, 2},
                                   {1, 2, 2}};
    dividesWell(test::meshOf(points,
                             {{{0, 3, 2, 1},
                               {0, 1, 5, 4},
                               {0, 4, 6, 3},
                               {4, 5, 12, 11, 13, 6},
                               {1, 2, 10, 8, 12, 5},
                               {2, 3, 6, 13, 9, 10},
                               {7, 8, 10, 9},
                               {7, 11, 12, 8},
                               {7, 9, 13, 11}}}));
}

TEST(ConcaveCell, twistedPrismsDivide) {
    for (const double degrees : {-5.0, -15.0, -25.0, 10.0, 20.0})
        dividesWell(twistedPrism(degrees));
}

} // namespace polymesh
