// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/distance.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/surface/boxTree.h"
#include "libpolymesh/surface/triangleBoxes.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace polymesh {

namespace {

/// Random points in and round the unit box.
class Points {
public:
    Vec3 next() { return {uniform_(random_), uniform_(random_), uniform_(random_)}; }

private:
    std::mt19937 random_{3};
    std::uniform_real_distribution<double> uniform_{-1.5, 1.5};
};

/// The least distance over a fine grid of points of the triangle: never less than the true one.
double sampledDistance(const std::array<Vec3, 3>& t, const Vec3& p) {
    constexpr int n = 200;
    double best = Box::inf;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; i + j <= n; ++j)
            best = std::min(
                best,
                norm(t[0] + (i / double{n}) * (t[1] - t[0]) + (j / double{n}) * (t[2] - t[0]) - p));
    return best;
}

TEST(ClosestPointOfTriangle, agreesWithSampling) {
    Points points;
    for (int i = 0; i < 50; ++i) {
        const std::array<Vec3, 3> t{points.next(), points.next(), points.next()};
        const Vec3 p = points.next();
        const double distance = norm(closestPoint(t, p) - p);
        const double sampled = sampledDistance(t, p);
        EXPECT_LE(distance, sampled + 1e-14);
        EXPECT_NEAR(distance, sampled, 0.03);
    }
}

TEST(ClosestPointOfTriangle, takesTrianglesWithoutArea) {
    EXPECT_EQ(closestPoint({Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{3, 0, 0}}, {2, 1, 0}),
              (Vec3{2, 0, 0}));
    EXPECT_EQ(closestPoint({Vec3{1, 1, 1}, Vec3{1, 1, 1}, Vec3{1, 1, 1}}, {2, 1, 0}),
              (Vec3{1, 1, 1}));
}

TEST(SurfaceTree, findsWhatTryingAllTrianglesFinds) {
    const TriSurface surface =
        test::join(test::sphere(3, 0.8), test::cuboid({-1, -1, -1}, {0, 0.1, 1}));
    const SurfaceTree tree(surface);
    Points points;
    for (int i = 0; i < 300; ++i) {
        const Vec3 p = points.next();
        double best = Box::inf;
        for (Label t = 0; t < surface.triangleCount(); ++t)
            best = std::min(
                best,
                norm(closestPoint(
                         {surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)}, p) -
                     p));
        const ClosestPoint found = tree.closest(p);
        EXPECT_EQ(found.distance, best);
        EXPECT_EQ(norm(found.point - p), best);
        const Label t = found.triangle;
        EXPECT_EQ(
            closestPoint({surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)}, p),
            found.point);
    }
}

TEST(SurfaceTree, isZeroOnTheSurface) {
    const TriSurface surface = test::sphere(2);
    const SurfaceTree tree(surface);
    for (const Vec3& p : surface.points)
        EXPECT_EQ(tree.closest(p).distance, 0);
}

TEST(SurfaceTree, refusesASurfaceWithoutTriangles) {
    EXPECT_THROW(SurfaceTree(TriSurface{}), InputError);
}

TEST(BoxTree, visitsAllBoxesThatOverlap) {
    Points points;
    for (int count : {0, 1, 4, 5, 100, 1000}) {
        std::vector<Box> boxes;
        for (int i = 0; i < count; ++i) {
            const Vec3 p = points.next();
            boxes.push_back({p, p + Vec3{0.1, 0.2, 0.3}});
        }
        const BoxTree tree(boxes);
        for (int query = 0; query < 20; ++query) {
            const Vec3 p = points.next();
            const Box box{p, p + Vec3{0.5, 0.5, 0.5}};
            std::multiset<Label> visited;
            tree.forEachNear(box, [&](Label item) { visited.insert(item); });
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                const auto times = visited.count(toLabel(i));
                EXPECT_LE(times, 1U);
                EXPECT_GE(times, overlaps(boxes[i], box) ? 1U : 0U);
            }
        }
    }
}

TEST(BoxTree, pairsAllBoxesThatOverlapOnce) {
    Points points;
    for (int count : {0, 1, 4, 5, 100, 3000}) {
        std::vector<Box> boxes;
        for (int i = 0; i < count; ++i) {
            const Vec3 p = points.next();
            boxes.push_back({p, p + Vec3{0.1, 0.02, 0.03}});
        }
        const BoxTree tree(boxes);
        std::map<std::set<Label>, int> visits;
        for (const auto& nodes : tree.nodePairs())
            tree.forEachPair(nodes, [&](Label i, Label j) { ++visits[{i, j}]; });
        for (const auto& [pair, times] : visits)
            ASSERT_EQ(times, 1);
        for (Label i = 0; i < count; ++i)
            for (Label j = 0; j < i; ++j)
                if (overlaps(boxes[index(i)], boxes[index(j)])) {
                    ASSERT_TRUE(visits.contains({i, j}));
                }
    }
}

} // namespace

} // namespace polymesh
