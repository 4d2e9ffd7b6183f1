// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/error.h"
#include "libpolymesh/initial/blockHexCells.h"
#include "libpolymesh/initial/blockParts.h"
#include "libpolymesh/initial/roundBlocks.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/refine/openCollapsed.h"
#include "libpolymesh/refine/refine.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <set>

namespace polymesh {
namespace {

RefinedMesh refineBlocks(const BlockMeshDescription& blocks, const Criterion& criterion) {
    RefinedMesh refined = refine(hexCells(blocks, blockMesh(blocks)), {{criterion}, 1});
    const std::vector<Defect> defects = validate(refined.mesh);
    EXPECT_TRUE(defects.empty()) << defects.front().message;
    return refined;
}

Criterion all(int level) {
    return [=](const RefineCell& cell) { return cell.level < level; };
}

std::set<Label> pointsOfPatch(const PolyMesh& mesh, const std::string& name) {
    std::set<Label> points;
    for (const Patch& patch : mesh.patches)
        if (patch.name == name)
            for (Label f = patch.start; f < patch.start + patch.size; ++f)
                points.insert(mesh.faces[f].begin(), mesh.faces[f].end());
    EXPECT_FALSE(points.empty()) << name;
    return points;
}

CylinderSpec cylinderSpec(Label factor) {
    CylinderSpec spec;
    spec.end1 = {0, 0, 0};
    spec.end2 = {0, 0, 2};
    spec.radius = 1;
    spec.cells = {2 * factor, 16 * factor, 3 * factor};
    return spec;
}

double distanceOfSorted(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    EXPECT_EQ(a.size(), b.size());
    double most = 0;
    for (const Vec3& p : a) {
        double least2 = Box::inf;
        for (const Vec3& q : b)
            least2 = std::min(least2, squaredNorm(p - q));
        most = std::max(most, std::sqrt(least2));
    }
    return most;
}

/// A graded box whose side x = 0 bulges onto a sphere.
BlockMeshDescription bulgingBox(Label factor) {
    BlockMeshDescription blocks;
    for (const double z : {0.0, 1.0})
        for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
            blocks.vertices.push_back({x, y, z});
    Block block;
    block.vertices = {0, 1, 2, 3, 4, 5, 6, 7};
    block.cells = {4 * factor, 4 * factor, 4 * factor};
    for (std::size_t e = 0; e < 4; ++e)
        block.grading[e] = {{1, 1, 3}};
    blocks.blocks.push_back(block);
    blocks.defaultPatch.type = "patch";
    BlockSide bulge;
    bulge.vertices = {0, 4, 7, 3};
    const Shape sphere = sphereShape({1, 0.5, 0.5}, std::sqrt(1.5));
    blocks.projectedSides.push_back({bulge, sphere});
    return blocks;
}

} // namespace

TEST(RefineBlocks, aRefinedCylinderIsRound) {
    const RefinedMesh refined = refineBlocks(cylinderBlocks(cylinderSpec(1)), all(2));
    const PolyMesh& mesh = refined.mesh;
    for (const Label p : pointsOfPatch(mesh, "side"))
        EXPECT_NEAR(std::hypot(mesh.points[index(p)].x, mesh.points[index(p)].y), 1, 1e-12);
}

TEST(RefineBlocks, refinedEverywhereIsTheMeshOfFinerBlocks) {
    const RefinedMesh refined = refineBlocks(cylinderBlocks(cylinderSpec(1)), all(1));
    const PolyMesh fine = blockMesh(cylinderBlocks(cylinderSpec(2)));
    EXPECT_EQ(refined.mesh.cellCount, fine.cellCount);
    EXPECT_LT(distanceOfSorted(refined.mesh.points, fine.points), 1e-12);
}

TEST(RefineBlocks, gradingGrowsOnInsideCells) {
    BlockMeshDescription blocks = bulgingBox(1);
    blocks.projectedSides.clear();
    const RefinedMesh refined = refineBlocks(blocks, all(1));
    std::set<double> x;
    for (const Vec3& p : refined.mesh.points)
        if (p.y == 0 && p.z == 0) x.insert(p.x);
    ASSERT_EQ(x.size(), 9U);
    std::vector<double> planes(x.begin(), x.end());
    const double growth = (planes[2] - planes[1]) / (planes[1] - planes[0]);
    EXPECT_NEAR(growth, std::pow(3, 1.0 / 6), 1e-9) << "the root of what it is from cell to cell";
    for (std::size_t i = 2; i + 1 < planes.size(); ++i)
        EXPECT_NEAR((planes[i + 1] - planes[i]) / (planes[i] - planes[i - 1]), growth, 1e-9);
}

TEST(RefineBlocks, projectedSidesLieOnTheirShape) {
    const Criterion near = [](const RefineCell& cell) {
        return cell.level < 3 && norm(cell.centre - Vec3{-0.1, 0.4, 0.6}) < cell.radius + 0.1;
    };
    const RefinedMesh refined = refineBlocks(bulgingBox(1), near);
    Label onSphere = 0;
    for (const Vec3& x : refined.mesh.points) {
        if (std::abs(norm(x - Vec3{1, 0.5, 0.5}) - std::sqrt(1.5)) < 1e-9) ++onSphere;
        EXPECT_LE(norm(x - Vec3{1, 0.5, 0.5}), std::sqrt(1.5) + 1e-9);
    }
    EXPECT_GT(onSphere, 100);
}

TEST(RefineBlocks, partsThatAreStitchedRefineAcross) {
    BlockMeshDescription blocks;
    for (const double x : {0.0, 1.0}) {
        BlockMeshDescription part = bulgingBox(1);
        part.projectedSides.clear();
        for (Vec3& p : part.vertices)
            p.x += x;
        addPart(blocks, part, "dict:1");
    }
    const Criterion near = [](const RefineCell& cell) {
        return cell.level < 2 && std::abs(cell.centre.x - 1) < cell.radius;
    };
    const RefinedMesh refined = refineBlocks(blocks, near);
    EXPECT_GT(std::ranges::count(refined.cellLevel, 2), 2 * 64);
    for (Label f = refined.mesh.internalFaceCount(); f < refined.mesh.faceCount(); ++f)
        for (const Label p : refined.mesh.faces[f]) {
            const Vec3& at = refined.mesh.points[index(p)];
            EXPECT_TRUE(at.x != 1 || std::min({at.y, at.z, 1 - at.y, 1 - at.z}) < 1e-9);
        }
}

TEST(RefineBlocks, mergedPatchesRefineAcross) {
    BlockMeshDescription blocks;
    for (const double x : {0.0, 1.0})
        for (const double z : {0.0, 1.0})
            for (const auto& [u, v] : {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
                blocks.vertices.push_back({x + u, v, z});
    for (const Label first : {0, 8}) {
        Block block;
        for (Label i = 0; i < 8; ++i)
            block.vertices[index(i)] = first + i;
        block.cells = {2, 2, 2};
        blocks.blocks.push_back(block);
    }
    blocks.patches = {{{"left", "patch", 0, 0, {}}, {{{1, 2, 6, 5}, ""}}},
                      {{"right", "patch", 0, 0, {}}, {{{8, 12, 15, 11}, ""}}}};
    blocks.mergePairs = {{"left", "right", ""}};
    const Criterion near = [](const RefineCell& cell) {
        return cell.level < 2 && norm(cell.centre - Vec3{0.8, 0.5, 0.5}) < cell.radius;
    };
    const RefinedMesh refined = refineBlocks(blocks, near);
    for (Label f = refined.mesh.internalFaceCount(); f < refined.mesh.faceCount(); ++f)
        EXPECT_NE(faceGeometry(refined.mesh.points, refined.mesh.faces[f]).centre.x, 1);
    EXPECT_EQ(refined.cellLevel.back(), 0);
    EXPECT_GT(std::ranges::count(refined.cellLevel, 1), 8) << "cells beyond the pair too";
}

/// Prisms round an axis from (0 0 0) to (0 0 1), a block each.
BlockMeshDescription wedges(std::size_t count, const std::array<Label, 3>& cells) {
    BlockMeshDescription blocks;
    blocks.vertices = {{0, 0, 0}, {0, 0, 1}};
    for (std::size_t i = 0; i < count; ++i) {
        const double angle =
            2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        for (const double z : {0.0, 1.0})
            blocks.vertices.push_back({std::cos(angle), std::sin(angle), z});
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Label a = toLabel(2 + 2 * i);
        const Label b = toLabel(2 + 2 * ((i + 1) % count));
        Block block;
        block.vertices = {0, a, b, 0, 1, a + 1, b + 1, 1};
        block.cells = cells;
        blocks.blocks.push_back(block);
    }
    return blocks;
}

TEST(RefineBlocks, wedgesRefinedEverywhereAreFinerWedges) {
    const RefinedMesh refined = refineBlocks(wedges(5, {3, 1, 2}), all(2));
    const PolyMesh finer = blockMesh(wedges(5, {12, 4, 8}));
    EXPECT_EQ(refined.mesh.cellCount, finer.cellCount);
    EXPECT_EQ(refined.mesh.faceCount(), finer.faceCount());
    EXPECT_EQ(refined.mesh.internalFaceCount(), finer.internalFaceCount());
    EXPECT_LT(distanceOfSorted(refined.mesh.points, finer.points), 1e-12);
}

TEST(RefineBlocks, cellsRoundAnAxisAreDividedTogether) {
    const Criterion near = [](const RefineCell& cell) {
        return cell.level < 3 && norm(cell.centre - Vec3{0.1, 0.02, 0.3}) < cell.radius;
    };
    const RefinedMesh refined = refineBlocks(wedges(5, {3, 1, 2}), near);
    const PolyMesh& mesh = refined.mesh;
    std::map<std::array<Label, 2>, std::set<Label>> levelsAtEdge; // on the axis
    const auto isOnAxis = [&](Label p) {
        return std::hypot(mesh.points[index(p)].x, mesh.points[index(p)].y) < 1e-12;
    };
    for (Label f = 0; f < mesh.faceCount(); ++f)
        for (std::size_t i = 0; i < mesh.faces[f].size(); ++i) {
            const Label a = mesh.faces[f][i];
            const Label b = mesh.faces[f][(i + 1) % mesh.faces[f].size()];
            if (!isOnAxis(a) || !isOnAxis(b)) continue;
            std::set<Label>& levels = levelsAtEdge[{std::min(a, b), std::max(a, b)}];
            levels.insert(refined.cellLevel[index(mesh.owner[index(f)])]);
            if (mesh.isInternal(f))
                levels.insert(refined.cellLevel[index(mesh.neighbour[index(f)])]);
        }
    EXPECT_GT(levelsAtEdge.size(), 5U) << "the axis is refined";
    for (const auto& [edge, levels] : levelsAtEdge)
        EXPECT_EQ(levels.size(), 1U) << "at " << mesh.points[index(edge[0])].z;
}

TEST(RefineBlocks, aBlockWithAnApexRefines) {
    BlockMeshDescription blocks;
    blocks.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
    Block block;
    block.vertices = {0, 1, 2, 3, 4, 4, 4, 4};
    block.cells = {2, 2, 2};
    blocks.blocks.push_back(block);
    const Criterion near = [](const RefineCell& cell) {
        return cell.level < 2 && norm(cell.centre - Vec3{0.4, 0.4, 0.9}) < cell.radius;
    };
    const RefinedMesh refined = refineBlocks(blocks, near);
    EXPECT_GT(std::ranges::count(refined.cellLevel, 2), 8);
    EXPECT_NEAR(boundedVolume(refined.mesh), 1.0 / 3, 1e-12);
    EXPECT_GT(std::ranges::min(computeGeometry(refined.mesh).cellVolumes), 0);
}

TEST(RefineBlocks, twoCellsRoundAnAxisAreRefused) {
    const std::vector<MacroMesh::Corners> cells{{0, 2, 0, 4, 1, 3, 1, 5}, {0, 4, 0, 2, 1, 5, 1, 3}};
    EXPECT_THROW(openCollapsed(cells, 6), InputError);
}

TEST(RefineBlocks, wedgesOpenToARing) {
    // Three wedges round the axis from 0 to 1: each end has a copy for each side between them.
    const std::vector<MacroMesh::Corners> cells{
        {0, 2, 0, 4, 1, 3, 1, 5}, {0, 4, 0, 6, 1, 5, 1, 7}, {0, 6, 0, 2, 1, 7, 1, 3}};
    const OpenedCells opened = openCollapsed(cells, 8);
    EXPECT_EQ(opened.original.size(), 8U + 4U);
    for (std::size_t c = 0; c < 3; ++c) {
        const MacroMesh::Corners& own = opened.corners[c];
        const MacroMesh::Corners& next = opened.corners[(c + 1) % 3];
        EXPECT_EQ(std::set<Label>(own.begin(), own.end()).size(), 8U);
        for (const std::size_t up : {0U, 4U}) {
            EXPECT_EQ(own[2 + up], next[0 + up]);
            EXPECT_EQ(opened.original[index(own[up])], up == 0 ? 0 : 1);
        }
    }
}

} // namespace polymesh
