// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/collapseEdges.h"

#include "editMeshes.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/mergeCells.h"
#include "libpolymesh/quality/validateEdit.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polymesh {

namespace {

using Defects = std::vector<std::string>;

Label shortEdges(const EditMesh& mesh, double limit) {
    Label count = 0;
    for (const EditFace& face : mesh.faces)
        for (std::size_t i = 0; !face.isRemoved() && i < face.points.size(); ++i) {
            const Label p = face.points[i];
            const Label q = face.points[(i + 1) % face.points.size()];
            count += norm(mesh.points[index(p)] - mesh.points[index(q)]) < limit;
        }
    return count;
}

TEST(CollapseShortEdges, removesTheShortEdgesOfCutsNearPoints) {
    const std::vector<Vec3> normals{
        {1, 0, 0}, {1, 0.013, 0}, {1, 1, 0.02}, {1, 1, 1}, {1, -0.5, 0.25}};
    for (const Vec3& normal : normals)
        for (const double distance : {2.01, 2.02, 2.03}) {
            EditMesh mesh = test::boxOfHexes({4, 4, 4}, 1.0);
            test::cutByPlane(mesh, normal, distance, 6);
            const double volume = test::totalVolume(mesh);
            const Badness before = test::totalBadness(mesh);
            const Label shortBefore = shortEdges(mesh, 0.05);
            const Label collapsed = test::edit(collapseShortEdges, mesh, 0.05);
            EXPECT_EQ(validateEdit(mesh), Defects());
            EXPECT_GE(collapsed, 1);
            EXPECT_LT(shortEdges(mesh, 0.05), shortBefore) << normal.y << ' ' << distance;
            EXPECT_NEAR(test::totalVolume(mesh), volume, 0.05 * 16);
            EXPECT_TRUE(isNoWorse(test::totalBadness(mesh), before));
        }
}

TEST(CollapseShortEdges, isOffAtZero) {
    EditMesh mesh = test::boxOfHexes({2, 2, 2}, 1.0);
    test::cutByPlane(mesh, {1, 1, 1}, 3.001, 6);
    EXPECT_EQ(test::edit(collapseShortEdges, mesh, 0), 0);
}

TEST(MayCollapse, pointsMoveAlongWhatTheyAreOn) {
    EditMesh mesh = test::boxOfHexes({3, 3, 3}, 1.0);
    EditMesh sheet = test::boxOfHexes({3, 3, 1}, 1.0);
    const auto may = [](EditMesh& body, const Vec3& from, const Vec3& to) {
        const auto at = [&](const Vec3& p) {
            return toLabel(
                static_cast<std::size_t>(std::ranges::find(body.points, p) - body.points.begin()));
        };
        MeshEditor editor(body);
        return mayCollapse(editor, at(from), at(to));
    };
    const Vec3 inside{1, 1, 1};
    const Vec3 onSide{1, 1, 0};
    const Vec3 onEdge{1, 0, 0};
    const Vec3 corner{0, 0, 0};
    EXPECT_TRUE(may(mesh, inside, {2, 1, 1}));
    EXPECT_TRUE(may(mesh, inside, onSide));
    EXPECT_TRUE(may(mesh, onSide, {2, 1, 0}));
    EXPECT_TRUE(may(mesh, onSide, onEdge));
    EXPECT_TRUE(may(mesh, onEdge, {2, 0, 0}));
    EXPECT_TRUE(may(mesh, onEdge, corner));
    EXPECT_FALSE(may(mesh, onSide, inside)) << "off the surface";
    EXPECT_FALSE(may(mesh, onEdge, onSide)) << "off the feature edge";
    EXPECT_FALSE(may(mesh, corner, onEdge)) << "a corner";
    EXPECT_FALSE(may(sheet, onSide, {1, 1, 1})) << "through the body";
    EXPECT_FALSE(may(sheet, onEdge, {1, 0, 1})) << "across a side";
}

TEST(CollapseShortEdges, neverMovesAFixedPoint) {
    EditMesh mesh = test::boxOfHexes({3, 3, 3}, 1.0);
    test::cutByPlane(mesh, {1, 0.7, 0.4}, 3.03, 6);
    for (std::size_t p = 0; p < mesh.points.size(); p += 2)
        if (mesh.ranks[p] == PointRank::surface) mesh.ranks[p] = PointRank::fixed;
    const std::vector<PointRank> ranks = mesh.ranks;
    std::vector<bool> used(mesh.points.size(), false);
    const auto markUsed = [&](std::vector<bool>& flags) {
        for (const EditFace& face : mesh.faces)
            if (!face.isRemoved())
                for (const Label p : face.points)
                    flags[index(p)] = true;
    };
    markUsed(used);
    EXPECT_GT(test::edit(collapseShortEdges, mesh, 0.3), 0);
    std::vector<bool> usedAfter(mesh.points.size(), false);
    markUsed(usedAfter);
    for (std::size_t p = 0; p < used.size(); ++p) {
        if (used[p] && ranks[p] == PointRank::fixed) {
            EXPECT_TRUE(usedAfter[p]);
        }
    }
}

/// One cell under 9 x 9 faces of the boundary, which are more than collapses judge a cell by. Two
/// points lie close beside another, which is moved: see below.
struct ManyFacedCell {
    EditMesh mesh = test::boxOfHexes({9, 9, 2}, 1.0);
    Label moving = pointAt(4, 4);
    Label corner = pointAt(4, 3);

    ManyFacedCell() {
        MeshEditor editor(mesh);
        for (Label c = 1; c < 81; ++c)
            EXPECT_TRUE(mergeCells(editor, c, 0));
        test::removeCells(mesh, 6, [](const Vec3& centre) { return centre.z > 1; });
        test::rankPoints(mesh);
        mesh.ranks[index(corner)] = PointRank::corner;
        place(corner, {-0.04, -0.02, 0});
        place(pointAt(3, 4), {-0.02, 0, 0});
        place(pointAt(3, 3), {-1, -0.1, 0});
    }

    /// Of the grid of points between the two layers of cells.
    static Label pointAt(Label i, Label j) { return i + 10 * (j + 10); }

    void place(Label p, const Vec3& fromMoving) {
        mesh.points[index(p)] = mesh.points[index(moving)] + fromMoving;
    }

    Label collapse() {
        MeshEditor editor(mesh);
        EXPECT_GT(editor.cell(0).faces.size(), 64U);
        return collapseBestWay(editor, moving, corner);
    }
};

TEST(CollapseShortEdges, turnsNoFaceOfACellWithManyFaces) {
    ManyFacedCell wide;
    EXPECT_EQ(wide.collapse(), wide.moving);
    ManyFacedCell thin; // the corner is beyond the far side of a face of the moving point
    thin.place(ManyFacedCell::pointAt(3, 5), {-0.011, 0.5, 0});
    EXPECT_EQ(thin.collapse(), -1);
}

TEST(CollapseShortEdges, letsACellVanish) {
    // A small corner of a cell is a tetrahedron with three short edges: it goes as a whole.
    EditMesh mesh = test::boxOfHexes({2, 2, 2}, 1.0);
    test::cutByPlane(mesh, {1, 1, 1}, 3.04, 6);
    const Label cells = test::liveCells(mesh);
    EXPECT_GT(test::edit(collapseShortEdges, mesh, 0.1), 0);
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_LT(test::liveCells(mesh), cells);
    EXPECT_EQ(shortEdges(mesh, 0.1), 0);
}

} // namespace

} // namespace polymesh
