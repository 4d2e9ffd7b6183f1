// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/blocks.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/threadLimit.h"
#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace polymesh::test {
namespace {

/// The unit cube as one block.
BlockMeshDescription cube(std::array<Label, 3> cells) {
    BlockMeshDescription d;
    d.vertices = {
        {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    d.blocks.push_back({{0, 1, 2, 3, 4, 5, 6, 7}, cells, {}, "", "cube:1"});
    return d;
}

/// A second cube at x in [1, 2], its corners numbered from another one on.
BlockMeshDescription twoCubes(std::array<Label, 3> first, std::array<Label, 8> order) {
    BlockMeshDescription d = cube(first);
    for (const Vec3& p : std::vector<Vec3>{{2, 0, 0}, {2, 1, 0}, {2, 0, 1}, {2, 1, 1}})
        d.vertices.push_back(p);
    // corners of the second cube in the usual order: x min side is the first one's x max side
    const std::array<Label, 8> corners{1, 8, 9, 2, 5, 10, 11, 6};
    Block second;
    for (std::size_t c = 0; c < 8; ++c)
        second.vertices[c] = corners[index(order[c])];
    second.where = "cube:2";
    d.blocks.push_back(second);
    return d;
}

double volume(const PolyMesh& mesh) {
    const MeshGeometry geometry = computeGeometry(mesh);
    double sum = 0;
    for (const double v : geometry.cellVolumes)
        sum += v;
    return sum;
}

void expectError(const BlockMeshDescription& description, const std::string& part) {
    try {
        blockMesh(description);
        FAIL() << "expected: " << part;
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST(Blocks, oneBlockIsTheCartesianBox) {
    const PolyMesh mesh = blockMesh(cube({3, 4, 2}));
    const PolyMesh box = cartesianMesh({{{0, 0, 0}, {1, 1, 1}}, {3, 4, 2}});
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_EQ(mesh.neighbour, box.neighbour);
    EXPECT_EQ(mesh.cellCount, 24);
    ASSERT_EQ(mesh.points.size(), box.points.size());
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
        EXPECT_NEAR(norm(mesh.points[p] - box.points[p]), 0, 1e-15);
}

/// All 24 ways to number the corners of the second cube.
TEST(Blocks, meetWhateverTheirOrientation) {
    // turns about z and about x, as permutations of the corners
    const std::array<std::size_t, 8> aboutZ{1, 2, 3, 0, 5, 6, 7, 4};
    const std::array<std::size_t, 8> aboutX{4, 5, 1, 0, 7, 6, 2, 3};
    std::array<Label, 8> order{0, 1, 2, 3, 4, 5, 6, 7};
    const std::array<Label, 3> counts{2, 3, 4}; // of the second cube along x, y, z of space
    std::mt19937 random(1);
    for (int repeat = 0; repeat < 60; ++repeat) {
        BlockMeshDescription d = twoCubes({2, 3, 4}, order);
        // the direction of space along each edge of the second block
        Block& second = d.blocks[1];
        const std::array<std::size_t, 3> ends{1, 3, 4};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Vec3 edge = d.vertices[index(second.vertices[ends[axis]])] -
                              d.vertices[index(second.vertices[0])];
            second.cells[axis] = counts[edge.x != 0 ? 0 : edge.y != 0 ? 1 : 2];
        }
        const PolyMesh mesh = blockMesh(d);
        EXPECT_TRUE(validate(mesh).empty());
        EXPECT_EQ(mesh.pointCount(), 5 * 4 * 5);
        EXPECT_EQ(mesh.internalFaceCount(), 3 * 3 * 4 + 4 * 2 * 4 + 4 * 3 * 3);
        EXPECT_NEAR(volume(mesh), 2, 1e-12);
        std::array<Label, 8> turned{};
        const bool z = random() % 2 == 0;
        for (std::size_t c = 0; c < 8; ++c)
            turned[c] = order[(z ? aboutZ : aboutX)[c]];
        order = turned;
    }
}

TEST(Blocks, gradedEdgesThatDifferStillFillTheBlock) {
    BlockMeshDescription d = cube({6, 5, 4});
    std::mt19937 random(2);
    std::uniform_real_distribution<double> ratio(0.2, 5);
    for (Grading& grading : d.blocks[0].grading)
        grading = {{1, 1, ratio(random)}};
    const PolyMesh mesh = blockMesh(d);
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_NEAR(volume(mesh), 1, 1e-12);
}

TEST(Blocks, interiorFollowsCurvedEdges) {
    // The cube between two coaxial quarter circles: all points lie on circles about the axis.
    BlockMeshDescription d;
    const double r = 2;
    d.vertices = {
        {1, 0, 0}, {r, 0, 0}, {0, r, 0}, {0, 1, 0}, {1, 0, 1}, {r, 0, 1}, {0, r, 1}, {0, 1, 1}};
    d.blocks.push_back({{0, 1, 2, 3, 4, 5, 6, 7}, {4, 8, 2}, {}, "", "ring:1"});
    for (const Label z : {0, 4}) {
        d.edges.push_back({{z, z + 3}, arcAbout({0, 0, z / 4.0}, "ring:2")});
        d.edges.push_back({{z + 2, z + 1}, arcAbout({0, 0, z / 4.0}, "ring:3")});
    }
    const PolyMesh mesh = blockMesh(d);
    EXPECT_TRUE(validate(mesh).empty());
    for (const Vec3& p : mesh.points) {
        const double radius = std::hypot(p.x, p.y);
        EXPECT_NEAR(radius * 4, std::round(radius * 4), 1e-12);
    }
}

TEST(Blocks, projectedSideLiesOnItsShape) {
    BlockMeshDescription d = cube({4, 4, 3});
    ProjectedSide top;
    top.side.vertices = {4, 5, 6, 7};
    top.shape = sphereShape({0.5, 0.5, 0.5}, std::sqrt(0.75));
    d.projectedSides.push_back(top);
    const PolyMesh mesh = blockMesh(d);
    EXPECT_TRUE(validate(mesh).empty());
    double highest = 0;
    for (const Vec3& p : mesh.points)
        highest = std::max(highest, p.z);
    EXPECT_NEAR(highest, 0.5 + std::sqrt(0.75), 1e-12); // above the middle of the side
    EXPECT_GT(volume(mesh), 1.1);
}

TEST(Blocks, collapsedEdgeMakesPrisms) {
    BlockMeshDescription d = cube({3, 2, 4});
    d.blocks[0].vertices = {0, 1, 2, 0, 4, 5, 6, 4}; // the y edges at x = 0 have no length
    d.patches.push_back({{"axis", "empty", 0, 0, {}}, {{{0, 4, 4, 0}, "d:1"}}});
    const PolyMesh mesh = blockMesh(d);
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_EQ(mesh.patches[0].size, 0);
    EXPECT_NEAR(volume(mesh), 0.5, 1e-12);
    EXPECT_EQ(mesh.pointCount(), (1 + 3 * 3) * 5);
}

TEST(Blocks, patchesZonesAndDefaultPatch) {
    BlockMeshDescription d = twoCubes({2, 2, 2}, {0, 1, 2, 3, 4, 5, 6, 7});
    d.blocks[1].cells = {3, 2, 2};
    d.blocks[1].zone = "right";
    d.patches.push_back({{"end", "wall", 0, 0, {}}, {{{8, 9, 11, 10}, "d:1"}}});
    d.scale = 0.5;
    const PolyMesh mesh = blockMesh(d);
    ASSERT_EQ(mesh.patches.size(), 2U);
    EXPECT_EQ(mesh.patches[0].size, 4);
    EXPECT_EQ(mesh.patches[1].name, "defaultFaces");
    EXPECT_EQ(mesh.patches[1].size, 4 * (2 * 2 + 3 * 2) + 4);
    ASSERT_EQ(mesh.cellZones.size(), 1U);
    EXPECT_EQ(mesh.cellZones[0].labels.front(), 8);
    EXPECT_EQ(mesh.cellZones[0].labels.size(), 12U);
    EXPECT_NEAR(volume(mesh), 0.25, 1e-12);
}

TEST(Blocks, mergedPatchesBecomeInternal) {
    BlockMeshDescription d = cube({2, 2, 2});
    for (std::size_t v = 0; v < 8; ++v) // a second cube with vertices of its own
        d.vertices.push_back(d.vertices[v] + Vec3{1, 0, 0});
    d.blocks.push_back({{8, 9, 10, 11, 12, 13, 14, 15}, {2, 2, 2}, {}, "", "d:2"});
    d.patches.push_back({{"a", "patch", 0, 0, {}}, {{{1, 2, 6, 5}, "d:3"}}});
    d.patches.push_back({{"b", "patch", 0, 0, {}}, {{{8, 11, 15, 12}, "d:4"}}});
    d.mergePairs.push_back({"a", "b", "d:5"});
    const PolyMesh mesh = blockMesh(d);
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_EQ(mesh.pointCount(), 5 * 3 * 3);
    EXPECT_EQ(mesh.internalFaceCount(), 3 * 4 + 2 * 4 * 2);
    EXPECT_EQ(mesh.patches.size(), 1U);
    d.blocks[1].cells = {2, 3, 2};
    expectError(d, "d:5: mergePatchPairs (a b): merging patches is not supported when faces of");
}

/// Either patch may be the larger one.
TEST(Blocks, whatMergingLeavesOverStaysInItsPatch) {
    BlockMeshDescription d = cube({2, 2, 2});
    for (std::size_t v = 0; v < 8; ++v) // half as high
        d.vertices.push_back(Vec3{1 + d.vertices[v].x, d.vertices[v].y, 0.5 * d.vertices[v].z});
    d.blocks.push_back({{8, 9, 10, 11, 12, 13, 14, 15}, {2, 2, 1}, {}, "", "d:2"});
    d.patches.push_back({{"large", "patch", 0, 0, {}}, {{{1, 2, 6, 5}, "d:3"}}});
    d.patches.push_back({{"small", "patch", 0, 0, {}}, {{{8, 11, 15, 12}, "d:4"}}});
    for (const bool largeFirst : {true, false}) {
        d.mergePairs = {largeFirst ? PatchPair{"large", "small", "d:5"}
                                   : PatchPair{"small", "large", "d:5"}};
        const PolyMesh mesh = blockMesh(d);
        EXPECT_TRUE(validate(mesh).empty());
        ASSERT_EQ(mesh.patches.size(), 2U);
        EXPECT_EQ(mesh.patches[0].name, "large");
        EXPECT_EQ(mesh.patches[0].size, 2);
        EXPECT_EQ(mesh.internalFaceCount(), 12 + 4 + 2);
    }
}

TEST(Blocks, wrongDescriptionsAreRefusedWithTheirPlace) {
    BlockMeshDescription inside = cube({1, 1, 1});
    std::swap(inside.blocks[0].vertices[1], inside.blocks[0].vertices[3]);
    std::swap(inside.blocks[0].vertices[5], inside.blocks[0].vertices[7]);
    expectError(inside, "cube:1: this block is inside out");
    BlockMeshDescription counts = twoCubes({2, 2, 2}, {0, 1, 2, 3, 4, 5, 6, 7});
    expectError(counts, "cube:2: side (1 2 6 5) of this block has 1 x 1 cells");
    BlockMeshDescription grading = twoCubes({1, 4, 1}, {0, 1, 2, 3, 4, 5, 6, 7});
    grading.blocks[1].cells = {1, 4, 1};
    grading.blocks[1].grading[4] = {{1, 1, 20}};
    expectError(grading, "cube:2: the points on the side");
    BlockMeshDescription patch = twoCubes({1, 1, 1}, {0, 1, 2, 3, 4, 5, 6, 7});
    patch.patches.push_back({{"p", "patch", 0, 0, {}}, {{{1, 2, 6, 5}, "d:1"}}});
    expectError(patch, "d:1: patch p: side (1 2 6 5) lies between two blocks");
    patch.patches[0].sides[0].vertices = {0, 1, 2, 4};
    expectError(patch, "d:1: patch p: (0 1 2 4) is no side of a block");
}

TEST(Blocks, resultDoesNotDependOnTheThreads) {
    BlockMeshDescription d = twoCubes({8, 9, 10}, {0, 1, 2, 3, 4, 5, 6, 7});
    d.blocks[1].cells = {7, 9, 10};
    d.blocks[0].grading[0] = {{1, 1, 3}};
    PolyMesh one;
    {
        const ThreadLimit limit(1);
        one = blockMesh(d);
    }
    const ThreadLimit limit(4);
    EXPECT_EQ(blockMesh(d), one);
}

} // namespace
} // namespace polymesh::test
