// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/splitConcaveCells.h"

#include "editMeshes.h"
#include "libpolymesh/quality/cutCell.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/validateEdit.h"

#include <gtest/gtest.h>

namespace polymesh {

namespace {

using Defects = std::vector<std::string>;

constexpr double tolerance = 0.1; // [rad]

Label reflexCount(EditMesh& mesh) {
    MeshEditor editor(mesh);
    Label count = 0;
    for (Label c = 0; c < editor.cellCount(); ++c)
        if (!editor.cell(c).isRemoved()) count += toLabel(reflexEdges(editor, c, tolerance).size());
    return count;
}

/// A box of 3 x 3 x 3 cells without what is above all of the planes, the cells whole again: concave
/// ones along the edges of the cavity.
EditMesh boxWithCavity(const std::vector<std::pair<Vec3, double>>& planes) {
    EditMesh mesh = test::boxOfHexes({3, 3, 3}, 1.0);
    for (const auto& [normal, distance] : planes)
        test::splitByPlane(mesh, normal, distance);
    test::removeCells(mesh, 6, [&](const Vec3& centre) {
        return std::all_of(planes.begin(), planes.end(), [&](const auto& plane) {
            return dot(plane.first, centre) > plane.second;
        });
    });
    test::rejoinPieces(mesh);
    test::rankPoints(mesh);
    return mesh;
}

/// The edges of the two faces at a reflex edge, apart from itself: a loop should not follow them.
EdgeList edgesToAvoid(const EditMesh& mesh, const ReflexEdge& edge) {
    EdgeList edges;
    for (const Label f : {edge.f, edge.g}) {
        const Polygon& polygon = mesh.faces[index(f)].points;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Label p = polygon[i];
            const Label q = polygon[(i + 1) % polygon.size()];
            edges.emplace_back(std::min(p, q), std::max(p, q));
        }
    }
    std::erase(edges, std::pair{edge.low, edge.high});
    return edges;
}

std::vector<Cut> halvingCutsOf(EditMesh& mesh) {
    MeshEditor editor(mesh);
    WorkBudget budget(10000);
    budget.startCell(0);
    const std::array<Label, 1> region{0};
    return halvingCuts(editor, 0, region, budget);
}

TEST(HalvingCuts, divideAHexahedronFromEdgeToOppositeEdge) {
    EditMesh cube = test::boxOfHexes({1, 1, 1}, 1.0);
    const std::vector<Cut> cuts = halvingCutsOf(cube);
    EXPECT_EQ(cuts.size(), 6U); // a loop for each pair of opposite edges
    for (const Cut& cut : cuts) {
        ASSERT_EQ(cut.loops.size(), 1U);
        EXPECT_EQ(cut.loops[0].size(), 4U);
        EXPECT_EQ(cut.after.failures, 0);
    }
}

TEST(HalvingCuts, aCellWithoutAreaHasNone) {
    EditMesh line = test::boxOfHexes({1, 1, 1}, 1.0);
    for (Vec3& p : line.points)
        p.y = p.z = 0;
    EXPECT_TRUE(halvingCutsOf(line).empty());
}

TEST(ReflexEdges, areFoundWithTheirAngles) {
    EditMesh mesh = boxWithCavity({{{1, 0, 0}, 1.4}, {{0, 1, 0}, 1.6}});
    ASSERT_EQ(validateEdit(mesh), Defects());
    MeshEditor editor(mesh);
    Label cells = 0;
    for (Label c = 0; c < editor.cellCount(); ++c) {
        if (editor.cell(c).isRemoved()) continue;
        for (const ReflexEdge& edge : reflexEdges(editor, c, tolerance)) {
            EXPECT_NEAR(edge.excess, std::acos(0.0), 1e-12);
            ++cells;
        }
    }
    EXPECT_EQ(cells, 3);
}

TEST(FindCuttingLoop, followsThePlaneRoundTheCell) {
    EditMesh mesh = boxWithCavity({{{1, 0, 0}, 1.4}, {{0, 1, 0}, 1.6}});
    MeshEditor editor(mesh);
    for (Label c = 0; c < editor.cellCount(); ++c) {
        if (editor.cell(c).isRemoved()) continue;
        for (const ReflexEdge& edge : reflexEdges(editor, c, tolerance)) {
            const auto loop = findCuttingLoop(
                editor, c, {edge.low, edge.high, {1, 0, 0}}, 0.05, edgesToAvoid(mesh, edge));
            ASSERT_TRUE(loop);
            EXPECT_EQ(loop->size(), 4U);
            for (const LoopCorner& corner : *loop)
                EXPECT_NEAR(corner.position.x, 1.4, 1e-12);
        }
    }
}

TEST(CutCell, keepsVolumeAndLaws) {
    EditMesh mesh = boxWithCavity({{{1, 0, 0}, 1.4}, {{0, 1, 0}, 1.6}});
    const double volume = test::totalVolume(mesh);
    MeshEditor editor(mesh);
    Label cuts = 0;
    for (Label c = 0; c < editor.cellCount(); ++c) {
        if (editor.cell(c).isRemoved()) continue;
        for (const ReflexEdge& edge : reflexEdges(editor, c, tolerance)) {
            const auto loop = findCuttingLoop(
                editor, c, {edge.low, edge.high, {1, 0, 0}}, 0.05, edgesToAvoid(mesh, edge));
            cuts += cutCell(editor, c, *loop) >= 0;
            break;
        }
    }
    EXPECT_EQ(cuts, 3);
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(reflexCount(mesh), 0);
    EXPECT_NEAR(test::totalVolume(mesh), volume, 1e-12);
}

TEST(SplitConcaveCells, mendsCellsRoundCavities) {
    const std::vector<std::vector<std::pair<Vec3, double>>> cavities{
        {{{1, 0, 0}, 1.1}, {{0, 1, 0}, 1.1}},
        {{{1, 0, 0}, 1.1}, {{0, 1, 0}, 1.15}, {{0, 0, 1}, 1.2}},
        {{{1, 0.2, 0.1}, 1.357}, {{0.1, 1, 0.2}, 1.468}, {{0, 0.3, 1}, 1.551}},
        {{{1, 2, 0.2}, 3.437}, {{-1, 2, 0.3}, 0.613}},
        {{{0.3, 0.1, 1}, 1.757},
         {{-0.3, 0.2, 1}, 0.859},
         {{0.1, 0.4, 1}, 1.813},
         {{0, -0.3, 1}, 0.717}}};
    for (std::size_t i = 0; i < cavities.size(); ++i) {
        EditMesh mesh = boxWithCavity(cavities[i]);
        ASSERT_EQ(validateEdit(mesh), Defects()) << i;
        const double volume = test::totalVolume(mesh);
        const Badness before = test::totalBadness(mesh);
        const SplitCounts counts = test::edit(splitConcaveCells, mesh, tolerance);
        EXPECT_EQ(validateEdit(mesh), Defects()) << i;
        EXPECT_NEAR(test::totalVolume(mesh), volume, 1e-12 * volume) << i;
        EXPECT_GT(before.failures, 0) << i;
        EXPECT_GT(counts.cuts, 0) << i;
        EXPECT_EQ(counts.left, 0) << i;
        EXPECT_EQ(test::totalBadness(mesh), Badness()) << i;
    }
}

TEST(SplitConcaveCells, leavesConvexCellsAlone) {
    EditMesh mesh = test::boxOfHexes({3, 3, 3}, 1.0);
    test::cutByPlane(mesh, {1, 2, 3}, 8.01, 6);
    EXPECT_EQ(test::edit(splitConcaveCells, mesh, tolerance).concave, 0);
}

} // namespace

} // namespace polymesh
