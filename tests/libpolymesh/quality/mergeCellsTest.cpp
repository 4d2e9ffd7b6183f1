// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/mergeCells.h"

#include "editMeshes.h"
#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/mergeFaces.h"
#include "libpolymesh/quality/validateEdit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace polymesh {

namespace {

using Defects = std::vector<std::string>;

TEST(MergeCells, undoesACutExactly) {
    EditMesh mesh = test::boxOfHexes({2, 2, 2}, 1.0);
    const Label cut = test::splitByPlane(mesh, {1, 2, 3}, 2.9);
    ASSERT_GT(cut, 2);
    ASSERT_EQ(validateEdit(mesh), Defects());
    MeshEditor editor(mesh);
    for (Label c = 8; c < 8 + cut; ++c) { // the parts above come last
        bool merged = false;
        for (const MergePartner& partner : mergePartners(editor, c)) {
            const MeshEditor::Mark mark = editor.mark();
            merged = mergeCells(editor, c, partner.cell) &&
                     std::abs(editor.cellGeometry(partner.cell).volume - 1.0) < 1e-12;
            if (merged) break;
            editor.undoTo(mark);
        }
        EXPECT_TRUE(merged);
    }
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(test::liveCells(mesh), 8);
    EXPECT_EQ(test::liveFaces(mesh), 36);
    for (const EditFace& face : mesh.faces)
        EXPECT_TRUE(face.isRemoved() || face.points.size() == 4);
}

TEST(MergeCells, undoBringsTheMeshBack) {
    EditMesh mesh = test::boxOfHexes({2, 2, 1}, 1.0);
    const EditMesh before = mesh;
    MeshEditor editor(mesh);
    const MeshEditor::Mark mark = editor.mark();
    ASSERT_TRUE(mergeCells(editor, 0, 1));
    EXPECT_NE(test::liveFaces(mesh), test::liveFaces(before));
    editor.undoTo(mark);
    EXPECT_EQ(validateEdit(mesh), Defects());
    ASSERT_EQ(mesh.faces.size(), before.faces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        EXPECT_EQ(mesh.faces[f].points, before.faces[f].points);
    EXPECT_NEAR(editor.cellGeometry(0).volume, 1.0, 1e-15);
}

TEST(MergeCells, refusesARing) {
    // Cells 0, 1, 2 of a ring of eight round an empty middle merge; the last closes the ring.
    EditMesh mesh = test::boxOfHexes({3, 3, 1}, 1.0);
    test::removeCells(
        mesh, 6, [](const Vec3& c) { return std::hypot(c.x - 1.5, c.y - 1.5) < 0.1; });
    MeshEditor editor(mesh);
    for (const Label c : {1, 2, 5, 8, 7, 6})
        ASSERT_TRUE(mergeCells(editor, c, 0));
    EXPECT_FALSE(mergeCells(editor, 3, 0));
}

TEST(MergeSmallCells, makesNoCellOfMoreThanTwoAndAHalf) {
    EditMesh mesh = test::boxOfHexes({7, 1, 1}, 1.0);
    EXPECT_EQ(test::edit(mergeSmallCells, mesh, 10), 3); // two by two
    MeshEditor editor(mesh);
    for (Label c = 0; c < editor.cellCount(); ++c)
        if (!editor.cell(c).isRemoved()) {
            EXPECT_LT(editor.cellGeometry(c).volume, 2.5);
        }
}

TEST(MergeSmallCells, takesSliversAndKeepsVolume) {
    for (const double distance : {2.02, 3.05, 4.01, 2.5}) {
        EditMesh mesh = test::boxOfHexes({4, 4, 4}, 1.0);
        test::cutByPlane(mesh, {1, 0.3, 0.2}, distance, 6);
        const double volume = test::totalVolume(mesh);
        const Badness before = test::totalBadness(mesh);
        const Label cells = test::liveCells(mesh);
        const Label merged = test::edit(mergeSmallCells, mesh, 0.1);
        EXPECT_EQ(validateEdit(mesh), Defects());
        EXPECT_EQ(test::liveCells(mesh), cells - merged);
        EXPECT_GT(merged, 0) << distance;
        EXPECT_NEAR(test::totalVolume(mesh), volume, 1e-12 * volume);
        EXPECT_TRUE(isNoWorse(test::totalBadness(mesh), before));
    }
}

TEST(MergeSmallCells, isOffAtZeroAndLeavesFrozenCellsAlone) {
    EditMesh mesh = test::boxOfHexes({2, 1, 1}, 1.0);
    test::cutByPlane(mesh, {1, 0, 0}, 1.01, 6);
    EditMesh frozen = mesh;
    EXPECT_EQ(test::edit(mergeSmallCells, mesh, 0), 0);
    frozen.cells[0].frozen = true;
    for (const Label f : frozen.cells[0].faces)
        for (const Label p : frozen.faces[index(f)].points)
            frozen.ranks[index(p)] = PointRank::fixed;
    EXPECT_EQ(test::edit(mergeSmallCells, frozen, 0.1), 0);
    EXPECT_EQ(test::edit(mergeSmallCells, mesh, 0.1), 1);
    EXPECT_EQ(test::liveFaces(mesh), 6);
    EXPECT_EQ(validateEdit(mesh), Defects());
}

TEST(MergeSmallCells, slicesWaitForThePartnerBeyondASeam) {
    EditMesh mesh = test::boxOfHexes({2, 2, 1}, 1.0);
    test::cutByPlane(mesh, {1, 0, 0}, 1.01, 6); // two slices beside each other
    EditMesh seam = mesh;
    MeshEditor editor(mesh);
    for (Label c = 0; c < editor.cellCount(); ++c)
        if (editor.cellGeometry(c).volume > 0.5) seam.cells[index(c)].frozen = true;
    EXPECT_EQ(test::edit(mergeSmallCells, seam, 0.1), 0); // not with each other
    EXPECT_EQ(test::edit(mergeSmallCells, mesh, 0.1), 2);
}

/// Three cells in a row, with these heights at their four cross sections. Returns the partner with
/// which the one in the middle is merged.
Label partnerOfMiddle(const std::array<double, 4>& heights) {
    EditMesh mesh = test::boxOfHexes({3, 1, 1}, 1.0);
    for (Vec3& p : mesh.points)
        p.y *= heights[static_cast<std::size_t>(p.x)];
    MeshEditor editor(mesh);
    return mergeIntoBestPartner(editor, 1);
}

TEST(MergeIntoBestPartner, makesTheLeastConcaveCell) {
    // The first has the larger common face with the one in the middle; slopes of the top in
    // degrees.
    EXPECT_EQ(partnerOfMiddle({1.4, 0.8, 0.75, 0.9}), 2) << "28 concave against 11";
    EXPECT_EQ(partnerOfMiddle({1.0, 0.8, 0.75, 1.2}), 0) << "8 concave against 27";
    EXPECT_EQ(partnerOfMiddle({1.4, 0.8, 0.75, 0.7}), 2) << "28 concave against none";
    EXPECT_EQ(partnerOfMiddle({0.8, 0.8, 0.75, 0.65}), 0) << "both convex";
    EXPECT_EQ(partnerOfMiddle({0.9, 0.75, 0.8, 1.4}), 0) << "11 concave against 28";
}

TEST(MergeIntoBestPartner, ofEqualsTakesTheLargestCommonFace) {
    EXPECT_EQ(partnerOfMiddle({1.15, 0.8, 0.8, 1.15}), 0) << "as large: the lower label";
    const double slope = std::atan(-0.05);
    const auto rise = [&](double turn) { return std::tan(slope + turn); };
    EXPECT_EQ(partnerOfMiddle({0.8 - rise(-0.3), 0.8, 0.75, 0.75 + rise(0.3)}), 0);
}

TEST(MergeFaces, makesOneFaceOfCoplanarOnes) {
    // Two cells merged without uniting: faces are still cut along the seam.
    EditMesh mesh = test::boxOfHexes({2, 1, 1}, 1.0);
    MeshEditor editor(mesh);
    const auto faces = editor.cell(1).faces;
    for (const Label f : faces) {
        if (editor.otherCell(f, 1) == 0)
            editor.removeFace(f);
        else
            editor.giveFace(f, 1, 0);
    }
    ASSERT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(test::edit(mergeFaces, mesh, 0), 4);
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(test::liveFaces(mesh), 6);
    for (const EditFace& face : mesh.faces)
        if (!face.isRemoved()) {
            EXPECT_EQ(face.points.size(), 4U);
        }
}

TEST(CellShape, tellsBallsFromTheRest) {
    EditMesh mesh = test::boxOfHexes({1, 1, 1}, 1.0);
    EXPECT_EQ(cellShape(mesh, 0), CellShape::ball);
    MeshEditor editor(mesh);
    editor.removeFace(0);
    EXPECT_EQ(cellShape(mesh, 0), CellShape::broken);
}

} // namespace

} // namespace polymesh
