// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/features.h"

#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

namespace polymesh {

namespace {

constexpr double degree = std::numbers::pi / 180;

struct Counts {
    std::ptrdiff_t edges;
    std::ptrdiff_t corners;

    bool operator==(const Counts&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Counts& counts) {
    return out << counts.edges << " edges, " << counts.corners << " corners";
}

Counts countFeatures(const TriSurface& surface, double angle) {
    const SurfaceFeatures features = findFeatures(surface, pairEdges(surface), angle);
    return {std::ranges::count(features.isFeature, 1), std::ranges::count(features.isCorner, 1)};
}

TEST(FindFeatures, findsTwelveEdgesAndEightCornersOfACube) {
    EXPECT_EQ(countFeatures(test::cuboid(), 30 * degree), (Counts{12, 8}));
    EXPECT_EQ(countFeatures(test::cuboid(), 89 * degree), (Counts{12, 8}));
    EXPECT_EQ(countFeatures(test::cuboid(), 91 * degree), (Counts{0, 0}));
}

TEST(FindFeatures, findsTheRimsOfACylinderAndNoCorners) {
    EXPECT_EQ(countFeatures(test::cylinder(36), 30 * degree), (Counts{72, 0}));
    // Below 10 degrees the sides between the facets are features too, and every point a corner.
    EXPECT_EQ(countFeatures(test::cylinder(36), 9 * degree), (Counts{108, 72}));
}

TEST(FindFeatures, findsTheCornersWhereASingleCurveTurns) {
    TriSurface surface = test::cuboid();
    surface.regionNames.push_back("lid");
    surface.region[10] = surface.region[11] = 1;
    // At 100 degrees only the border of the lid is left: four sides that turn by 90 degrees.
    EXPECT_EQ(countFeatures(surface, 100 * degree), (Counts{4, 0}));
    EXPECT_EQ(countFeatures(surface, 80 * degree), (Counts{12, 8}));
}

TEST(FindFeatures, takesRegionBordersInAPlane) {
    TriSurface surface = test::cuboid();
    surface.regionNames.push_back("half");
    surface.region[10] = 1; // one of the lid's two triangles
    EXPECT_EQ(countFeatures(surface, 30 * degree), (Counts{13, 8}));
}

TEST(FindFeatures, seesThroughTrianglesWithoutArea) {
    // The middle of a cube's edge stands in one of its two faces only; a needle closes the gap.
    TriSurface surface = test::cuboid();
    const SurfaceEdges edges = pairEdges(surface);
    const SurfaceEdge edge = *std::ranges::find_if(
        edges.edges, [&](const SurfaceEdge& e) { return !isExactlyFlat(surface, e); });
    auto& left = surface.triangles[index(edge.left)];
    const Label apex =
        *std::ranges::find_if(left, [&](Label p) { return p != edge.start && p != edge.end; });
    const Label middle = surface.pointCount();
    surface.points.push_back(0.5 *
                             (surface.points[index(edge.start)] + surface.points[index(edge.end)]));
    left = {edge.start, middle, apex};
    surface.triangles.push_back({middle, edge.end, apex});
    surface.triangles.push_back({edge.start, edge.end, middle});
    surface.region.insert(surface.region.end(), 2, 0);
    const SurfaceFeatures features = findFeatures(surface, pairEdges(surface), 30 * degree);
    // The needle is seen as a part of one face: either its long side or its two short ones are
    // sharp.
    EXPECT_EQ(std::ranges::count(features.isFeature, 1), 13);
    EXPECT_EQ(std::ranges::count(features.isCorner, 1), 8);
    EXPECT_EQ(features.isCorner.back(), 0);
}

TEST(FindFeatures, countsAnEdgeOfFourTrianglesOnce) {
    const TriSurface cubes =
        test::join(test::cuboid({0, 0, 0}, {1, 1, 1}), test::cuboid({1, 1, 0}, {2, 2, 1}));
    EXPECT_EQ(countFeatures(cubes, 30 * degree), (Counts{24, 14}));
}

TEST(IsExactlyFlat, isTrueForTheDiagonalsOfACubeOnly) {
    const TriSurface surface = test::cuboid();
    const SurfaceEdges edges = pairEdges(surface);
    EXPECT_EQ(
        std::ranges::count_if(
            edges.edges, [&](const SurfaceEdge& edge) { return isExactlyFlat(surface, edge); }),
        6);
}

TEST(IsExactlyFlat, isFalseForAFoldAndForTheLeastBend) {
    const auto isFlat = [](const Vec3& apex) {
        const TriSurface surface =
            test::surfaceOf({{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0}, apex}, {{0, 1, 2}, {1, 0, 3}});
        return isExactlyFlat(surface, {0, 1, 0, 1});
    };
    EXPECT_TRUE(isFlat({0.7, -1, 0}));
    EXPECT_FALSE(isFlat({0.7, -1, 1e-300}));
    EXPECT_FALSE(isFlat({0.7, 1, 0}));
    EXPECT_FALSE(isFlat({0.5, 0, 0}));
}

} // namespace

} // namespace polymesh
