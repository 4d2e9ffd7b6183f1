// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/topology.h"

#include "tests/support/meshes.h"

#include <gtest/gtest.h>

namespace polymesh {
namespace {

TEST(CellFaces, listsOwnedFacesBeforeNeighbouredOnes) {
    const PolyMesh mesh = test::box(3, 1, 1);
    const Rows<Label> rows = cellFaces(mesh);
    ASSERT_EQ(rows.size(), 3);
    EXPECT_EQ(rows.rowSize(1), 6);
    EXPECT_EQ(rows[1].back(), 0);  // the face towards cell 0, which owns it
    EXPECT_EQ(rows[1].front(), 1); // the face towards cell 2
}

TEST(PointFaces, coversEveryCornerOfEveryFace) {
    const PolyMesh mesh = test::box(2, 2, 2);
    const Rows<Label> rows = pointFaces(mesh);
    EXPECT_EQ(rows.values.size(), mesh.faces.values.size());
    EXPECT_EQ(rows.rowSize(13), 12); // the middle point
    for (Label p = 0; p < rows.size(); ++p) {
        EXPECT_TRUE(std::is_sorted(rows[p].begin(), rows[p].end()));
        for (const Label f : rows[p])
            EXPECT_NE(std::count(mesh.faces[f].begin(), mesh.faces[f].end(), p), 0);
    }
}

TEST(PointCells, isTheInverseOfCellPoints) {
    const PolyMesh mesh = test::hangingNodes();
    const Rows<Label> points = cellPoints(mesh, cellFaces(mesh));
    const Rows<Label> cells = pointCells(mesh);
    EXPECT_EQ(points.values.size(), cells.values.size());
    EXPECT_EQ(points.rowSize(0), 8);
    EXPECT_EQ(points.rowSize(4), 13);
    for (Label c = 0; c < points.size(); ++c)
        for (const Label p : points[c])
            EXPECT_EQ(std::count(cells[p].begin(), cells[p].end(), c), 1);
}

TEST(Edges, ofABoxAreCounted) {
    const std::vector<Edge> list = edges(test::box(2, 3, 4));
    EXPECT_EQ(list.size(), 2U * 4 * 5 + 3U * 3 * 5 + 4U * 3 * 4);
    EXPECT_TRUE(std::is_sorted(list.begin(), list.end()));
    EXPECT_LT(list[0][0], list[0][1]);
}

TEST(CellRegions, countsPartsThatShareNoFace) {
    // Three cubes: the third touches the second along an edge only.
    PolyMesh grid = test::box(3, 2, 1);
    EXPECT_EQ(cellRegions(grid), std::vector<Label>(6, 0));
    const auto at = [](Label i, Label j, Label k) { return i + 4 * (j + 3 * k); };
    const auto hex = [&](Label i, Label j) {
        return test::hexahedron({at(i, j, 0),
                                 at(i + 1, j, 0),
                                 at(i + 1, j + 1, 0),
                                 at(i, j + 1, 0),
                                 at(i, j, 1),
                                 at(i + 1, j, 1),
                                 at(i + 1, j + 1, 1),
                                 at(i, j + 1, 1)});
    };
    const PolyMesh mesh = test::meshOf(grid.points, {hex(0, 0), hex(2, 1), hex(1, 0)});
    EXPECT_EQ(cellRegions(mesh), (std::vector<Label>{0, 1, 0}));
}

TEST(Topology, ofAnEmptyMeshIsEmpty) {
    EXPECT_TRUE(cellFaces({}).empty());
    EXPECT_TRUE(pointCells({}).empty());
    EXPECT_TRUE(edges({}).empty());
    EXPECT_TRUE(cellRegions({}).empty());
}

} // namespace
} // namespace polymesh
