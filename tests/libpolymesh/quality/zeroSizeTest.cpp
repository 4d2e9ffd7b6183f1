// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editMeshes.h"
#include "libpolymesh/quality/collapsePoints.h"
#include "libpolymesh/quality/mergeFaces.h"
#include "libpolymesh/quality/polygons.h"
#include "libpolymesh/quality/removeZeroSize.h"
#include "libpolymesh/quality/validateEdit.h"

#include <gtest/gtest.h>

#include <numeric>

namespace polymesh {

namespace {

using Defects = std::vector<std::string>;

TEST(SimpleLoops, cutsAWalkWhereItMeetsItself) {
    const std::vector<Polygon> expected{{0, 1, 2}, {0, 3, 4}};
    EXPECT_EQ(simpleLoops({0, 1, 2, 0, 3, 4}), expected);
    EXPECT_EQ(simpleLoops({0, 1, 2, 3}), std::vector<Polygon>({{0, 1, 2, 3}}));
    EXPECT_TRUE(simpleLoops({0, 1, 0, 2}).empty());
    EXPECT_EQ(simpleLoops({0, 0, 1, 1, 2, 2, 0}), std::vector<Polygon>({{0, 1, 2}}));
}

TEST(UnitedPolygon, runsRoundBoth) {
    EXPECT_EQ(unitedPolygon({0, 1, 2, 3}, {2, 1, 4, 5}), Polygon({2, 3, 0, 1, 4, 5}));
    EXPECT_EQ(unitedPolygon({0, 1, 2, 3}, {4, 3, 2, 1}), Polygon({3, 0, 1, 4}));
    EXPECT_TRUE(unitedPolygon({0, 1, 2}, {3, 4, 5}).empty());
    // two separate common edges: the union is a ring
    EXPECT_TRUE(unitedPolygon({0, 1, 2, 3}, {1, 0, 4, 3, 2, 5}).empty());
}

TEST(RemoveZeroSize, ofTwoPointsAtOnePlaceTheHigherRankStays) {
    for (const bool isCornerMoved : {false, true}) {
        EditMesh mesh = test::boxOfHexes({2, 1, 1}, 1.0); // 0 is a corner, 1 on an edge
        mesh.points[isCornerMoved ? 0 : 1] = mesh.points[isCornerMoved ? 1 : 0];
        EXPECT_EQ(test::edit(removeZeroSize, mesh).points, 1);
        EXPECT_EQ(validateEdit(mesh), Defects());
        const MeshEditor editor(mesh);
        EXPECT_FALSE(editor.facesOfPoint(0).empty());
        EXPECT_TRUE(editor.facesOfPoint(1).empty());
    }
}

TEST(CollapsePoints, leavesAMeshWithDistinctPointsAlone) {
    EditMesh mesh = test::boxOfHexes({2, 2, 2}, 1.0);
    std::vector<Label> self(mesh.points.size());
    std::iota(self.begin(), self.end(), 0);
    const CollapseCounts counts = test::edit(collapsePoints, mesh, self);
    EXPECT_EQ(counts.removedFaces + counts.removedCells + counts.addedCells, 0);
    EXPECT_EQ(test::liveFaces(mesh), 36);
}

TEST(CollapsePoints, removesTheFlatCellsOfAPlaneOnGridPoints) {
    // The plane lies on the points with z = 1, which count as below it: above them are flat cells.
    EditMesh mesh = test::boxOfHexes({3, 3, 2}, 1.0);
    test::cutByPlane(mesh, {0, 0, 1}, 1.0, 6);
    ASSERT_EQ(test::liveCells(mesh), 18);
    const CollapseCounts counts = test::edit(collapsePoints, mesh, test::coincidentPoints(mesh));
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(counts.removedCells, 9);
    EXPECT_EQ(counts.brokenCells, 0);
    EXPECT_EQ(test::liveCells(mesh), 9);
    EXPECT_EQ(test::liveFaces(mesh), 42);
    EXPECT_NEAR(test::totalVolume(mesh), 9.0, 1e-12);
    for (const EditFace& face : mesh.faces)
        if (!face.isRemoved()) {
            EXPECT_EQ(face.points.size(), 4U);
        }
}

TEST(CollapsePoints, keepsThePatchOfWhatAFlatCellLeavesBare) {
    EditMesh mesh = test::boxOfHexes({1, 1, 2}, 1.0);
    test::cutByPlane(mesh, {0, 0, 1}, 1.0, 6);
    test::edit(collapsePoints, mesh, test::coincidentPoints(mesh));
    Label onPatch = 0;
    for (const EditFace& face : mesh.faces)
        onPatch += !face.isRemoved() && face.patch == 6;
    EXPECT_EQ(onPatch, 1);
}

TEST(CollapsePoints, handlesPlanesThroughCellDiagonals) {
    for (const Vec3 normal : {Vec3{1, 1, 0}, Vec3{1, 1, 1}, Vec3{1, -1, 0}, Vec3{-1, 1, 1}}) {
        EditMesh mesh = test::boxOfHexes({4, 4, 4}, 1.0);
        test::cutByPlane(mesh, normal, 2.0, 6);
        const double volume = test::totalVolume(mesh);
        const CollapseCounts counts =
            test::edit(collapsePoints, mesh, test::coincidentPoints(mesh));
        EXPECT_EQ(validateEdit(mesh), Defects());
        EXPECT_GT(counts.removedCells, 0);
        EXPECT_EQ(counts.brokenCells, 0);
        EXPECT_NEAR(test::totalVolume(mesh), volume, 1e-12 * volume);
    }
}

TEST(CollapsePoints, makesTwoCellsOfOneThatHangsTogetherAtAnEdge) {
    // A hexahedron with two opposite edges of a middle section joined: two prisms at one edge.
    EditMesh mesh;
    mesh.points = {{0, 0, 0},
                   {2, 0, 0},
                   {2, 1, 0},
                   {0, 1, 0},
                   {0, 0, 1},
                   {2, 0, 1},
                   {2, 1, 1},
                   {0, 1, 1},
                   {1, 0, 0},
                   {1, 1, 0},
                   {1, 0, 1},
                   {1, 1, 1}};
    mesh.ranks.assign(mesh.points.size(), PointRank::surface);
    const std::vector<Polygon> faces{{0, 3, 9, 2, 1, 8},
                                     {4, 10, 5, 6, 11, 7},
                                     {0, 8, 10, 4},
                                     {8, 1, 5, 10},
                                     {3, 7, 11, 9},
                                     {9, 11, 6, 2},
                                     {0, 4, 7, 3},
                                     {1, 2, 6, 5}};
    mesh.cells.resize(1);
    mesh.cells[0].size = 1;
    for (const Polygon& points : faces) {
        EditFace face;
        face.points = points;
        face.owner = 0;
        face.patch = 0;
        mesh.cells[0].faces.push_back(toLabel(mesh.faces.size()));
        mesh.faces.push_back(face);
    }
    ASSERT_EQ(validateEdit(mesh), Defects());
    std::vector<Label> representative(mesh.points.size());
    std::iota(representative.begin(), representative.end(), 0);
    representative[9] = 8;
    representative[11] = 10;
    const CollapseCounts counts = test::edit(collapsePoints, mesh, representative);
    EXPECT_EQ(counts.addedCells, 1);
    EXPECT_EQ(counts.brokenCells, 0);
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(test::liveCells(mesh), 2);
    EXPECT_NEAR(test::totalVolume(mesh), 1.0, 1e-14);
}

TEST(RemoveZeroSize, mergesACellWithoutVolumeIntoItsNeighbour) {
    // The flat cell's upper face is cut in two, so that it is not the mirror of the lower one.
    EditMesh mesh = test::boxOfHexes({1, 1, 2}, 1.0);
    test::cutByPlane(mesh, {0, 0, 1}, 1.0, 6);
    std::size_t top = 0;
    while (mesh.faces[top].patch != 6)
        ++top;
    const Polygon quad = mesh.faces[top].points;
    EditFace half = mesh.faces[top];
    half.points = {quad[0], quad[1], quad[2]};
    mesh.faces[top].points = {quad[0], quad[2], quad[3]};
    mesh.cells[index(half.owner)].faces.push_back(toLabel(mesh.faces.size()));
    mesh.faces.push_back(half);
    test::edit(collapsePoints, mesh, test::coincidentPoints(mesh));
    const ZeroSizeCounts counts = test::edit(removeZeroSize, mesh);
    EXPECT_EQ(counts.cells, 1);
    EXPECT_EQ(counts.remainingCells, 0);
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(test::liveCells(mesh), 1);
    EXPECT_EQ(test::liveFaces(mesh), 7);
    EXPECT_EQ(test::edit(mergeFaces, mesh, 0), 1);
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(test::liveFaces(mesh), 6);
}

TEST(RemoveZeroSize, givesAPointThatLiesOnAnEdgeToTheEdge) {
    // One side of the upper cell is a triangle without area whose third point is on the seam.
    EditMesh mesh = test::boxOfHexes({1, 1, 2}, 1.0);
    MeshEditor editor(mesh);
    ASSERT_TRUE(insertPointInEdge(editor, 4, 5, editor.addPoint({0.25, 0, 1}, PointRank::feature)));
    EXPECT_EQ(validateEdit(mesh), Defects());
    const Label middle = toLabel(mesh.points.size()) - 1;
    EditFace flat; // takes the middle point out of the upper cell's side face
    for (Label f = 0; f < editor.faceCount(); ++f) {
        EditFace face = editor.face(f);
        if (!hasPoint(face.points, middle) || face.owner != 1) continue;
        face.points.erase(std::find(face.points.begin(), face.points.end(), middle));
        editor.replaceFace(f, face);
        flat = face;
        flat.points = {4, middle, 5};
        if (cornerAfter(face.points, 4) == 5) break;
        std::swap(flat.points[0], flat.points[2]);
    }
    ASSERT_EQ(flat.owner, 1);
    editor.addFace(flat);
    ASSERT_EQ(validateEdit(mesh), Defects());
    const ZeroSizeCounts counts = test::edit(removeZeroSize, mesh);
    EXPECT_EQ(counts.edges, 1);
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(test::liveFaces(mesh), 11);
    EXPECT_NEAR(test::totalVolume(mesh), 2.0, 1e-14);
}

} // namespace

} // namespace polymesh
