// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapes/classify.h"

#include "libpolymesh/base/threadLimit.h"
#include "libpolymesh/mesh/topology.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

namespace polymesh::test {

namespace {

TEST(ClassifyCells, countsEveryCellOnce) {
    const PolyMesh mesh = box(7, 5, 3);
    const ShapeCensus counted = census(classifyCells(mesh, cellFaces(mesh)));
    ASSERT_EQ(counted.counts.size(), 1U);
    EXPECT_EQ(nameOf(counted.counts[0].first), "hexahedron");
    EXPECT_EQ(counted.counts[0].second, 105);
    EXPECT_EQ(counted.unrecognised, 0);
}

TEST(ClassifyCells, knowsWhatIsNoShape) {
    // An L of eight faces has the graph of a hexagonal prism; a prism on seven points is none.
    const PolyMesh l = lShapedCell();
    EXPECT_EQ(nameOf(classifyCells(l, cellFaces(l))[0]), "hexagonalPrism");
    std::vector<Vec3> points;
    Polyhedron cell(2);
    for (Label i = 0; i < 7; ++i) {
        const double angle = 0.9 * i;
        points.push_back({std::cos(angle), std::sin(angle), 0});
        points.push_back({std::cos(angle), std::sin(angle), 1});
        cell[0].insert(cell[0].begin(), 2 * i);
        cell[1].push_back(2 * i + 1);
        const Label next = (i + 1) % 7;
        cell.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    }
    const PolyMesh mesh = meshOf(points, {cell});
    EXPECT_EQ(census(classifyCells(mesh, cellFaces(mesh))).unrecognised, 1);
}

TEST(ClassifyCells, doesNotDependOnThreads) {
    const PolyMesh mesh = jittered(box(12, 11, 10), 0.01);
    const Rows<Label> faces = cellFaces(mesh);
    const ThreadLimit one(1);
    const std::vector<CellShape> alone = classifyCells(mesh, faces);
    {
        const ThreadLimit four(4);
        EXPECT_EQ(classifyCells(mesh, faces), alone);
    }
}

} // namespace

} // namespace polymesh::test
