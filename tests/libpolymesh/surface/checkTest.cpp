// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/check.h"

#include "libpolymesh/base/parallel.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

namespace polymesh {

namespace {

using Pairs = std::vector<std::array<Label, 2>>;

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

TEST(FindSelfIntersections, findsNoneInSurfacesThatOnlyTouchInSharedCorners) {
    EXPECT_EQ(findSelfIntersections(test::sphere(4), 5).count, 0);
    EXPECT_EQ(findSelfIntersections(test::cylinder(64), 5).count, 0);
    EXPECT_EQ(findSelfIntersections(TriSurface{}, 5).count, 0);
    const TriSurface cubes =
        test::join(test::cuboid({0, 0, 0}, {1, 1, 1}), test::cuboid({1, 1, 0}, {2, 2, 1}));
    EXPECT_EQ(findSelfIntersections(cubes, 5).count, 0);
}

/// A triangle in the plane z = 0 and another one.
SelfIntersections withFloor(const Vec3& a, const Vec3& b, const Vec3& c) {
    return findSelfIntersections(
        test::surfaceOf({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, a, b, c}, {{0, 1, 2}, {3, 4, 5}}), 9);
}

TEST(FindSelfIntersections, decidesEachKindOfContact) {
    EXPECT_EQ(withFloor({1, 1, -1}, {1, 1, 1}, {2, 1, 1}).first, (Pairs{{0, 1}})) << "through it";
    EXPECT_EQ(withFloor({1, 1, 0}, {1, 1, 1}, {2, 1, 1}).count, 1) << "a corner on it";
    EXPECT_EQ(withFloor({1, 1, 1e-300}, {1, 1, 1}, {2, 1, 1}).count, 0) << "a hair above it";
    EXPECT_EQ(withFloor({0, 0, 0}, {4, 0, 0}, {1, 1, 1}).count, 0) << "a shared side";
    EXPECT_EQ(withFloor({0, 0, 0}, {4, 0, 0}, {2, -3, 0}).count, 0) << "side by side in one plane";
    EXPECT_EQ(withFloor({0, 0, 0}, {4, 0, 0}, {1, 1, 0}).count, 1) << "folded onto it";
    EXPECT_EQ(withFloor({0, 0, 0}, {-1, 0, 1}, {0, -1, 1}).count, 0) << "a shared corner";
    EXPECT_EQ(withFloor({0, 0, 0}, {2, 2, 1}, {2, 2, -1}).count, 1) << "a shared corner and more";
    EXPECT_EQ(withFloor({0, 0, 0}, {2, 1, 0}, {1, 2, 0}).count, 1) << "in its plane, shared corner";
    EXPECT_EQ(withFloor({4, 0, 0}, {0, 4, 0}, {0, 0, 0}).count, 1) << "twice the same";
    EXPECT_EQ(withFloor({1, 1, -1}, {1, 1, 0}, {1, 1, 1}).count, 0) << "without area: passed over";
}

TEST(FindSelfIntersections, findsCrossingShellsAndListsAFewWhateverTheThreads) {
    const TriSurface spheres = test::join(test::sphere(4), test::sphere(4, 1, {0.5, 0.3, 0.2}));
    const SelfIntersections found = findSelfIntersections(spheres, 7);
    EXPECT_GT(found.count, 100);
    EXPECT_EQ(found.first.size(), 7U);
    EXPECT_TRUE(std::ranges::is_sorted(found.first));
    for (const auto& [s, t] : found.first) // of two convex shells no two triangles of one meet
        EXPECT_NE(s < 2048, t < 2048);
    const ThreadLimit limit(1);
    EXPECT_EQ(findSelfIntersections(spheres, 7).first, found.first);
}

} // namespace

} // namespace polymesh
