// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapes/obstacle.h"

#include "libpolymesh/mesh/topology.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

namespace polymesh::test {

namespace {

Obstacle obstacleOf(const Polyhedron& cell) {
    Label points = 0;
    for (const Polygon& loop : cell)
        points = std::max(points, *std::ranges::max_element(loop) + 1);
    std::vector<Vec3> positions;
    positions.reserve(index(points));
    for (Label p = 0; p < points; ++p) // where they are does not matter
        positions.push_back({1.0 * p, 0.5 * p * p, 0.1 * p * p * p});
    const PolyMesh mesh = meshOf(positions, {cell});
    return polymesh::obstacleOf(mesh, cellFaces(mesh)[0], 0);
}

const Polyhedron cube = hexahedron({0, 1, 2, 3, 4, 5, 6, 7});

/// Puts a point between two others.
Polyhedron withPointOnEdge(Polyhedron cell, Label a, Label b, Label point) {
    for (Polygon& loop : cell)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const std::pair<Label, Label> edge = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
            if (edge != std::pair<Label, Label>(std::minmax(a, b))) continue;
            loop.insert(loop.begin() + static_cast<long>(i) + 1, point);
            break;
        }
    return cell;
}

Polyhedron pyramidOn(Label corners) {
    Polyhedron cell(1);
    for (Label i = 0; i < corners; ++i) {
        cell[0].push_back(corners - 1 - i);
        cell.push_back({i, (i + 1) % corners, corners});
    }
    return cell;
}

TEST(Obstacle, areThePointsOnEdgesOfACellThatWouldBeAHexahedron) {
    EXPECT_EQ(obstacleOf(withPointOnEdge(cube, 0, 1, 8)), Obstacle::pointsOnEdges);
    EXPECT_EQ(obstacleOf(withPointOnEdge(withPointOnEdge(cube, 0, 1, 8), 1, 8, 9)),
              Obstacle::pointsOnEdges);
}

/// A unit cube whose top is four faces round a point at this height; the top is a patch.
PolyMesh roof(double height) {
    Polyhedron cell;
    for (const Polygon& loop : cube)
        if (std::set<Label>(loop.begin(), loop.end()) != std::set<Label>{4, 5, 6, 7})
            cell.push_back(loop);
    for (const auto& [a, b, p] : {std::array<Label, 3>{4, 5, 8}, {5, 6, 9}, {6, 7, 10}, {7, 4, 11}})
        cell = withPointOnEdge(cell, a, b, p);
    for (const auto& quad : {Polygon{4, 8, 12, 11}, {8, 5, 9, 12}, {12, 9, 6, 10}, {11, 12, 10, 7}})
        cell.push_back(quad);
    std::vector<Vec3> points;
    for (const double z : {0.0, 1.0})
        points.insert(points.end(), {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}});
    points.insert(points.end(), {{0.5, 0, 1}, {1, 0.5, 1}, {0.5, 1, 1}, {0, 0.5, 1}});
    points.push_back({0.5, 0.5, height});
    return meshOf(points, {cell}, [](const Vec3& c) { return c.z > 0.9 ? "top" : "walls"; });
}

TEST(Obstacle, areCreasesWhereAFaceOnOnePatchIsInPieces) {
    for (const auto& [height, obstacle] :
         {std::pair{1.2, Obstacle::creases}, std::pair{5.0, Obstacle::manyFaces}}) {
        const PolyMesh mesh = roof(height);
        EXPECT_EQ(polymesh::obstacleOf(mesh, cellFaces(mesh)[0], 0), obstacle) << height;
    }
}

TEST(Obstacle, isWhatThereIsTooMuchOf) {
    const PolyMesh hanging = hangingNodes();
    EXPECT_EQ(polymesh::obstacleOf(hanging, cellFaces(hanging)[4], 4), Obstacle::manyFaces);
    EXPECT_EQ(obstacleOf(pyramidOn(8)), Obstacle::manyFaces);
    EXPECT_EQ(obstacleOf(pyramidOn(7)), Obstacle::largeFace);
}

TEST(Obstacle, isTheGraphOfATruncatedTetrahedron) {
    const auto point = [](Label corner, Label towards) { return 4 * corner + towards; };
    Polyhedron cell;
    std::array<std::map<Label, Label>, 4> round; // corner: the darts of its triangle
    for (const auto& [i, j, k] : {std::array<Label, 3>{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}) {
        cell.push_back(
            {point(i, j), point(j, i), point(j, k), point(k, j), point(k, i), point(i, k)});
        round[index(i)][point(i, j)] = point(i, k);
        round[index(j)][point(j, k)] = point(j, i);
        round[index(k)][point(k, i)] = point(k, j);
    }
    for (auto& next : round) {
        const Label a = next.begin()->first;
        cell.push_back({a, next[a], next[next[a]]});
    }
    EXPECT_EQ(obstacleOf(cell), Obstacle::otherGraph);
}

TEST(Obstacle, isCountedForEachCell) {
    const PolyMesh mesh = hangingNodes();
    const std::array<Label, 1> cells{4};
    const auto counts = countObstacles(mesh, cellFaces(mesh), cells);
    EXPECT_EQ(counts[static_cast<std::size_t>(Obstacle::manyFaces)], 1);
    EXPECT_EQ(nameOf(Obstacle::manyFaces), "manyFaces");
}

} // namespace

} // namespace polymesh::test
