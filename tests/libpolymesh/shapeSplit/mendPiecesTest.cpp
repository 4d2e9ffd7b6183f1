// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/mendPieces.h"

#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/starPoint.h"
#include "libpolymesh/shapeSplit/faceTriangles.h"
#include "libpolymesh/shapeSplit/innerPoint.h"
#include "libpolymesh/shapes/classify.h"
#include "tests/support/editedMesh.h"

#include <gtest/gtest.h>

#include <limits>

namespace polymesh::test {

namespace {

const Tetrahedraliser noTetrahedra;

/// New cells may go, new points may move, all cells may be united.
MendMeans meansFor(const EditedMesh& edited) {
    MendMeans means;
    means.firstNewCell = toLabel(edited.part.cells.size());
    means.firstNewPoint = toLabel(edited.part.points.size());
    means.mayUnite = [](Label, Label) { return true; };
    means.tetrahedralise = &noTetrahedra;
    return means;
}

void expectMended(EditedMesh& edited) {
    EXPECT_TRUE(failingCells(edited.editor).empty());
    const PolyMesh mesh = edited.result();
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_NEAR(volumeOf(mesh), volumeOf(edited.mesh), 1e-14);
    EXPECT_EQ(census(classifyCells(mesh, cellFaces(mesh))).unrecognised, 0);
}

/// The pyramids of a cell round a point that is very near a face, so that the one there is flat.
void makeFlatPyramid(EditedMesh& edited) {
    const Label f = edited.editor.cell(0).faces[0];
    const Vec3 onFace = edited.editor.faceGeometry(f).centre;
    const Vec3 inward = edited.editor.cellGeometry(0).centre - onFace;
    makePyramids(edited.editor, 0, onFace + 1e-4 * inward);
    edited.editor.commit();
}

TEST(MendPieces, movesANewPointAwayFromAFace) {
    EditedMesh edited(unitCube());
    makeFlatPyramid(edited);
    ASSERT_FALSE(failingCells(edited.editor).empty());
    EXPECT_GT(mendPieces(edited.editor, meansFor(edited)), 0);
    expectMended(edited);
    EXPECT_EQ(edited.result().pointCount(), 9); // the old place of the point is gone
}

TEST(MendPieces, unitesAFlatPieceWithAnother) {
    // A tetrahedron of which a slice along a side is another cell.
    EditedMesh edited(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1e-5, 0}},
                             {{{4, 2, 1}, {4, 1, 3}, {1, 2, 3}, {4, 3, 2}},
                              {{0, 4, 1}, {0, 1, 3}, {4, 3, 1}, {0, 3, 4}}}));
    ASSERT_FALSE(failingCells(edited.editor).empty());
    MendMeans means = meansFor(edited);
    means.firstNewCell = 1;
    EXPECT_EQ(mendPieces(edited.editor, means), 1);
    EXPECT_TRUE(failingCells(edited.editor).empty());
    EXPECT_TRUE(edited.editor.cell(1).isRemoved());
    EXPECT_NEAR(edited.editor.cellGeometry(0).volume, 1.0 / 6, 1e-14);
}

TEST(MendPieces, changesNothingThatItMayNot) {
    EditedMesh edited(tetrahedron());
    makeFlatPyramid(edited);
    const PolyMesh before = edited.result();
    MendMeans means = meansFor(edited);
    means.firstNewPoint = std::numeric_limits<Label>::max();
    means.mayUnite = [](Label, Label) { return false; };
    EXPECT_EQ(mendPieces(edited.editor, means), 0);
    EXPECT_EQ(edited.result(), before);
    means = meansFor(edited);
    means.tolerated = {0, 1, 2, 3};
    EXPECT_EQ(mendPieces(edited.editor, means), 0);
    EXPECT_EQ(edited.result(), before);
}

/// Two cells, one on the other; the face between them has a deep notch, those below and above not.
PolyMesh cellsWithNotchBetween() {
    std::vector<Vec3> points;
    for (const double z : {0.0, 1.0, 2.0})
        for (const Vec3& p :
             {Vec3{-1, 0, z}, Vec3{0, z == 1 ? 0.6 : -0.5, z}, Vec3{1, 0, z}, Vec3{0, 1, z}})
            points.push_back(p);
    return meshOf(points,
                  {hexahedron({0, 1, 2, 3, 4, 5, 6, 7}), hexahedron({4, 5, 6, 7, 8, 9, 10, 11})});
}

TEST(MendPieces, cutsAConcaveFaceForBothSides) {
    EditedMesh edited(cellsWithNotchBetween());
    ASSERT_TRUE(failingCells(edited.editor).empty());
    const auto apex = innerPoint(edited.editor, 0);
    ASSERT_TRUE(apex);
    makePyramids(edited.editor, 0, *apex);
    edited.editor.commit();
    ASSERT_FALSE(failingCells(edited.editor).empty()); // the centre of one pyramid is in the notch
    EXPECT_GT(mendPieces(edited.editor, meansFor(edited)), 0);
    expectMended(edited);
}

TEST(FaceTriangles, haveNoSpike) {
    // A face that goes round a tunnel through its cell: its area vector is small, and so is the
    // volume over it by OpenFOAM's definition, compared with what its triangles bound.
    const std::vector<Vec3> loop{{0.4957, -0.5117, 0.0831},
                                 {0.4957, 0.4883, 0.0831},
                                 {0.2132, 0.4883, -0.0707},
                                 {-0.0009, 0.4883, 0.1844},
                                 {0.2132, 0.4883, 0.4395},
                                 {0.4957, 0.4883, 0.2857},
                                 {0.4957, -0.5117, 0.2857}};
    std::vector<Vec3> points = loop;
    points.push_back({-0.5, 0, 0.2});
    const Label n = toLabel(loop.size());
    Polyhedron cone(1);
    for (Label i = 0; i < n; ++i) {
        cone[0].push_back(i);
        cone.push_back({(i + 1) % n, i, n});
    }
    EditedMesh edited(meshOf(points, {cone}));
    Label face = 0;
    while (edited.editor.face(face).points.size() == 3)
        ++face;
    const auto ways = trianglesKeepingVolume(edited.editor, face);
    ASSERT_FALSE(ways.empty());
    for (const Vec3& p : ways.front().positions)
        EXPECT_LT(norm(p - edited.editor.faceGeometry(face).centre), 1.0);
    const double volume = edited.editor.cellGeometry(0).volume;
    replaceByTriangles(edited.editor, face, ways.front());
    EXPECT_NEAR(edited.editor.cellGeometry(0).volume, volume, 1e-14);
}

} // namespace

} // namespace polymesh::test
