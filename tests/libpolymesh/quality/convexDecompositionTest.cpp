// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/convexDecomposition.h"

#include "editMeshes.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/quality/greedyLoop.h"
#include "libpolymesh/quality/meshPart.h"
#include "libpolymesh/quality/starPoint.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace polymesh {

namespace {

constexpr double angle = 0.1; // [rad]

std::vector<double> volumesByOrigin(const PolyMesh& mesh, const std::vector<Label>& origins) {
    const MeshGeometry geometry = computeGeometry(mesh);
    std::vector<double> volumes;
    for (std::size_t c = 0; c < origins.size(); ++c) {
        volumes.resize(std::max(volumes.size(), index(origins[c]) + 1), 0);
        volumes[index(origins[c])] += geometry.cellVolumes[c];
    }
    return volumes;
}

std::vector<Label> allCells(const PolyMesh& mesh) {
    std::vector<Label> cells(index(mesh.cellCount));
    std::iota(cells.begin(), cells.end(), 0);
    return cells;
}

/// Decomposes all cells and checks what always has to hold.
DecompositionCounts decomposeAll(PolyMesh& mesh) {
    const std::vector<double> before = volumesByOrigin(mesh, allCells(mesh));
    std::vector<Label> origins;
    DecompositionCounts counts = decomposeCells(mesh, allCells(mesh), {angle, 40}, &origins);
    EXPECT_EQ(validate(mesh), std::vector<Defect>());
    EXPECT_EQ(concaveCells(mesh, angle), counts.remaining);
    EXPECT_EQ(toLabel(origins.size()), mesh.cellCount);
    const std::vector<double> after = volumesByOrigin(mesh, origins);
    EXPECT_EQ(after.size(), before.size());
    for (std::size_t c = 0; c < before.size(); ++c)
        EXPECT_NEAR(after[c], before[c], 1e-12 * before[c]) << c;
    for (const double volume : computeGeometry(mesh).cellVolumes)
        EXPECT_GT(volume, 0);
    return counts;
}

/// A prism of height 1 on a polygon that runs counter-clockwise.
PolyMesh prismOn(const std::vector<std::array<double, 2>>& corners, Label layers = 1) {
    const Label n = toLabel(corners.size());
    std::vector<Vec3> points;
    for (Label k = 0; k <= layers; ++k)
        for (const auto& c : corners)
            points.push_back({c[0], c[1], static_cast<double>(k)});
    std::vector<test::Polyhedron> cells;
    for (Label k = 0; k < layers; ++k) {
        test::Polyhedron cell(2);
        for (Label i = 0; i < n; ++i) {
            cell[0].push_back(k * n + n - 1 - i);
            cell[1].push_back((k + 1) * n + i);
            cell.push_back(
                {k * n + i, k * n + (i + 1) % n, (k + 1) * n + (i + 1) % n, (k + 1) * n + i});
        }
        cells.push_back(cell);
    }
    return test::meshOf(points, cells);
}

const std::vector<std::array<double, 2>> crossCorners{
    {1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};

using Voxel = std::array<int, 3>;

Voxel operator+(const Voxel& a, const Voxel& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// A side of a voxel: the step to the voxel beyond it, and its corners.
struct VoxelSide {
    Voxel step;
    std::array<Voxel, 4> corners;
};

const std::array<VoxelSide, 6> voxelSides{{
    {{-1, 0, 0}, {{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}}},
    {{1, 0, 0}, {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}}},
    {{0, -1, 0}, {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}}},
    {{0, 1, 0}, {{{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}}},
    {{0, 0, -1}, {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}}},
    {{0, 0, 1}, {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}},
}};

/// The hull of the unit voxels of a 3 x 3 x 3 block for which `isIn`: one cell whose faces are the
/// unit squares between what is in and what is out. Which must be a ball.
PolyMesh voxelCell(const std::function<bool(int, int, int)>& isIn) {
    const auto in = [&](const Voxel& v) {
        return std::ranges::all_of(v, [](int x) { return x >= 0 && x < 3; }) &&
               isIn(v[0], v[1], v[2]);
    };
    std::map<Voxel, Label> labels;
    std::vector<Vec3> points;
    const auto at = [&](const Voxel& v) {
        const auto [found, isNew] = labels.try_emplace(v, toLabel(points.size()));
        if (isNew) points.push_back({1.0 * v[0], 1.0 * v[1], 1.0 * v[2]});
        return found->second;
    };
    test::Polyhedron cell;
    for (int n = 0; n < 27; ++n) {
        const Voxel voxel{n / 9, n / 3 % 3, n % 3};
        if (!in(voxel)) continue;
        for (const auto& [step, corners] : voxelSides) {
            if (in(voxel + step)) continue;
            cell.emplace_back();
            for (const Voxel& corner : corners)
                cell.back().push_back(at(voxel + corner));
        }
    }
    return test::meshOf(points, {cell});
}

/// Two triangles, the upper turned against the lower, and for each side the diagonal that makes it
/// fold inwards.
PolyMesh twistedPrism(double twist) {
    std::vector<Vec3> points;
    for (const double z : {0.0, 1.0})
        for (int i = 0; i < 3; ++i) {
            const double a = 2 * std::numbers::pi / 3 * i + z * twist;
            points.push_back({std::cos(a), std::sin(a), z});
        }
    test::Polyhedron cell{{2, 1, 0}, {3, 4, 5}};
    for (Label i = 0; i < 3; ++i) {
        const Label next = (i + 1) % 3;
        cell.push_back({i, next, i + 3});
        cell.push_back({next, next + 3, i + 3});
    }
    return test::meshOf(points, {cell});
}

TEST(ConcaveCells, areThoseWithReflexEdgesOrConcaveFaces) {
    EXPECT_EQ(concaveCells(test::lShapedCell(), angle), std::vector<Label>{0});
    EXPECT_EQ(concaveCells(test::box(3, 2, 2), angle), std::vector<Label>());
    EXPECT_EQ(concaveCells(test::hangingNodes(), angle), std::vector<Label>());
    EXPECT_EQ(concaveCells(prismOn(crossCorners, 2), angle), (std::vector<Label>{0, 1}));
}

TEST(GreedyLoop, prefersThePlaneLoopOfFewestSteps) {
    const PolyMesh mesh = test::lShapedCell();
    MeshPart part = partRound(mesh, allCells(mesh));
    MeshEditor editor(part.mesh);
    const auto loop = greedyLoop(editor, 0, {3, 9}, {{2, 3}, {3, 4}, {8, 9}, {9, 10}});
    ASSERT_TRUE(loop);
    ASSERT_EQ(loop->size(), 4U);
    std::set<Label> columns;
    for (const LoopCorner& corner : *loop)
        columns.insert(corner.point % 6);
    EXPECT_EQ(columns.size(), 2U); // both ends of two upright edges
    EXPECT_TRUE(columns.contains(3));
}

TEST(StarPoint, seesAllFacesOrIsNotFound) {
    const PolyMesh l = test::lShapedCell();
    MeshPart part = partRound(l, allCells(l));
    MeshEditor editor(part.mesh);
    const auto p = starPoint(editor, 0);
    ASSERT_TRUE(p);
    EXPECT_LT(std::max(p->x, p->y), 1);
    const std::vector<Label> pyramids = makePyramids(editor, 0, *p);
    EXPECT_EQ(pyramids.size(), 8U);
    double volume = 0;
    for (const Label c : pyramids) {
        EXPECT_GT(editor.cellGeometry(c).volume, 0);
        volume += editor.cellGeometry(c).volume;
    }
    EXPECT_NEAR(volume, 3, 1e-12);
    const PolyMesh u = voxelCell([](int i, int j, int k) { return k == 0 && (j == 0 || i != 1); });
    MeshPart uPart = partRound(u, allCells(u));
    MeshEditor uEditor(uPart.mesh);
    EXPECT_FALSE(starPoint(uEditor, 0));
}

TEST(DecomposeCells, countsThePointsInsideThatItNeeds) {
    // Twisted so far that no plane through an edge parts it well.
    PolyMesh mesh = twistedPrism(0.5);
    const DecompositionCounts counts = decomposeAll(mesh);
    EXPECT_EQ(counts.remaining, std::vector<Label>());
    EXPECT_EQ(mesh.pointCount(), 6 + counts.edgePoints + counts.cellPoints);
}

TEST(DecomposeCells, leavesCubesCutByAPlaneAsTheyAre) {
    std::mt19937 random(3);
    const auto uniform = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
    for (int n = 0; n < 200; ++n) {
        EditMesh cut = test::boxOfHexes({1, 1, 1}, 1.0);
        test::splitByPlane(cut, {uniform(), uniform(), uniform()}, 0.5 * uniform() + 0.25);
        MeshEditor editor(cut);
        for (Label c = 0; c < editor.cellCount(); ++c) {
            WorkBudget budget(1000);
            budget.startCell(0);
            if (editor.cell(c).isRemoved()) continue;
            EXPECT_EQ(decomposeCell(editor, c, {angle, 40}, budget).concaveCells, 0) << n;
        }
    }
}

TEST(DecomposeCells, leavesConvexCellsAsTheyAre) {
    for (PolyMesh mesh :
         {test::box(3, 2, 2), test::pyramid(), test::hangingNodes(), test::prismFan(7)}) {
        const PolyMesh before = mesh;
        EXPECT_EQ(decomposeAll(mesh).concaveCells, 0);
        EXPECT_EQ(mesh, before);
    }
}

TEST(DecomposeCells, cutsAnLInTwo) {
    PolyMesh mesh = test::lShapedCell();
    const DecompositionCounts counts = decomposeAll(mesh);
    EXPECT_EQ(counts.cuts, 1);
    EXPECT_EQ(counts.remaining, std::vector<Label>());
    EXPECT_EQ(mesh.cellCount, 2);
}

TEST(DecomposeCells, cutsACrossAlikeInAllLayers) {
    PolyMesh mesh = prismOn(crossCorners, 3);
    const DecompositionCounts counts = decomposeAll(mesh);
    EXPECT_EQ(counts.concaveCells, 3);
    EXPECT_EQ(counts.remaining, std::vector<Label>());
    EXPECT_LE(mesh.cellCount, 15);
}

TEST(DecomposeCells, handlesReflexEdgesThatMeetAtACorner) {
    // A corner voxel is missing: three meet. Two next to it too: two meet, in an L.
    PolyMesh three = voxelCell([](int i, int j, int k) {
        return i < 2 && j < 2 && k < 2 && !(i == 1 && j == 1 && k == 1);
    });
    EXPECT_EQ(decomposeAll(three).remaining, std::vector<Label>());
    PolyMesh two = voxelCell(
        [](int i, int j, int k) { return k == 0 ? i < 2 && j < 2 : k == 1 && i == 0 && j == 0; });
    EXPECT_EQ(decomposeAll(two).remaining, std::vector<Label>());
}

TEST(DecomposeCells, cutsCellsWithHolesThroughThemOpen) {
    PolyMesh ring = voxelCell([](int i, int j, int) { return i != 1 || j != 1; });
    EXPECT_EQ(decomposeAll(ring).remaining, std::vector<Label>());
    PolyMesh threeHoles =
        voxelCell([](int i, int j, int k) { return (i != 1) + (j != 1) + (k != 1) > 1; });
    EXPECT_EQ(decomposeAll(threeHoles).remaining, std::vector<Label>());
}

TEST(DecomposeCells, handlesTwistedPrisms) {
    for (const double twist : {0.3, 0.5, 0.8, -0.3, -0.5}) {
        PolyMesh mesh = twistedPrism(twist);
        EXPECT_EQ(decomposeAll(mesh).remaining, std::vector<Label>()) << twist;
    }
}

TEST(DecomposeCells, handlesRandomUnionsOfVoxels) {
    std::mt19937 random(7);
    int tried = 0;
    int left = 0;
    for (int n = 0; tried < 60; ++n) {
        std::array<bool, 27> in{};
        for (bool& voxel : in)
            voxel = random() % 100 < 60;
        PolyMesh mesh =
            voxelCell([&](int i, int j, int k) { return in[index(i + 3 * (j + 3 * k))]; });
        // Only balls: V - E + F = 2, no point or edge at which it hangs together, in one piece.
        if (!validate(mesh).empty()) continue;
        std::set<std::pair<Label, Label>> edges;
        for (Label f = 0; f < mesh.faceCount(); ++f)
            for (std::size_t i = 0; i < 4; ++i)
                edges.insert(std::minmax(mesh.faces[f][i], mesh.faces[f][(i + 1) % 4]));
        if (mesh.pointCount() + mesh.faceCount() != toLabel(edges.size()) + 2) continue;
        ++tried;
        left += !decomposeAll(mesh).remaining.empty();
    }
    EXPECT_EQ(left, 0);
}

TEST(DecomposeCells, keepsPatchesAndZones) {
    PolyMesh mesh = prismOn(crossCorners, 2);
    mesh.cellZones = {{"upper", {1}, {}}, {"all", {0, 1}, {}}};
    mesh.faceZones = {{"between", {0}, {true}}};
    const double area = norm(computeGeometry(mesh).faceAreas[0]);
    std::vector<Label> origins;
    decomposeCells(mesh, allCells(mesh), {angle, 40}, &origins);
    ASSERT_EQ(validate(mesh), std::vector<Defect>());
    std::vector<Label> upper;
    for (std::size_t c = 0; c < origins.size(); ++c)
        if (origins[c] == 1) upper.push_back(toLabel(c));
    EXPECT_EQ(mesh.cellZones[0].labels, upper);
    EXPECT_EQ(mesh.cellZones[1].labels, allCells(mesh));
    Vec3 sum;
    const MeshGeometry geometry = computeGeometry(mesh);
    ASSERT_EQ(mesh.faceZones[0].labels.size(), mesh.faceZones[0].flip.size());
    for (std::size_t i = 0; i < mesh.faceZones[0].labels.size(); ++i)
        sum += (mesh.faceZones[0].flip[i] ? -1.0 : 1.0) *
               geometry.faceAreas[index(mesh.faceZones[0].labels[i])];
    EXPECT_NEAR(norm(sum), area, 1e-12);
    EXPECT_LT(sum.z, 0); // as it was: flipped
}

} // namespace

} // namespace polymesh
