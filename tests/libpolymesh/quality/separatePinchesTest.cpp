// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/separatePinches.h"

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/validateEdit.h"
#include "tests/libpolymesh/quality/editMeshes.h"

#include <gtest/gtest.h>

namespace polymesh::test {
namespace {

std::vector<Label> cellsLeft(const EditMesh& mesh) {
    std::vector<Label> found;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        if (!mesh.cells[c].isRemoved()) found.push_back(toLabel(c));
    return found;
}

/// A table with two legs that touch along an edge, as one cell; where `isFilled`, another cell is
/// between the legs on one side of the edge.
EditMesh pinchedCell(bool isFilled) {
    EditMesh mesh = boxOfHexes({2, 2, 2}, 0.5);
    const auto isFilling = [&](const Vec3& p) {
        return isFilled && p.z < 0.5 && p.x < 0.5 && p.y > 0.5;
    };
    removeCells(mesh, 6, [&](const Vec3& p) {
        return p.z < 0.5 && (p.x < 0.5) != (p.y < 0.5) && !isFilling(p);
    });
    const Label whole = cellsLeft(mesh).front();
    MeshEditor editor(mesh);
    for (const Label c : cellsLeft(mesh)) {
        if (isFilling(editor.cellGeometry(c).centre)) continue;
        const auto faces = editor.cell(c).faces; // a copy: the list changes
        for (const Label f : faces)
            if (c != whole && editor.otherCell(f, c) == whole)
                editor.removeFace(f);
            else if (c != whole)
                editor.giveFace(f, c, whole);
    }
    return mesh;
}

TEST(SeparatePinches, closesACellThatTouchesItselfAlongAnEdge) {
    EditMesh mesh = pinchedCell(false);
    ASSERT_EQ(liveCells(mesh), 1);
    ASSERT_EQ(cellShape(mesh, cellsLeft(mesh).front()), CellShape::broken);
    const double volume = totalVolume(mesh);
    const std::size_t points = mesh.points.size();
    MeshEditor editor(mesh);
    EXPECT_EQ(separatePinches(editor), 0);
    EXPECT_EQ(mesh.points.size(), points + 1);
    EXPECT_NE(cellShape(mesh, cellsLeft(mesh).front()), CellShape::broken);
    EXPECT_EQ(totalVolume(mesh), volume);
    EXPECT_EQ(validateEdit(mesh), std::vector<std::string>{});
}

TEST(SeparatePinches, leavesWedgesThatHangTogetherThroughAnotherCell) {
    EditMesh mesh = pinchedCell(true);
    ASSERT_EQ(liveCells(mesh), 2);
    const std::size_t points = mesh.points.size();
    MeshEditor editor(mesh);
    const MeshEditor::Mark before = editor.mark();
    EXPECT_EQ(separatePinches(editor), 1);
    EXPECT_EQ(mesh.points.size(), points);
    EXPECT_TRUE(editor.reshapedSince(before).empty());
}

TEST(SeparatePinches, changesNothingElse) {
    EditMesh mesh = boxOfHexes({3, 2, 2}, 1);
    MeshEditor editor(mesh);
    const MeshEditor::Mark before = editor.mark();
    EXPECT_EQ(separatePinches(editor), 0);
    EXPECT_TRUE(editor.reshapedSince(before).empty());
}

TEST(SeparatePinches, countsACellThatIsOpen) {
    EditMesh mesh = boxOfHexes({1, 1, 1}, 1);
    MeshEditor editor(mesh);
    editor.removeFace(0);
    EXPECT_EQ(separatePinches(editor), 1);
}

} // namespace
} // namespace polymesh::test
