// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/repairCells.h"

#include "editMeshes.h"
#include "libpolymesh/quality/cleanUp.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/validateEdit.h"

#include <gtest/gtest.h>

namespace polymesh {

namespace {

using Defects = std::vector<std::string>;

/// A box of cells cut by two planes that leave slivers, thin walls and a sharp edge.
EditMesh sliverMesh(double distance) {
    EditMesh mesh = test::boxOfHexes({4, 4, 4}, 1.0);
    test::cutByPlane(mesh, {1, 0.31, 0.22}, distance, 6);
    test::cutByPlane(mesh, {-0.2, 1, 0.13}, 2.0 + 0.3 * (distance - 3), 7);
    return mesh;
}

TEST(Badness, countsWhatCheckMeshFails) {
    EditMesh mesh = test::boxOfHexes({2, 1, 1}, 1.0);
    EXPECT_EQ(test::totalBadness(mesh), Badness());
    for (Vec3& p : mesh.points)
        if (p.x == 2) p.x = 1.0 + 1e-5; // a plate: aspect ratio
    EXPECT_GE(test::totalBadness(mesh).failures, 1);
    for (Vec3& p : mesh.points)
        if (p.x > 1) p.x = 0.5; // inside out: volume, pyramids, non-orthogonality
    EXPECT_GE(test::totalBadness(mesh).failures, 3);
}

TEST(RepairCells, leavesFewerFailures) {
    Label failuresBefore = 0;
    Label failuresAfter = 0;
    for (const double distance : {2.53, 3.01, 3.31, 3.57, 4.02}) {
        EditMesh mesh = sliverMesh(distance);
        const Badness before = test::totalBadness(mesh);
        failuresBefore += before.failures;
        const double volume = test::totalVolume(mesh);
        MeshEditor editor(mesh);
        const RepairCounts single = repairCells(editor);
        const RepairCounts counts = repairThoroughly(editor, single.left, 80000);
        const Badness after = test::totalBadness(mesh);
        EXPECT_EQ(validateEdit(mesh), Defects());
        EXPECT_TRUE(isNoWorse(after, before));
        EXPECT_EQ(single.bad > 0, before.failures > 0);
        EXPECT_EQ(!counts.left.empty(), after.failures > 0);
        EXPECT_NEAR(test::totalVolume(mesh), volume, 0.01 * volume);
        failuresAfter += after.failures;
    }
    EXPECT_GT(failuresBefore, 0);
    EXPECT_EQ(failuresAfter, 0);
}

TEST(CleanUp, leavesNothingThatCheckMeshFails) {
    Label repairedMeshes = 0;
    for (const double distance : {2.53, 3.01, 3.31, 3.57, 4.02}) {
        EditMesh mesh = sliverMesh(distance);
        repairedMeshes += test::totalBadness(mesh).failures > 0;
        const CleanUpCounts counts =
            cleanUp(mesh, test::coincidentPoints(mesh), {.minEdge = 0.05, .minVolume = 0.05});
        EXPECT_EQ(validateEdit(mesh), Defects());
        EXPECT_EQ(test::totalBadness(mesh).failures, 0) << distance;
        EXPECT_EQ(counts.badCells, 0);
        EXPECT_EQ(counts.brokenCells, 0);
    }
    EXPECT_GT(repairedMeshes, 0);
}

TEST(CleanUp, gridAlignedBoxBecomesItsHexahedra) {
    EditMesh mesh = test::boxOfHexes({4, 4, 4}, 1.0);
    Label patch = 6;
    for (const Vec3& normal : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        test::cutByPlane(mesh, normal, 3.0, patch++);
        test::cutByPlane(mesh, -normal, -1.0, patch++);
    }
    cleanUp(mesh, test::coincidentPoints(mesh), {.minEdge = 0, .minVolume = 0});
    EXPECT_EQ(validateEdit(mesh), Defects());
    EXPECT_EQ(test::liveCells(mesh), 8);
    EXPECT_EQ(test::liveFaces(mesh), 36);
    for (const EditFace& face : mesh.faces)
        EXPECT_TRUE(face.isRemoved() || face.points.size() == 4);
}

TEST(CleanUp, isTheSameEveryTime) {
    const auto run = [] {
        EditMesh mesh = sliverMesh(3.31);
        cleanUp(mesh, test::coincidentPoints(mesh), {.minEdge = 0.1, .minVolume = 0.1});
        std::vector<Polygon> faces;
        for (const EditFace& face : mesh.faces)
            faces.push_back(face.isRemoved() ? Polygon() : face.points);
        return faces;
    };
    EXPECT_EQ(run(), run());
}

} // namespace

} // namespace polymesh
