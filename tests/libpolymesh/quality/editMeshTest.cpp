// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/editMesh.h"

#include "tests/libpolymesh/quality/editMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polymesh::test {

namespace {

TEST(EditMesh, listsTheFacesOfCellsByOwnersAndNeighbours) {
    EditMesh mesh = boxOfHexes({7, 5, 3}, 1);
    const EditMesh expected = mesh;
    for (EditCell& cell : mesh.cells)
        cell.faces.clear();
    listFacesOfCells(mesh);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        auto faces = expected.cells[c].faces;
        std::ranges::sort(faces);
        EXPECT_TRUE(std::ranges::equal(mesh.cells[c].faces, faces)) << "cell " << c;
    }
}

TEST(EditMesh, removedFacesBelongToNoCell) {
    EditMesh mesh = boxOfHexes({2, 1, 1}, 1);
    for (EditFace& face : mesh.faces)
        if (face.neighbour >= 0) face.owner = -1;
    listFacesOfCells(mesh);
    EXPECT_EQ(mesh.cells[0].faces.size(), 5U);
    EXPECT_EQ(mesh.cells[1].faces.size(), 5U);
}

} // namespace

} // namespace polymesh::test
