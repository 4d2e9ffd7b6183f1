// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/threadLimit.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/surface/distance.h"
#include "libpolymesh/surface/measure.h"
#include "libpolymesh/surface/triangleBoxes.h"
#include "libpolymesh/trim/adjustGuard.h"
#include "libpolymesh/trim/adjustNodes.h"
#include "libpolymesh/trim/hangingNodes.h"
#include "libpolymesh/trim/trim.h"
#include "tests/libpolymesh/trim/adjusted.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

namespace polymesh::test {
namespace {

const AdjustOptions project{Adjust::project, 0.3, {}};
const AdjustOptions repel{Adjust::repel, 0.3, {}};

/// The paper's pyramid, base 1 x 1 and height 1, and its 27 cells of 0.4 with a plane at the base.
TriSurface paperPyramid() {
    return surfaceOf({{-.5, -.5, 0}, {.5, -.5, 0}, {.5, .5, 0}, {-.5, .5, 0}, {0, 0, 1}},
                     {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
}

PolyMesh paperBox() {
    PolyMesh mesh = box(3, 3, 3, {1.2, 1.2, 1.2});
    for (Vec3& p : mesh.points)
        p -= {0.6, 0.6, 0};
    return mesh;
}

/// How many cells have how many faces.
std::map<Label, Label> faceCounts(const PolyMesh& mesh) {
    const Rows<Label> faces = cellFaces(mesh);
    std::map<Label, Label> counts;
    for (Label c = 0; c < mesh.cellCount; ++c)
        ++counts[faces.rowSize(c)];
    return counts;
}

} // namespace

TEST(SmallestPart, isOneForParallelepipedsAndNegativeInsideOut) {
    PolyMesh mesh = box(1, 1, 1, {2, 3, 4});
    for (Vec3& p : mesh.points)
        p += {0.5 * p.y, 0, 0.3 * p.x};
    const Rows<Label> faces = cellFaces(mesh);
    const PartMeasure parts = smallestPart(mesh, 0, faces[0], 0);
    EXPECT_NEAR(parts.volume, volumeOf(mesh), 1e-13);
    EXPECT_NEAR(parts.smallest, 1, 1e-14);
    mesh = unitCube();
    mesh.points[0] = {0.8, 0.8, 0.8}; // past the middle: its corner is turned inside out
    EXPECT_LT(smallestPart(mesh, 0, faces[0], 0).smallest, 0);
    EXPECT_LT(smallestPart(invertedCell(), 0, faces[0], 0).smallest, 0);
}

TEST(HangingNodes, areThoseWhereTheLargeCellIsStraight) {
    const PolyMesh mesh = hangingNodes();
    const Rows<Label> faces = cellFaces(mesh);
    std::vector<HangingNode> found;
    for (Label c = 0; c < mesh.cellCount; ++c)
        findHanging(mesh, c, faces[c], found);
    ASSERT_EQ(found.size(), 5U); // four on edges, one in the face
    for (const HangingNode& node : found) {
        const Vec3& p = mesh.points[index(node.node)];
        EXPECT_EQ(p.x, 1);
        EXPECT_TRUE(p.y == 1 || p.z == 1);
        EXPECT_DOUBLE_EQ(node.weight, 0.5);
        EXPECT_EQ(node.place(mesh.points), p);
    }
}

TEST(AdjustNodes, hangingNodesKeepTheirPlaceOnTheLargeCell) {
    PolyMesh mesh = hangingNodes();
    // Moves the corners of the large cell's face at x = 1 to x = 1.2, but for y + z < 1.
    const TriSurface surface =
        surfaceOf({{1.2, -1, 1.5}, {1.2, 3, 0.3}, {1.2, 3, 5}, {1.2, -1, 5}, {3, 0, 2.5}},
                  {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
    const AdjustedNodes adjusted = adjust(mesh, surface, project);
    EXPECT_GE(adjusted.settled.size(), 2U);
    const auto at = [&](Label j, Label k) { return mesh.points[index(1 + 2 * (j + 3 * k))]; };
    EXPECT_NEAR(at(0, 2).x, 1.2, 0.031);
    EXPECT_NEAR(at(2, 2).x, 1.2, 0.031);
    for (const Label end : {0, 2}) {
        EXPECT_EQ(at(1, end), 0.5 * (at(0, end) + at(2, end)));
        EXPECT_EQ(at(end, 1), 0.5 * (at(end, 0) + at(end, 2)));
    }
    EXPECT_EQ(at(1, 1), 0.25 * (at(0, 0) + at(0, 2) + at(2, 0) + at(2, 2)));
}

TEST(AdjustNodes, putsNodesOnCornersThenEdgesThenFaces) {
    PolyMesh mesh = box(6, 6, 6, {6, 6, 6});
    const TriSurface surface = cuboid({1.1, 1.15, 1.1}, {4.85, 4.9, 4.88});
    const AdjustedNodes adjusted = adjust(mesh, surface, project);
    EXPECT_EQ(adjusted.counts.corners, 8);
    EXPECT_EQ(adjusted.counts.edges, 12 * 3);
    EXPECT_EQ(adjusted.counts.faces, 6 * 9);
    EXPECT_EQ(adjusted.counts.refused, 0);
    const SurfaceTree tree(surface);
    Label corners = 0;
    for (const SettledNode& node : adjusted.settled) {
        EXPECT_EQ(tree.closest(node.place).distance, 0);
        EXPECT_LT(norm(mesh.points[index(node.node)] - node.place), 0.031);
        corners += std::ranges::count(surface.points, node.place) != 0 ? 1 : 0;
    }
    EXPECT_EQ(corners, 8);
}

TEST(AdjustNodes, aCornerTakesOneNodeTheNearest) {
    PolyMesh mesh = box(2, 2, 2, {2, 2, 2});
    mesh.points[13] = {1, 1, 1.0};
    const TriSurface surface = cuboid({1.1, 1.1, 1.1}, {5, 5, 5});
    const AdjustedNodes adjusted = adjust(mesh, surface, project);
    ASSERT_EQ(adjusted.counts.corners, 1);
    ASSERT_FALSE(adjusted.settled.empty());
    const auto corner =
        std::ranges::find(adjusted.settled, AdjustTarget::corner, &SettledNode::target);
    EXPECT_EQ(corner->node, 13);
    EXPECT_EQ(corner->place, (Vec3{1.1, 1.1, 1.1}));
}

TEST(AdjustNodes, boundaryNodesStayInTheBoundary) {
    const PolyMesh before = box(5, 5, 5);
    PolyMesh mesh = before;
    adjust(mesh, sphere(4, 0.63, {0.5, 0.45, 0.52}), project);
    Label moved = 0;
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
        for (int axis = 0; axis < 3; ++axis) {
            const double x = before.points[p][axis];
            if (x == 0 || x == 1) {
                EXPECT_EQ(mesh.points[p][axis], x);
                moved += mesh.points[p] != before.points[p] ? 1 : 0;
            }
        }
    EXPECT_GT(moved, 10);
    EXPECT_GT(worstCell(mesh), 0.1);
}

TEST(AdjustNodes, repelLeavesNoNodeNear) {
    PolyMesh mesh = box(9, 9, 9);
    const TriSurface surface = sphere(5, 0.3, {0.5, 0.51, 0.52});
    const SurfaceTree tree(surface);
    const AdjustedNodes adjusted = adjust(mesh, surface, repel);
    EXPECT_GT(adjusted.counts.away, 50);
    EXPECT_EQ(adjusted.counts.refused, 0);
    EXPECT_TRUE(adjusted.settled.empty());
    for (const Vec3& p : mesh.points)
        EXPECT_GT(tree.closest(p).distance, 0.29 / 9);
    EXPECT_GT(worstCell(mesh), 0.1);
}

TEST(AdjustNodes, edgesGoAwayFromPlacesToAvoid) {
    // Nodes at x = 1 are projected; the edge from (3, 1, 1) to (3, 2, 1) passes the place.
    const TriSurface surface = cuboid({0.9, -9, -9}, {3.6, 9, 9});
    PolyMesh mesh = box(4, 4, 4, {4, 4, 4});
    AdjustOptions options = project;
    options.avoided = {{3.01, 1.5, 1}};
    const AdjustedNodes adjusted = adjust(mesh, surface, options);
    const auto at = [](Label i, Label j, Label k) { return index(i + 5 * (j + 5 * k)); };
    const Vec3 middle = 0.5 * (mesh.points[at(3, 1, 1)] + mesh.points[at(3, 2, 1)]);
    EXPECT_GT(norm(middle - options.avoided[0]), 0.119);
    EXPECT_EQ(adjusted.counts.faces, 25);
    for (const SettledNode& node : adjusted.settled)
        EXPECT_EQ(node.place.x, 0.9);
}

TEST(AdjustNodes, nodesAreRepelledOnRequest) {
    const TriSurface surface = cuboid({0.9, -9, -9}, {3.6, 9, 9});
    PolyMesh mesh = box(4, 4, 4, {4, 4, 4});
    AdjustOptions options = project;
    options.repelled = {1 + 5 * (2 + 5 * 2)};
    const AdjustedNodes adjusted = adjust(mesh, surface, options);
    EXPECT_EQ(adjusted.counts.faces, 24);
    EXPECT_EQ(adjusted.counts.away, 1);
    EXPECT_NEAR(mesh.points[index(options.repelled[0])].x, 1.2, 1e-12);
}

TEST(AdjustNodes, refusesWhatMakesACellTooThin) {
    PolyMesh mesh = box(4, 4, 4, {4, 4, 4});
    // Both layers of nodes beside this plate would go onto it.
    const TriSurface plate = cuboid({-1, -1, 1.49}, {5, 5, 1.51});
    const AdjustedNodes adjusted = adjust(mesh, plate, {Adjust::project, 0.5, {}});
    EXPECT_GT(adjusted.counts.refused, 0);
    EXPECT_GT(adjusted.counts.faces, 0);
    EXPECT_GT(worstCell(mesh), 0.1);
}

TEST(AdjustNodes, givesTheSameForAnyNumberOfThreads) {
    const TriSurface surface = sphere(4, 0.4, {0.5, 0.51, 0.52});
    std::vector<Vec3> first;
    for (const std::size_t threads : {1U, 2U, 8U}) {
        const ThreadLimit limit(threads);
        PolyMesh mesh = jittered(box(24, 24, 24), 0.005);
        adjust(mesh, surface, project);
        if (first.empty()) first = mesh.points;
        EXPECT_EQ(mesh.points, first) << threads;
    }
}

TEST(Adjust, thePaperPyramidHasElevenCells) {
    TrimOptions options;
    options.adjust = project;
    const Trimmed result = trim(paperBox(), paperPyramid(), options);
    EXPECT_TRUE(validate(result.mesh).empty());
    EXPECT_EQ(result.summary.adjusted.edges, 8); // 0.289 of a cell from the sharp edges
    EXPECT_EQ(result.summary.badCells, 0);
    // Four triangular prisms and five pyramids have five faces, two hexahedra six.
    EXPECT_EQ(faceCounts(result.mesh), (std::map<Label, Label>{{5, 9}, {6, 2}}));
    EXPECT_EQ(result.mesh.pointCount(), 25);
    EXPECT_NEAR(volumeOf(result.mesh), 1.0 / 3, 1e-15);
}

TEST(Adjust, bodiesOffTheGridBecomeHexahedra) {
    // All corners, edges and faces are 0.1 to 0.2 cells beside nodes.
    TrimOptions options;
    options.adjust = project;
    const TriSurface body = cuboid({1.1, 1.15, 1.1}, {4.85, 4.9, 4.88});
    for (const bool cleansUp : {true, false}) {
        if (!cleansUp) options.minEdge = options.minVolume = 0;
        options.mendsCells = cleansUp;
        const PolyMesh mesh = trim(box(6, 6, 6, {6, 6, 6}), body, options).mesh;
        EXPECT_TRUE(validate(mesh).empty());
        EXPECT_EQ(mesh.cellCount, 64);
        EXPECT_EQ(faceCounts(mesh), (std::map<Label, Label>{{6, 64}}));
        EXPECT_EQ(mesh.pointCount(), 125);
        EXPECT_NEAR(volumeOf(mesh), measure(body).volume, 1e-12);
    }
}

TEST(Adjust, insideAndOutsideFillTheBox) {
    const TriSurface body = sphere(3, 0.33, {0.5, 0.51, 0.52});
    for (const AdjustOptions& adjusting : {project, repel}) {
        TrimOptions options;
        options.adjust = adjusting;
        options.deviation = 0;
        const Trimmed inside = trim(box(8, 8, 8), body, options);
        options.keep = Keep::outside;
        const Trimmed outside = trim(box(8, 8, 8), body, options);
        EXPECT_TRUE(validate(inside.mesh).empty());
        EXPECT_TRUE(validate(outside.mesh).empty());
        const double part = measure(body).volume;
        EXPECT_NEAR(volumeOf(inside.mesh), part, 2e-3 * part); // collapsed edges cost that much
        EXPECT_NEAR(volumeOf(inside.mesh) + volumeOf(outside.mesh), 1, 2e-3);
    }
}

TEST(Adjust, smallestCellsAndEdgesGrow) {
    const TriSurface body = sphere(5, 0.33, {0.5, 0.51, 0.52});
    const auto smallest = [&](const AdjustOptions& adjusting) {
        TrimOptions options;
        options.adjust = adjusting;
        options.minEdge = options.minVolume = 0;
        options.mendsCells = false;
        const PolyMesh mesh = trim(box(20, 20, 20), body, options).mesh;
        return std::ranges::min(computeGeometry(mesh).cellVolumes) * 8000;
    };
    const double none = smallest({});
    EXPECT_LT(none, 1e-4);
    EXPECT_GT(smallest(repel), 20 * none);
    EXPECT_GT(smallest(project), 20 * none);
}

TEST(Adjust, projectLeavesNoSmallCellWhateverTheBody) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
        const TriSurface body = skewCuboid(seed);
        const auto smallest = [&](Adjust how) {
            TrimOptions options;
            options.adjust.how = how;
            options.minEdge = options.minVolume = 0;
            options.mendsCells = false;
            const PolyMesh mesh = trim(box(14, 14, 14), body, options).mesh;
            EXPECT_TRUE(validate(mesh).empty());
            return std::ranges::min(computeGeometry(mesh).cellVolumes) * (14 * 14 * 14);
        };
        const double none = smallest(Adjust::none);
        const double projected = smallest(Adjust::project);
        EXPECT_GT(projected, 20 * none) << "seed " << seed;
        EXPECT_GT(projected, 1e-4) << "seed " << seed;
    }
}

} // namespace polymesh::test
