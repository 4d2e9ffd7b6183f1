// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/threadLimit.h"
#include "libpolymesh/surface/check.h"
#include "libpolymesh/surface/coplanar.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <random>
#include <set>

namespace polymesh {

namespace {

using Pairs = std::vector<std::array<Label, 2>>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

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

Kernel::Point_3 toCgal(const Vec3& p) {
    return {p.x, p.y, p.z};
}

/// CGAL's word on two triangles that share the first corner of each and no other.
bool meetBeyondFirst(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t) {
    const auto crosses = [](const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
        return CGAL::do_intersect(Kernel::Segment_3(toCgal(a[1]), toCgal(a[2])),
                                  Kernel::Triangle_3(toCgal(b[0]), toCgal(b[1]), toCgal(b[2])));
    };
    return crosses(s, t) || crosses(t, s);
}

TEST(FindSelfIntersections, agreesWithCgalOnTrianglesThatShareACorner) {
    std::mt19937 random(7);
    const auto next = [&] { // few places: coplanar, collinear and touching cases abound
        return Vec3{static_cast<double>(random() % 5),
                    static_cast<double>(random() % 5),
                    static_cast<double>(random() % 3)};
    };
    int meeting = 0;
    int clear = 0;
    while (meeting + clear < 20000) {
        const std::array<Vec3, 3> s{next(), next(), next()};
        const std::array<Vec3, 3> t{s[0], next(), next()};
        const std::set<Vec3> places{s[0], s[1], s[2], t[1], t[2]};
        if (places.size() < 5 || areCollinear(s[0], s[1], s[2]) || areCollinear(t[0], t[1], t[2]))
            continue;
        const TriSurface pair =
            test::surfaceOf({s[0], s[1], s[2], t[1], t[2]}, {{0, 1, 2}, {0, 3, 4}});
        const bool expected = meetBeyondFirst(s, t);
        ASSERT_EQ(findSelfIntersections(pair, 0).count, expected ? 1 : 0);
        ++(expected ? meeting : clear);
    }
    EXPECT_GT(meeting, 1000);
    EXPECT_GT(clear, 1000);
}

} // namespace

} // namespace polymesh
