// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/repairSequence.h"

#include "editMeshes.h"
#include "libpolymesh/quality/validateEdit.h"

#include <gtest/gtest.h>

namespace polymesh {

namespace {

using Defects = std::vector<std::string>;

/// Cells of a box cut by two planes, of which some fail.
EditMesh meshWithSlivers() {
    EditMesh mesh = test::boxOfHexes({4, 4, 4}, 1.0);
    test::cutByPlane(mesh, {1, 0.31, 0.22}, 2.53, 6);
    test::cutByPlane(mesh, {-0.2, 1, 0.13}, 2.0 + 0.3 * (2.53 - 3), 7);
    return mesh;
}

std::vector<Polygon> livePolygons(const EditMesh& mesh) {
    std::vector<Polygon> polygons;
    for (const EditFace& face : mesh.faces)
        if (!face.isRemoved()) polygons.push_back(face.points);
    return polygons;
}

TEST(RepairSequence, doesWhatItSaysAndTheSearchChangesNothing) {
    EditMesh mesh = meshWithSlivers();
    MeshEditor editor(mesh);
    const std::vector<Label> failing = failingCells(editor);
    ASSERT_FALSE(failing.empty());
    Label mended = 0;
    for (const Label c : failing) {
        const std::vector<Polygon> polygons = livePolygons(mesh);
        WorkBudget budget(4000);
        budget.startCell(0);
        const RepairSequence sequence = findSequence(editor, c, budget);
        EXPECT_EQ(livePolygons(mesh), polygons);
        if (sequence.moves.empty()) continue;
        const Badness before = test::totalBadness(mesh);
        bool complete = true;
        makeSequence(editor, sequence, &complete);
        editor.commit();
        const Badness after = test::totalBadness(mesh);
        EXPECT_TRUE(complete);
        EXPECT_EQ(validateEdit(mesh), Defects());
        EXPECT_EQ(after.failures - before.failures, sequence.change.failures);
        EXPECT_NEAR(after.severity - before.severity, sequence.change.severity, 1e-6);
        EXPECT_TRUE(isGood(sequence.change));
        ++mended;
    }
    EXPECT_GT(mended, 0);
}

TEST(RepairSequence, endsWithTheBudget) {
    EditMesh mesh = meshWithSlivers();
    MeshEditor editor(mesh);
    const std::vector<Label> failing = failingCells(editor);
    ASSERT_FALSE(failing.empty());
    WorkBudget budget(0);
    budget.startCell(0);
    EXPECT_TRUE(findSequence(editor, failing[0], budget).moves.empty());
}

} // namespace

} // namespace polymesh
