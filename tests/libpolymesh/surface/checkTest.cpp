// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/check.h"

#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

namespace polymesh {

namespace {

TEST(CheckSurface, findsNothingWrongWithASphere) {
    const SurfaceDefects defects = checkSurface(test::sphere(3));
    EXPECT_TRUE(defects.isClosed());
    EXPECT_EQ(defects.nonManifoldEdges.count, 0);
    EXPECT_EQ(defects.duplicateTriangles.count, 0);
    EXPECT_EQ(defects.zeroAreaTriangles.count, 0);
}

TEST(CheckSurface, countsTheOpenEdgesAndLocatesTheFirst) {
    const SurfaceDefects defects =
        checkSurface(test::without(test::without(test::cuboid(), 11), 10));
    EXPECT_FALSE(defects.isClosed());
    EXPECT_EQ(defects.openEdges.count, 4);
    EXPECT_EQ(defects.openEdges.first.z, 1);
    EXPECT_EQ(defects.misorientedEdges.count, 0);
}

TEST(CheckSurface, tellsATurnedTriangleFromAGap) {
    TriSurface surface = test::cuboid();
    test::turn(surface, 0);
    const SurfaceDefects defects = checkSurface(surface);
    EXPECT_FALSE(defects.isClosed());
    EXPECT_EQ(defects.openEdges.count, 0);
    EXPECT_EQ(defects.misorientedEdges.count, 3);
}

TEST(CheckSurface, countsEdgesOfMoreThanTwoTriangles) {
    const SurfaceDefects defects = checkSurface(
        test::join(test::cuboid({0, 0, 0}, {1, 1, 1}), test::cuboid({1, 1, 0}, {2, 2, 1})));
    EXPECT_TRUE(defects.isClosed());
    EXPECT_EQ(defects.nonManifoldEdges.count, 1);
    EXPECT_EQ(defects.nonManifoldEdges.first, (Vec3{1, 1, 0.5}));
}

TEST(CheckSurface, findsDuplicatesWhateverTheOrderOfTheirCorners) {
    TriSurface surface = test::cuboid();
    const auto corners = surface.triangles[4];
    surface.triangles.push_back({corners[2], corners[1], corners[0]});
    surface.triangles.push_back({corners[1], corners[2], corners[0]});
    surface.region.insert(surface.region.end(), 2, 0);
    EXPECT_EQ(checkSurface(surface).duplicateTriangles.count, 2);
}

TEST(CheckSurface, findsTrianglesWithoutAreaExactly) {
    const TriSurface flat =
        test::surfaceOf({{0, 0, 0}, {0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}}, {{0, 1, 2}});
    EXPECT_EQ(checkSurface(flat).zeroAreaTriangles.count, 1);
    const TriSurface thin =
        test::surfaceOf({{0, 0, 0}, {0.1, 0.1, 0.1}, {0.3, 0.3, 0.30000000000000004}}, {{0, 1, 2}});
    EXPECT_EQ(checkSurface(thin).zeroAreaTriangles.count, 0);
}

} // namespace

} // namespace polymesh
