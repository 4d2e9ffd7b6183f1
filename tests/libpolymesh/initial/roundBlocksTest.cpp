// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/roundBlocks.h"

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polymesh::test {
namespace {

/// The volume of a mesh whose cells must be valid and right side out.
double checkedVolume(const PolyMesh& mesh) {
    EXPECT_TRUE(validate(mesh).empty());
    double sum = 0;
    for (const double v : computeGeometry(mesh).cellVolumes) {
        EXPECT_GT(v, 0);
        sum += v;
    }
    return sum;
}

/// The area of n points on a circle of radius 1, joined by lines.
double polygon(int n) {
    return 0.5 * n * std::sin(2 * std::numbers::pi / n);
}

Label facesOf(const PolyMesh& mesh, const std::string& patch) {
    const auto found = std::ranges::find(mesh.patches, patch, &Patch::name);
    return found == mesh.patches.end() ? -1 : found->size;
}

TEST(BoxBlocks, areGradedAndNameTheirSides) {
    const PolyMesh mesh =
        blockMesh(boxBlocks({{{0, 0, 0}, {2, 1, 1}}, {4, 3, 2}, {{{{1, 1, 8}}, {}, {}}}}));
    EXPECT_NEAR(checkedVolume(mesh), 2, 1e-13);
    EXPECT_EQ(facesOf(mesh, "xMin"), 6);
    EXPECT_EQ(facesOf(mesh, "zMax"), 12);
    EXPECT_NEAR((mesh.points[4].x - mesh.points[3].x) / mesh.points[1].x, 8, 1e-12);
}

TEST(CylinderBlocks, withACoreAreRound) {
    CylinderSpec spec;
    spec.end1 = {1, 2, 3};
    spec.end2 = {3, 4, 2}; // length 3
    spec.radius = 2;
    spec.cells = {3, 16, 5};
    const PolyMesh mesh = blockMesh(cylinderBlocks(spec));
    EXPECT_NEAR(checkedVolume(mesh), 3 * 4 * polygon(16), 1e-11);
    EXPECT_EQ(mesh.cellCount, (3 * 16 + 4 * 4) * 5);
    EXPECT_EQ(facesOf(mesh, "side"), 16 * 5);
    EXPECT_EQ(facesOf(mesh, "top"), 3 * 16 + 4 * 4);
    EXPECT_EQ(mesh.patches.size(), 3U);
}

TEST(CylinderBlocks, withAHole) {
    CylinderSpec spec;
    spec.end2 = {0, 0, 1};
    spec.holeRadius = 0.5;
    spec.cells = {3, 12, 2};
    const PolyMesh mesh = blockMesh(cylinderBlocks(spec));
    EXPECT_NEAR(checkedVolume(mesh), 0.75 * polygon(12), 1e-12);
    EXPECT_EQ(facesOf(mesh, "hole"), 24);
    EXPECT_EQ(mesh.patches.size(), 4U);
}

TEST(CylinderBlocks, sectorsOfAnyAngle) {
    for (const int degrees : {5, 90, 91, 180, 270, 300})
        for (const double hole : {0.0, 0.25}) {
            CylinderSpec spec;
            spec.end2 = {1, 0, 0};
            spec.holeRadius = hole;
            spec.angle = degrees * std::numbers::pi / 180;
            spec.cells = {3, 12, 2};
            const PolyMesh mesh = blockMesh(cylinderBlocks(spec));
            const double area = 6 * std::sin(spec.angle / 12) * (1 - hole * hole);
            EXPECT_NEAR(checkedVolume(mesh), area, 1e-12) << degrees;
            EXPECT_EQ(facesOf(mesh, "sectorMin"), 6);
            EXPECT_EQ(facesOf(mesh, "sectorMax"), 6);
            EXPECT_EQ(mesh.patches.size(), hole > 0 ? 6U : 5U);
        }
}

TEST(BallBlocks, areRound) {
    BallSpec spec;
    spec.centre = {1, 0, -1};
    spec.radius = 2;
    spec.cells = {4, 10};
    const PolyMesh mesh = blockMesh(ballBlocks(spec));
    EXPECT_NEAR(checkedVolume(mesh) / (4.0 / 3 * std::numbers::pi * 8), 1, 0.02);
    ASSERT_EQ(mesh.patches.size(), 1U);
    for (Label f = mesh.patches[0].start; f < mesh.faceCount(); ++f)
        for (const Label p : mesh.faces[f])
            EXPECT_NEAR(norm(mesh.points[index(p)] - spec.centre), 2, 1e-2);
}

} // namespace
} // namespace polymesh::test
