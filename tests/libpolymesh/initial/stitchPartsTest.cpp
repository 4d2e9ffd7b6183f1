// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/stitchParts.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/initial/blockParts.h"
#include "libpolymesh/initial/roundBlocks.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mesh/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

namespace polymesh::test {
namespace {

/// A box with cells of the size 1/4.
BlockMeshDescription box(const Vec3& min, const Vec3& max) {
    const Vec3 n = 4 * (max - min);
    return boxBlocks({{min, max},
                      {static_cast<Label>(std::lround(n.x)),
                       static_cast<Label>(std::lround(n.y)),
                       static_cast<Label>(std::lround(n.z))},
                      {}});
}

BlockMeshDescription joined(const std::vector<BlockMeshDescription>& parts) {
    BlockMeshDescription all;
    for (std::size_t i = 0; i < parts.size(); ++i)
        addPart(all, parts[i], "part" + std::to_string(i));
    return all;
}

double volumeOf(const PolyMesh& mesh) {
    EXPECT_TRUE(validate(mesh).empty());
    const std::vector<double> volumes = computeGeometry(mesh).cellVolumes;
    return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

Label regionCount(const PolyMesh& mesh) {
    return std::ranges::max(cellRegions(mesh)) + 1;
}

std::string refusal(const std::vector<BlockMeshDescription>& parts) {
    try {
        blockMesh(joined(parts));
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was refused";
}

void expectRefusal(const std::vector<BlockMeshDescription>& parts, const std::string& begin) {
    const std::string message = refusal(parts);
    EXPECT_EQ(message.substr(0, begin.size()), begin) << message;
}

TEST(StitchParts, joinsBoxesThatShareASide) {
    const PolyMesh mesh = blockMesh(joined({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {3, 1, 1})}));
    EXPECT_NEAR(volumeOf(mesh), 3, 1e-12);
    EXPECT_EQ(mesh.pointCount(), 13 * 5 * 5);
    EXPECT_EQ(mesh.faceCount() - mesh.internalFaceCount(), 2 * 16 + 4 * 48);
    EXPECT_EQ(mesh.patches.size(), 6U); // those of the same name are one
    EXPECT_EQ(regionCount(mesh), 1);
}

TEST(StitchParts, joinsFaceByFaceWhereSidesDiffer) {
    // The second stands on the first and leans over its edge.
    const PolyMesh mesh =
        blockMesh(joined({box({0, 0, 0}, {1, 1, 1}), box({0.5, 0, 1}, {2, 0.75, 1.5})}));
    EXPECT_NEAR(volumeOf(mesh), 1 + 1.5 * 0.75 * 0.5, 1e-12);
    EXPECT_EQ(regionCount(mesh), 1);
    const PolyMesh apart = blockMesh(box({0, 0, 0}, {1, 1, 1}));
    const PolyMesh other = blockMesh(box({0.5, 0, 1}, {2, 0.75, 1.5}));
    EXPECT_EQ(mesh.internalFaceCount(),
              apart.internalFaceCount() + other.internalFaceCount() + 2 * 3);
}

TEST(StitchParts, takesCoordinatesThatDifferByRounding) {
    const double third = 1.0 / 3 + 1e-9;
    const PolyMesh mesh = blockMesh(
        joined({box({0, 0, 0}, {1, 1, 1}),
                boxBlocks({{{1 + 1e-9, -1e-9, 0}, {2, 1, 1}},
                           {4, 4, 4},
                           {{{{third, third, 1}, {1 - third, 1 - third, 1}}, {}, {}}}})}));
    EXPECT_EQ(regionCount(mesh), 1);
    EXPECT_TRUE(validate(mesh).empty());
}

TEST(StitchParts, joinsCylindersWithRingsAndEndToEnd) {
    CylinderSpec inner;
    inner.end2 = {0, 0, 1};
    inner.cells = {3, 16, 4};
    CylinderSpec ring = inner;
    ring.holeRadius = 1;
    ring.radius = 2;
    CylinderSpec next = inner;
    next.end1 = {0, 0, 1};
    next.end2 = {0, 0, 3};
    const PolyMesh mesh =
        blockMesh(joined({cylinderBlocks(inner), cylinderBlocks(ring), cylinderBlocks(next)}));
    const double area = 8 * std::sin(std::numbers::pi / 8);
    EXPECT_NEAR(volumeOf(mesh), area * (4 + 2), 1e-11);
    EXPECT_EQ(regionCount(mesh), 1);
    EXPECT_EQ(std::ranges::find(mesh.patches, "hole", &Patch::name), mesh.patches.end());
}

/// Law: boxes on a lattice, however they are heaped up, become one mesh without gaps when each
/// touches an earlier one, and are refused when two have a lattice cell in common.
TEST(StitchParts, heapsOfBoxesAreOneMeshOrOverlap) {
    std::mt19937 random(5);
    const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    using Cube = std::array<int, 3>;
    int refused = 0;
    for (int round = 0; round < 40; ++round) {
        std::set<Cube> filled{{0, 0, 0}};
        std::vector<BlockMeshDescription> parts{box({0, 0, 0}, {1, 1, 1})};
        bool isOverlapping = false;
        while (parts.size() < 5 && !isOverlapping) {
            auto from = filled.begin();
            std::advance(from, pick(static_cast<int>(filled.size())));
            Cube cube = *from;
            cube[static_cast<std::size_t>(pick(3))] += pick(2) == 0 ? 1 : -1;
            if (filled.contains(cube) && pick(6) > 0) continue;
            isOverlapping = !filled.insert(cube).second;
            const Vec3 min{static_cast<double>(cube[0]),
                           static_cast<double>(cube[1]),
                           static_cast<double>(cube[2])};
            parts.push_back(box(min, min + Vec3{1, 1, 1}));
        }
        if (isOverlapping) {
            EXPECT_NE(refusal(parts).find("overlaps the part at"), std::string::npos);
            ++refused;
            continue;
        }
        const PolyMesh mesh = blockMesh(joined(parts));
        EXPECT_NEAR(volumeOf(mesh), static_cast<double>(filled.size()), 1e-12);
        EXPECT_EQ(regionCount(mesh), 1);
        std::set<std::array<double, 3>> places;
        for (const Vec3& p : mesh.points)
            EXPECT_TRUE(places.insert({p.x, p.y, p.z}).second);
    }
    EXPECT_GT(refused, 3);
    EXPECT_LT(refused, 37);
}

TEST(StitchParts, refusesWhatOverlaps) {
    const BlockMeshDescription unit = box({0, 0, 0}, {1, 1, 1});
    expectRefusal({unit, box({0.5, 0, 0}, {2, 1, 1})}, "part1: overlaps the part at part0 near (");
    expectRefusal({unit, unit}, "part1: overlaps the part at part0 near (");
    expectRefusal({unit, boxBlocks({{{0.3, 0.3, 0.3}, {0.4, 0.4, 0.4}}, {1, 1, 1}, {}})},
                  "part1: overlaps the part at part0 near (0.35 0.35 0.35)");
    expectRefusal({unit, boxBlocks({{{-1, -1, -1}, {2, 2, 2}}, {1, 1, 1}, {}})},
                  "part1: overlaps the part at part0 near (0.5 0.5 0.5)");
    CylinderSpec turned; // only its edge cuts into the box
    turned.end1 = {1.6, 0.5, -1};
    turned.end2 = {1.6, 0.5, 3};
    turned.radius = 0.75;
    turned.cells = {3, 16, 8};
    expectRefusal({unit, cylinderBlocks(turned)}, "part1: overlaps the part at part0 near (");
}

TEST(StitchParts, refusesWhatTouchesWithOtherFacesOrMisses) {
    const BlockMeshDescription unit = box({0, 0, 0}, {1, 1, 1});
    expectRefusal({unit, boxBlocks({{{1, 0, 0}, {2, 1, 1}}, {4, 3, 4}, {}})},
                  "part1: touches the part at part0 near (1 ");
    expectRefusal({unit, box({1, 0.125, 0}, {2, 1.125, 1})},
                  "part1: touches the part at part0 near (1 ");
    expectRefusal({unit, box({1, 0, 0}, {2, 1, 1}), box({1.125, 0, 1}, {2.125, 1, 2})},
                  "part2: touches the part at part1 near (");
    expectRefusal({unit, box({1.02, 0, 0}, {2.02, 1, 1})},
                  "part1: misses the part at part0 by 0.02 m near (1");
    expectRefusal({unit, box({1, 0, 0}, {2, 1, 1}), box({5, 0, 0}, {6, 1, 1})},
                  "part2: misses the other parts: no face is common with one of them; the nearest "
                  "is that at part1, 3 m from (5 0 0)");
    // An edge is not enough.
    expectRefusal({unit, box({1, 1, 0}, {2, 2, 1})}, "part1: misses the other parts");
}

TEST(RenamePatch, unitesPatchesOfTheSameName) {
    BlockMeshDescription part = box({0, 0, 0}, {1, 1, 1});
    renamePatch(part, "xMin", "walls");
    renamePatch(part, "zMax", "walls");
    const PolyMesh mesh = blockMesh(part);
    ASSERT_EQ(mesh.patches.size(), 5U);
    EXPECT_EQ(mesh.patches[0].name, "walls");
    EXPECT_EQ(mesh.patches[0].size, 32);
}

} // namespace
} // namespace polymesh::test
