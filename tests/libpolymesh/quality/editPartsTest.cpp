// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/editParts.h"

#include "editMeshes.h"
#include "libpolymesh/base/threadLimit.h"
#include "libpolymesh/quality/collapseEdges.h"
#include "libpolymesh/quality/mergeCells.h"
#include "libpolymesh/quality/splitConcaveCells.h"
#include "libpolymesh/quality/validateEdit.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polymesh {

namespace {

using Defects = std::vector<std::string>;

/// A long box cut by an oblique plane: cells of all sizes along its whole length.
EditMesh cutBox(bool keepsBothSides) {
    EditMesh mesh = test::boxOfHexes({24, 6, 6}, 1.0);
    if (keepsBothSides) {
        test::splitByPlane(mesh, {0.13, 0.31, 1}, 5.011);
        test::rankPoints(mesh);
    } else {
        test::cutByPlane(mesh, {0.13, 0.31, 1}, 5.011, 6);
    }
    return mesh;
}

std::vector<Label> tidy(EditMesh& mesh, Label) {
    MeshEditor editor(mesh);
    collapseShortEdges(editor, 0.1);
    mergeSmallCells(editor, 0.3);
    splitConcaveCells(editor, 0.1);
    return {};
}

bool isEqual(const EditMesh& a, const EditMesh& b) {
    const auto sameFace = [](const EditFace& f, const EditFace& g) {
        return f.points == g.points && f.owner == g.owner && f.neighbour == g.neighbour &&
               f.patch == g.patch;
    };
    const auto sameCell = [](const EditCell& c, const EditCell& d) { return c.faces == d.faces; };
    return a.points == b.points && a.ranks == b.ranks &&
           std::ranges::equal(a.faces, b.faces, sameFace) &&
           std::ranges::equal(a.cells, b.cells, sameCell);
}

TEST(EditParts, slabsLieAcrossTheLongestSideAndAreEqual) {
    const CellParts parts = divideIntoSlabs(test::boxOfHexes({4, 12, 4}, 1.0), 48);
    ASSERT_EQ(parts.count, 4);
    for (Label c = 0; c < 192; ++c)
        EXPECT_EQ(parts.ofCell[index(c)], (c / 4) % 12 / 3) << c;
}

TEST(EditParts, frozenAndRemovedCellsBelongToNoSlab) {
    EditMesh mesh = test::boxOfHexes({12, 2, 2}, 1.0);
    mesh.cells[0].frozen = true;
    const CellParts parts = divideIntoSlabs(mesh, 10);
    EXPECT_EQ(parts.count, 4);
    EXPECT_EQ(parts.ofCell[0], -1);
    EXPECT_EQ(std::ranges::count(parts.ofCell, -1), 1);
}

TEST(EditParts, seamsAreSomeLayersThick) {
    const EditMesh mesh = test::boxOfHexes({24, 2, 2}, 1.0);
    const CellParts slabs = divideIntoSlabs(mesh, 48);
    ASSERT_EQ(slabs.count, 2);
    const CellParts seams = alongSeams(mesh, slabs);
    EXPECT_EQ(seams.count, 1);
    for (Label c = 0; c < 96; ++c) {
        const Label layer = c % 24;
        EXPECT_EQ(seams.ofCell[index(c)], layer >= 9 && layer < 15 ? 0 : -1) << c;
    }
}

TEST(EditParts, wholeStaysSoundWhateverThePartsDo) {
    for (const bool keepsBothSides : {false, true}) {
        EditMesh mesh = cutBox(keepsBothSides);
        const double volume = test::totalVolume(mesh);
        const Label cellsBefore = test::liveCells(mesh);
        CellParts slabs = divideIntoSlabs(mesh, 100);
        ASSERT_GT(slabs.count, 3);
        editParts(mesh, slabs, tidy);
        EXPECT_EQ(validateEdit(mesh), Defects());
        const Label cellsBetween = test::liveCells(mesh);
        EXPECT_LT(cellsBetween, cellsBefore);
        ASSERT_EQ(slabs.ofCell.size(), mesh.cells.size());
        CellParts seams = alongSeams(mesh, slabs);
        editParts(mesh, seams, tidy);
        EXPECT_EQ(validateEdit(mesh), Defects());
        EXPECT_LT(test::liveCells(mesh), cellsBetween) << "nothing was left to do at the seams";
        EXPECT_NEAR(test::totalVolume(mesh), volume, 0.002 * volume);
    }
}

TEST(EditParts, resultDoesNotDependOnTheNumberOfThreads) {
    std::vector<EditMesh> results;
    for (const std::size_t threads : {1U, 2U, 8U}) {
        const ThreadLimit limit(threads);
        results.push_back(cutBox(true));
        CellParts slabs = divideIntoSlabs(results.back(), 100);
        editParts(results.back(), slabs, tidy);
    }
    EXPECT_TRUE(isEqual(results[0], results[1]));
    EXPECT_TRUE(isEqual(results[0], results[2]));
}

TEST(EditParts, notedCellsHaveTheLabelsOfTheWhole) {
    EditMesh mesh = test::boxOfHexes({12, 2, 2}, 1.0);
    CellParts slabs = divideIntoSlabs(mesh, 12);
    ASSERT_EQ(slabs.count, 4);
    const auto first = [](const EditMesh&, Label) { return std::vector<Label>{0}; };
    EXPECT_EQ(editParts(mesh, slabs, first), (std::vector<Label>{0, 3, 6, 9}));
}

/// Removes cell 0; what it leaves bare of its neighbours gets patch 7.
void removeFirstCell(EditMesh& mesh) {
    MeshEditor editor(mesh);
    const auto faces = editor.cell(0).faces; // a copy: the list changes
    for (const Label f : faces) {
        EditFace face = editor.face(f);
        const Label other = editor.otherCell(f, 0);
        if (other < 0) {
            editor.removeFace(f);
            continue;
        }
        if (face.owner == 0) std::reverse(face.points.begin(), face.points.end());
        face.owner = other;
        face.neighbour = -1;
        face.patch = 7;
        editor.replaceFace(f, face);
    }
}

TEST(EditParts, cellThatVanishesAtASeamLeavesTheBoundaryToItsNeighbour) {
    EditMesh mesh = test::boxOfHexes({2, 1, 1}, 1.0);
    CellParts parts{{0, 1}, 2};
    const auto vanish = [](EditMesh& own, Label part) {
        if (part == 0) removeFirstCell(own);
        return std::vector<Label>{};
    };
    editParts(mesh, parts, vanish);
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(test::liveCells(mesh), 1);
    EXPECT_EQ(test::liveFaces(mesh), 6);
    EXPECT_DOUBLE_EQ(test::totalVolume(mesh), 1.0);
}

} // namespace

} // namespace polymesh
