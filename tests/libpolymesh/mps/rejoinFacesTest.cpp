// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/rejoinFaces.h"

#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/joinCells.h"
#include "libpolymesh/mps/restoreCells.h"
#include "libpolymesh/mps/splitFaces.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace polymesh {

namespace {

/// The mesh with a boundary face of triangles round a new point in its middle, and an internal one
/// split by a diagonal.
EditedMesh withTriangles(const PolyMesh& mesh, Label internal, Label boundary) {
    EditedMesh edited = unedited(mesh);
    const Label middle = mesh.pointCount();
    edited.mesh.points.push_back(faceGeometry(mesh.points, mesh.faces[boundary]).centre);
    const auto cut = mesh.faces[internal];
    const auto fan = mesh.faces[boundary];
    std::vector<FacePieces> pieces{{internal, {{cut[0], cut[1], cut[2]}, {cut[0], cut[2], cut[3]}}},
                                   {boundary, {}}};
    for (std::size_t i = 0; i < fan.size(); ++i)
        pieces[1].pieces.push_back({fan[i], fan[(i + 1) % fan.size()], middle});
    edited.mesh = withPieces(std::move(edited.mesh), pieces);
    const auto at = edited.boundaryOrigin.begin() + static_cast<std::ptrdiff_t>(boundary) -
                    mesh.internalFaceCount();
    edited.boundaryOrigin.insert(at, fan.size() - 1, *at);
    edited.boundaryFrom = edited.boundaryOrigin;
    return edited;
}

} // namespace

TEST(RejoinFaces, piecesAreOneFaceAgain) {
    const PolyMesh mesh = test::twoHexes();
    EditedMesh edited = withTriangles(mesh, 0, mesh.internalFaceCount() + 2);
    ASSERT_EQ(edited.mesh.faceCount(), mesh.faceCount() + 4);
    const SubdivisionPlan plan = planSubdivision(edited.mesh);
    EXPECT_EQ(rejoinFaces(edited, plan, std::vector<Label>{0, 1}), 4);
    dropUnusedPoints(edited);
    EXPECT_TRUE(validate(edited.mesh).empty());
    EXPECT_EQ(edited.mesh.points, mesh.points);
    EXPECT_EQ(edited.boundaryOrigin, unedited(mesh).boundaryOrigin);
    ASSERT_EQ(edited.mesh.faceCount(), mesh.faceCount());
    for (Label face = 0; face < mesh.faceCount(); ++face) {
        std::vector<Label> loop(edited.mesh.faces[face].begin(), edited.mesh.faces[face].end());
        const auto as = mesh.faces[face];
        std::rotate(loop.begin(), std::ranges::find(loop, as[0]), loop.end()); // clang 14
        EXPECT_TRUE(std::ranges::equal(loop, as));
    }
}

TEST(RejoinFaces, facesOfDifferentOriginsStayApart) {
    EditedMesh edited = unedited(test::unitCube());
    const SubdivisionPlan plan = planSubdivision(edited.mesh);
    EXPECT_EQ(rejoinFaces(edited, plan, std::vector<Label>{0}), 0);
}

TEST(RestoreCells, piecesOfACellBecomeOneAgain) {
    EditedMesh edited = unedited(test::twoHexes());
    const PolyMesh before = edited.mesh;
    const CellCones cones{0, {{0.5, 0.5, 0.5}}, {0, 1, 2, 3, 4, 5}, 6};
    edited.mesh = withCones(edited.mesh, cellFaces(edited.mesh), std::vector{cones});
    edited.cellFrom.insert(edited.cellFrom.end(), 5, 0);
    const auto pairs = piecesRound(edited, cellFaces(edited.mesh), std::vector<Label>{3});
    EXPECT_EQ(pairs.size(), 5U);
    edited.mesh = withJoinedCells(std::move(edited.mesh), pairs);
    dropUnusedPoints(edited);
    EXPECT_TRUE(validate(edited.mesh).empty());
    EXPECT_EQ(edited.mesh, before);
}

} // namespace polymesh
