// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/movePoint.h"

#include "editMeshes.h"
#include "libpolymesh/quality/validateEdit.h"

#include <gtest/gtest.h>

namespace polymesh {

namespace {

using Defects = std::vector<std::string>;

/// A cube of which a thin prism on the side y = 0 is a cell of its own. Points 0 to 4 are below:
/// the ends of its long edge, its third corner 2 and the far corners; 5 more are above.
EditMesh cubeWithThinPrism() {
    EditMesh mesh;
    for (const double z : {0.0, 1.0})
        for (const Vec3& p : {Vec3{0, 0, z}, {1, 0, z}, {0.5, 0.02, z}, {1, 1, z}, {0, 1, z}})
            mesh.points.push_back(p);
    const auto addFace = [&](const Polygon& points, Label owner, Label neighbour, Label patch) {
        for (const Label c : {owner, neighbour})
            if (c >= 0) mesh.cells[index(c)].faces.push_back(toLabel(mesh.faces.size()));
        mesh.faces.push_back({points, owner, neighbour, patch});
    };
    mesh.cells.resize(2);
    for (EditCell& cell : mesh.cells)
        cell.size = 1;
    addFace({0, 1, 6, 5}, 0, -1, 2);
    addFace({0, 2, 1}, 0, -1, 4);
    addFace({5, 6, 7}, 0, -1, 5);
    addFace({0, 5, 7, 2}, 0, 1, -1);
    addFace({2, 7, 6, 1}, 0, 1, -1);
    addFace({0, 4, 3, 1, 2}, 1, -1, 4);
    addFace({5, 7, 6, 8, 9}, 1, -1, 5);
    addFace({1, 3, 8, 6}, 1, -1, 1);
    addFace({3, 4, 9, 8}, 1, -1, 3);
    addFace({4, 0, 5, 9}, 1, -1, 0);
    test::rankPoints(mesh);
    return mesh;
}

TEST(PinchIntoEdge, thinPrismGoesAndTheVolumeStays) {
    EditMesh mesh = cubeWithThinPrism();
    ASSERT_EQ(validateEdit(mesh), Defects());
    MeshEditor editor(mesh);
    ASSERT_TRUE(mayPinch(editor, 2, {0, 1, 0.05}));
    ASSERT_TRUE(pinchIntoEdge(editor, 2, 0, 1));
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(test::liveCells(mesh), 2);
    ASSERT_TRUE(pinchIntoEdge(editor, 7, 5, 6));
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(test::liveCells(mesh), 1);
    EXPECT_EQ(test::liveFaces(mesh), 7); // the side y = 0 is in two halves
    EXPECT_NEAR(test::totalVolume(mesh), 1.0, 1e-12);
}

TEST(PinchIntoEdge, thePointGoesToTheEdgeUnlessItsRankIsHigher) {
    for (const PointRank rank : {PointRank::surface, PointRank::feature, PointRank::corner}) {
        EditMesh mesh = cubeWithThinPrism();
        mesh.ranks[2] = rank;
        MeshEditor editor(mesh);
        ASSERT_TRUE(pinchIntoEdge(editor, 2, 0, 1)); // an edge between two patches: a feature
        EXPECT_EQ(editor.facesOfPoint(2).empty(), rank <= PointRank::feature);
    }
}

TEST(PinchIntoEdge, canBeTakenBack) {
    EditMesh mesh = cubeWithThinPrism();
    MeshEditor editor(mesh);
    const MeshEditor::Mark mark = editor.mark();
    ASSERT_TRUE(pinchIntoEdge(editor, 2, 0, 1));
    ASSERT_TRUE(pinchIntoEdge(editor, 7, 5, 6));
    editor.undoTo(mark);
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(test::liveCells(mesh), 2);
    EXPECT_EQ(test::liveFaces(mesh), 10);
}

TEST(PinchIntoEdge, onlyPointsNearTheInnerPartOfTheEdgeMay) {
    EditMesh mesh = cubeWithThinPrism();
    MeshEditor editor(mesh);
    EXPECT_FALSE(mayPinch(editor, 2, {0, 1, 0.01})); // too far
    EXPECT_FALSE(mayPinch(editor, 0, {0, 1, 0.05})); // an end
    EXPECT_FALSE(mayPinch(editor, 4, {0, 1, 2.0}));  // beside an end
}

TEST(MovePoint, movesItInAllFaces) {
    EditMesh mesh = cubeWithThinPrism();
    MeshEditor editor(mesh);
    const Label moved = movePoint(editor, 2, {0.5, 0.1, 0}, PointRank::surface);
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_TRUE(editor.facesOfPoint(2).empty());
    EXPECT_EQ(editor.facesOfPoint(moved).size(), 4U);
    EXPECT_NEAR(test::totalVolume(mesh), 1.0, 1e-12);
}

TEST(MaySlide, byRank) {
    EditMesh mesh = cubeWithThinPrism();
    MeshEditor editor(mesh);
    EXPECT_TRUE(maySlide(editor, 2, 0));  // on the surface, along an edge of the surface
    EXPECT_FALSE(maySlide(editor, 2, 7)); // through the inside
    EXPECT_FALSE(maySlide(editor, 4, 3)); // a corner stays
}

TEST(MaySlide, pointsOfFeaturesAlongThese) {
    EditMesh mesh = test::boxOfHexes({3, 3, 3}, 1.0);
    MeshEditor editor(mesh);
    EXPECT_TRUE(maySlide(editor, 1, 2));      // (1 0 0) to (2 0 0)
    EXPECT_FALSE(maySlide(editor, 1, 1 + 4)); // to (1 1 0), across the side
}

} // namespace

} // namespace polymesh
