// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/edges.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/threadLimit.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <set>

namespace polymesh {

namespace {

bool usesSide(const TriSurface& surface, Label t, Label from, Label to) {
    const auto& corners = surface.triangles[index(t)];
    for (std::size_t i = 0; i < 3; ++i)
        if (corners[i] == from && corners[(i + 1) % 3] == to) return true;
    return false;
}

/// The laws of SurfaceEdges.
void expectPaired(const TriSurface& surface, const SurfaceEdges& edges) {
    ASSERT_EQ(2 * edges.edges.size(), 3 * surface.triangles.size());
    for (const SurfaceEdge& edge : edges.edges) {
        EXPECT_LT(edge.start, edge.end);
        EXPECT_TRUE(usesSide(surface, edge.left, edge.start, edge.end));
        EXPECT_TRUE(usesSide(surface, edge.right, edge.end, edge.start));
    }
    std::vector<int> uses(edges.edges.size(), 0);
    for (Label t = 0; t < surface.triangleCount(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const Label e = edges.ofTriangle[index(t)][i];
            const SurfaceEdge& edge = edges.edges[index(e)];
            ++uses[index(e)];
            const std::set<Label> ends{surface.triangles[index(t)][i],
                                       surface.triangles[index(t)][(i + 1) % 3]};
            EXPECT_EQ(ends, (std::set<Label>{edge.start, edge.end}));
            EXPECT_TRUE(edge.left == t || edge.right == t);
        }
    EXPECT_EQ(std::ranges::count(uses, 2), toLabel(uses.size()));
}

/// The triangles of a surface joined from two: each side of an edge belongs to the same one.
void expectNoEdgeJoins(const SurfaceEdges& edges, Label firstOfSecond) {
    for (const SurfaceEdge& edge : edges.edges)
        EXPECT_EQ(edge.left < firstOfSecond, edge.right < firstOfSecond)
            << "triangles " << edge.left << " and " << edge.right;
}

TEST(PairEdges, pairsTheSidesOfClosedSurfaces) {
    for (const TriSurface& surface :
         {test::cuboid(), test::sphere(3), test::cylinder(400), test::shuffled(test::sphere(3))})
        expectPaired(surface, pairEdges(surface));
}

TEST(PairEdges, takesAnEmptySurface) {
    EXPECT_EQ(pairEdges(TriSurface{}), SurfaceEdges{});
}

TEST(PairEdges, keepsTwoCubesApartThatShareAnEdge) {
    const TriSurface cubes =
        test::join(test::cuboid({0, 0, 0}, {1, 1, 1}), test::cuboid({1, 1, 0}, {2, 2, 1}));
    ASSERT_EQ(cubes.pointCount(), 14);
    const SurfaceEdges edges = pairEdges(cubes);
    expectPaired(cubes, edges);
    expectNoEdgeJoins(edges, 12);
}

TEST(PairEdges, joinsTheWallsOfACavityThatTouchesTheOutsideAlongAnEdge) {
    // The solid is what two inward cubes leave of the space round them: there the interior between
    // neighbours lies outside the cubes, so that each pair joins one with the other.
    const TriSurface cubes = test::inverted(
        test::join(test::cuboid({0, 0, 0}, {1, 1, 1}), test::cuboid({1, 1, 0}, {2, 2, 1})));
    const SurfaceEdges edges = pairEdges(cubes);
    expectPaired(cubes, edges);
    int joins = 0;
    for (const SurfaceEdge& edge : edges.edges)
        joins += (edge.left < 12) != (edge.right < 12) ? 1 : 0;
    EXPECT_EQ(joins, 2);
}

TEST(PairEdges, keepsCubesApartThatShareAFace) {
    const TriSurface cubes =
        test::join(test::cuboid({0, 0, 0}, {1, 1, 1}), test::cuboid({1, 0, 0}, {2, 1, 1}));
    ASSERT_EQ(cubes.pointCount(), 12);
    const SurfaceEdges edges = pairEdges(cubes);
    expectPaired(cubes, edges);
    expectNoEdgeJoins(edges, 12);
}

TEST(PairEdges, keepsManyWedgesRoundOneEdgeApart) {
    // Tetrahedra like the leaves of a book, all on the edge from (0 0 0) to (0 0 1).
    TriSurface book;
    for (Label leaf = 0; leaf < 7; ++leaf) {
        const double from = 0.9 * static_cast<double>(leaf);
        const double to = from + 0.6;
        book = test::join(book,
                          test::surfaceOf({{0, 0, 0},
                                           {0, 0, 1},
                                           {std::cos(from), std::sin(from), 0},
                                           {std::cos(to), std::sin(to), 0.5}},
                                          {{2, 1, 0}, {3, 0, 1}, {3, 2, 0}, {3, 1, 2}}));
    }
    const TriSurface given = book;
    for (unsigned seed = 0; seed < 5; ++seed) {
        const TriSurface surface = seed == 0 ? given : test::shuffled(given, seed);
        const SurfaceEdges edges = pairEdges(surface);
        expectPaired(surface, edges);
        for (const SurfaceEdge& edge : edges.edges) {
            std::set<Label> points(surface.triangles[index(edge.left)].begin(),
                                   surface.triangles[index(edge.left)].end());
            points.insert(surface.triangles[index(edge.right)].begin(),
                          surface.triangles[index(edge.right)].end());
            // Four points in all: two sides of one tetrahedron, the only one that has them all.
            EXPECT_EQ(points.size(), 4U);
            std::size_t holders = 0;
            for (const auto& corners : surface.triangles)
                holders +=
                    std::ranges::all_of(corners, [&](Label p) { return points.contains(p); });
            EXPECT_EQ(holders, 4U);
        }
    }
}

TEST(PairEdges, takesTrianglesWithoutAreaAtAnEdgeOfFour) {
    // The second cube's lid is divided at the middle of the shared edge, which a needle fills.
    TriSurface cubes =
        test::join(test::cuboid({0, 0, 0}, {1, 1, 1}), test::cuboid({1, 1, 0}, {2, 2, 1}));
    const SurfaceEdges before = pairEdges(cubes);
    const SurfaceEdge shared = *std::ranges::find_if(before.edges, [&](const SurfaceEdge& edge) {
        const Vec3& a = cubes.points[index(edge.start)];
        const Vec3& b = cubes.points[index(edge.end)];
        return a.x == 1 && a.y == 1 && b.x == 1 && b.y == 1;
    });
    const Label middle = cubes.pointCount();
    cubes.points.push_back(0.5 *
                           (cubes.points[index(shared.start)] + cubes.points[index(shared.end)]));
    auto& left = cubes.triangles[index(shared.left)];
    const Label apex =
        *std::ranges::find_if(left, [&](Label p) { return p != shared.start && p != shared.end; });
    left = {shared.start, middle, apex};
    cubes.triangles.push_back({middle, shared.end, apex});
    cubes.triangles.push_back({shared.start, shared.end, middle});
    cubes.region.insert(cubes.region.end(), 2, 0);
    expectPaired(cubes, pairEdges(cubes));
}

TEST(PairEdges, doesNotDependOnTheNumberOfThreads) {
    const TriSurface surface = test::shuffled(test::sphere(5));
    const SurfaceEdges edges = pairEdges(surface);
    const ThreadLimit limit(1);
    EXPECT_EQ(pairEdges(surface), edges);
}

TEST(PairEdges, saysWhereASurfaceIsOpen) {
    const TriSurface open = test::without(test::cuboid(), 0);
    try {
        pairEdges(open);
        FAIL() << "took an open surface";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("3 open"), std::string::npos) << error.what();
    }
}

TEST(OpenEdges, findsTheRimOfACubeWithoutALid) {
    const TriSurface surface = test::without(test::without(test::cuboid(), 11), 10);
    const auto open = openEdges(surface);
    ASSERT_EQ(open.size(), 4U);
    for (const auto& [start, end] : open) {
        EXPECT_EQ(surface.points[index(start)].z, 1);
        EXPECT_EQ(surface.points[index(end)].z, 1);
        EXPECT_EQ(std::ranges::count_if(surface.triangles,
                                        [&, from = start, to = end](const auto& corners) {
                                            for (std::size_t i = 0; i < 3; ++i)
                                                if (corners[i] == from &&
                                                    corners[(i + 1) % 3] == to)
                                                    return true;
                                            return false;
                                        }),
                  1);
    }
}

TEST(OpenEdges, findsTheSidesOfATurnedTriangle) {
    TriSurface surface = test::cuboid();
    EXPECT_TRUE(openEdges(surface).empty());
    test::turn(surface, 5);
    EXPECT_EQ(openEdges(surface).size(), 6U); // each of three sides is used twice one way
}

} // namespace

} // namespace polymesh
