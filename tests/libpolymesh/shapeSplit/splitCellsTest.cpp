// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/splitCells.h"

#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/quality/checks.h"
#include "libpolymesh/reference/tetgen.h"
#include "libpolymesh/shapes/classify.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

namespace polymesh::test {

namespace {

Label unacceptable(const PolyMesh& mesh) {
    return census(classifyCells(mesh, cellFaces(mesh))).unrecognised;
}

/// Laws (1), (2), (5) of splitUnacceptableCells.
ShapeSplitCounts splitByTheLaws(PolyMesh& mesh, const ShapeSplitMeans& means = {}) {
    const double volume = volumeOf(mesh);
    const std::vector<double> before = computeGeometry(mesh).cellVolumes;
    std::vector<Label> origins;
    ShapeSplitCounts counts = splitUnacceptableCells(mesh, means, &origins);
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_NEAR(volumeOf(mesh), volume, 1e-13 * volume);
    const std::vector<double> after = computeGeometry(mesh).cellVolumes;
    EXPECT_GT(*std::ranges::min_element(after), 0);
    EXPECT_EQ(origins.size(), after.size());
    for (std::size_t c = 0; c < before.size(); ++c)
        EXPECT_EQ(origins[c], toLabel(c));
    EXPECT_TRUE(counts.remaining.empty());
    EXPECT_EQ(unacceptable(mesh), 0);
    return counts;
}

/// A prism of height 1 on a polygon that runs anticlockwise.
PolyMesh prismOn(const std::vector<std::array<double, 2>>& corners) {
    const Label n = toLabel(corners.size());
    std::vector<Vec3> points;
    for (const double z : {0.0, 1.0})
        for (const auto& c : corners)
            points.push_back({c[0], c[1], z});
    Polyhedron cell(2);
    for (Label i = 0; i < n; ++i) {
        cell[0].push_back(n - 1 - i);
        cell[1].push_back(n + i);
        cell.push_back({i, (i + 1) % n, (i + 1) % n + n, i + n});
    }
    return meshOf(points, {cell});
}

std::vector<std::array<double, 2>> circle(Label n) {
    std::vector<std::array<double, 2>> corners;
    for (Label i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        corners.push_back({std::cos(angle), std::sin(angle)});
    }
    return corners;
}

/// A cube beside four of half its size: it has nine faces and points in the middle of edges.
PolyMesh refinedNeighbour() {
    PolyMesh fine = box(1, 2, 2, {0.5, 1, 1});
    std::vector<Vec3> points = fine.points;
    std::vector<Polyhedron> cells(4);
    const auto addFace = [&](Label f, Label cell, bool turned) {
        Polygon loop(fine.faces[f].begin(), fine.faces[f].end());
        if (turned) std::ranges::reverse(loop);
        cells[index(cell)].push_back(loop);
    };
    for (Label f = 0; f < fine.faceCount(); ++f) {
        addFace(f, fine.owner[index(f)], false);
        if (fine.isInternal(f)) addFace(f, fine.neighbour[index(f)], true);
    }
    const auto at = [&](double x, double y, double z) {
        for (std::size_t p = 0; p < points.size(); ++p)
            if (points[p] == Vec3{x, y, z}) return toLabel(p);
        points.push_back({x, y, z});
        return toLabel(points.size() - 1);
    };
    const auto far = [&](double y, double z) { return at(-1, y, z); };
    const auto near = [&](double y, double z) { return at(0, y, z); };
    Polyhedron coarse{{far(0, 0), far(0, 1), far(1, 1), far(1, 0)}};
    coarse.push_back({far(0, 0), near(0, 0), near(0, 0.5), near(0, 1), far(0, 1)});
    coarse.push_back({far(1, 0), far(1, 1), near(1, 1), near(1, 0.5), near(1, 0)});
    coarse.push_back({far(0, 0), far(1, 0), near(1, 0), near(0.5, 0), near(0, 0)});
    coarse.push_back({far(0, 1), near(0, 1), near(0.5, 1), near(1, 1), far(1, 1)});
    for (const double y : {0.0, 0.5})
        for (const double z : {0.0, 0.5})
            coarse.push_back(
                {near(y, z), near(y + 0.5, z), near(y + 0.5, z + 0.5), near(y, z + 0.5)});
    cells.push_back(coarse);
    return meshOf(points, cells);
}

std::multiset<std::set<Label>> faceSets(const PolyMesh& mesh, Label faces) {
    std::multiset<std::set<Label>> sets;
    for (Label f = 0; f < faces; ++f)
        sets.emplace(mesh.faces[f].begin(), mesh.faces[f].end());
    return sets;
}

TEST(SplitCells, leavesAcceptableCellsAlone) {
    PolyMesh mesh = box(3, 2, 2);
    const PolyMesh before = mesh;
    EXPECT_EQ(splitByTheLaws(mesh).splitCells, 0);
    EXPECT_EQ(mesh, before);
}

TEST(SplitCells, makesPyramidsRoundOnePointWithoutTouchingSharedFaces) {
    PolyMesh mesh = refinedNeighbour();
    const PolyMesh before = mesh;
    ASSERT_TRUE(validate(mesh).empty());
    ASSERT_EQ(unacceptable(mesh), 1);
    const ShapeSplitCounts counts = splitByTheLaws(mesh);
    EXPECT_EQ(counts.newCells, 8);
    EXPECT_EQ(counts.newPoints, 1);
    const auto after = faceSets(mesh, mesh.faceCount());
    for (const auto& face : faceSets(before, before.faceCount()))
        EXPECT_EQ(after.count(face), 1U);
}

TEST(SplitCells, cutsPlaneFacesThatAreTooLarge) {
    for (const Label n : {7, 9, 12, 20}) {
        PolyMesh mesh = prismOn(circle(n));
        EXPECT_EQ(splitByTheLaws(mesh).splitFaces, 2) << n;
    }
}

TEST(SplitCells, keepsTheVolumeBehindWarpedFaces) {
    PolyMesh mesh = jittered(prismOn(circle(11)), 0.05);
    EXPECT_EQ(splitByTheLaws(mesh).splitFaces, 2);
}

TEST(SplitCells, cutsCellsOfWhichNoPointSeesAllFaces) {
    PolyMesh mesh = prismOn({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}); // U
    EXPECT_GT(splitByTheLaws(mesh).cutCells, 0);
}

TEST(SplitCells, takesBentCells) {
    for (unsigned seed = 1; seed <= 30; ++seed) {
        PolyMesh mesh = jittered(refinedNeighbour(), 0.12, seed);
        ASSERT_TRUE(checkMesh(mesh, {}).isOk());
        splitByTheLaws(mesh);
        EXPECT_TRUE(checkMesh(mesh, {}).isOk()) << seed;
    }
}

TEST(SplitCells, piecesOfVeryBentCellsPassCheckMesh) {
    if (!hasTetgen()) GTEST_SKIP() << "built without TetGen";
    int good = 0;
    for (unsigned seed = 1; seed <= 400; ++seed) {
        PolyMesh mesh = jittered(refinedNeighbour(), 0.3, seed);
        if (!checkMesh(mesh, {}).isOk()) continue;
        ++good;
        splitByTheLaws(mesh, {{}, tetgenTetrahedraliser()});
        EXPECT_TRUE(checkMesh(mesh, {}).isOk()) << seed;
    }
    EXPECT_GT(good, 20);
}

TEST(SplitCells, partsBelongToTheZonesAndPatchesOfTheWhole) {
    PolyMesh mesh = refinedNeighbour();
    mesh.cellZones.push_back({"coarse", {4}, {}});
    const std::vector<Patch> patches = mesh.patches;
    splitByTheLaws(mesh);
    EXPECT_EQ(mesh.cellZones[0].labels.size(), 9U);
    ASSERT_EQ(mesh.patches.size(), patches.size());
    EXPECT_EQ(mesh.patches[0].size, patches[0].size);
}

TEST(SplitCells, dividesWhatPlanesDoNotWithTetrahedra) {
    if (!hasTetgen()) GTEST_SKIP() << "built without TetGen";
    for (unsigned seed = 1; seed <= 20; ++seed) {
        // Zigzags, of which no point sees all sides, with warped sides.
        std::vector<std::array<double, 2>> corners;
        for (int i = 0; i <= 4; ++i)
            corners.push_back({i % 2 == 0 ? 0.0 : 2.0, 1.0 * i});
        for (int i = 4; i >= 0; --i)
            corners.push_back({i % 2 == 0 ? 1.0 : 3.0, 1.0 * i});
        std::ranges::reverse(corners);
        PolyMesh mesh = jittered(prismOn(corners), 0.05, seed);
        const ShapeSplitCounts counts = splitByTheLaws(mesh, {{}, tetgenTetrahedraliser()});
        EXPECT_EQ(counts.filledCells, 1) << seed;
        EXPECT_EQ(counts.foldedCells, 0) << seed;
    }
}

TEST(SplitCells, givesTheSameMeshAgain) {
    PolyMesh one = jittered(prismOn(circle(13)), 0.03);
    PolyMesh two = one;
    splitUnacceptableCells(one);
    splitUnacceptableCells(two);
    EXPECT_EQ(one, two);
}

} // namespace

} // namespace polymesh::test
