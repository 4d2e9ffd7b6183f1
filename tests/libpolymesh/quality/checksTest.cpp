// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// That the figures are OpenFOAM's own is tested in tests/tools/checkMeshTest.cpp.

#include "libpolymesh/quality/checks.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/threadLimit.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

namespace polymesh {
namespace {

constexpr CheckOptions everything{.allTopology = true, .allGeometry = true};

using Names = std::vector<std::string>;

TEST(CheckMesh, acceptsABox) {
    const MeshReport report = checkMesh(test::box(3, 4, 5, {3, 4, 5}), everything);
    EXPECT_TRUE(report.isOk());
    EXPECT_NEAR(report.figures.volume, 60, 1e-12);
    EXPECT_NEAR(report.figures.boundaryArea, 2 * (12 + 15 + 20), 1e-12);
    EXPECT_NEAR(*report.figures.maxNonOrthogonality, 0, 1e-5);
    EXPECT_NEAR(report.figures.edgeLength.min, 1, 1e-15);
    EXPECT_EQ(report.shapes[StandardShape::hexahedron], 60);
    EXPECT_EQ(report.topology.regionSizes, std::vector<Label>{60});
}

TEST(CheckMesh, doesOnlyWhatIsAsked) {
    const MeshReport report = checkMesh(test::box(2, 2, 2), {});
    EXPECT_TRUE(report[CheckId::skewness].done);
    EXPECT_FALSE(report[CheckId::zipUp].done);
    EXPECT_FALSE(report[CheckId::determinant].done);
    EXPECT_FALSE(report.figures.minFlatness.has_value());
}

TEST(CheckMesh, acceptsAnEmptyMesh) {
    const MeshReport report = checkMesh({}, everything);
    EXPECT_TRUE(report.isOk());
    EXPECT_EQ(report.figures.volume, 0);
    EXPECT_FALSE(report.figures.maxNonOrthogonality.has_value());
}

TEST(CheckMesh, findsAnOpenCell) {
    const MeshReport report = checkMesh(test::openCell(), everything);
    EXPECT_TRUE(report[CheckId::zipUp].failed);
    EXPECT_EQ(report[CheckId::zipUp].offenders, std::vector<Label>{0});
    EXPECT_TRUE(report[CheckId::boundaryOpenness].failed);
    EXPECT_TRUE(report[CheckId::cellOpenness].failed);
}

TEST(CheckMesh, findsACellInsideOut) {
    const MeshReport report = checkMesh(test::invertedCell(), {});
    EXPECT_EQ(report.failed(), (Names{"aspectRatio", "cellVolume", "facePyramids"}));
    EXPECT_EQ(report[CheckId::facePyramids].count, 6);
    EXPECT_EQ(report[CheckId::cellVolume].worst.front().value, report.figures.volume);
}

TEST(CheckMesh, namesTheWorstFirstWithItsPlace) {
    PolyMesh mesh = test::box(4, 4, 4);
    mesh.points[index(2 + 5 * (2 + 5 * 2))] += Vec3{0.6, 0, 0}; // past its neighbour
    const MeshReport report = checkMesh(mesh, {});
    const CheckResult& result = report[CheckId::facePyramids];
    ASSERT_TRUE(result.failed);
    ASSERT_LE(result.worst.size(), 5U);
    for (std::size_t i = 1; i < result.worst.size(); ++i)
        EXPECT_LE(result.worst[i - 1].value, result.worst[i].value);
    EXPECT_NEAR(norm(result.worst[0].position - Vec3{0.8, 0.5, 0.5}), 0, 0.5);
    EXPECT_EQ(mesh.owner[index(result.worst[0].element)], result.worst[0].cell);
}

TEST(CheckMesh, countsHangingNodesAsConcave) {
    const MeshReport report = checkMesh(test::hangingNodes(), everything);
    EXPECT_EQ(report[CheckId::concaveCells].offenders, std::vector<Label>{4});
    EXPECT_EQ(report.shapes[StandardShape::polyhedron], 1);
    EXPECT_EQ(report.shapes.polyhedraByFaceCount.at(9), 1);
}

TEST(CheckMesh, doesNotJudgeNonOrthogonalityBelowNinetyDegrees) {
    PolyMesh mesh = test::box(1, 1, 2, {1, 1, 0.2});
    for (Vec3& p : mesh.points)
        p.x += 40 * p.z; // sheared by 88.6 degrees
    const MeshReport report = checkMesh(mesh, {});
    EXPECT_GT(*report.figures.maxNonOrthogonality, 80);
    EXPECT_EQ(report.figures.severeNonOrthogonality, 1);
    EXPECT_FALSE(report[CheckId::nonOrthogonality].failed);
    EXPECT_EQ(report[CheckId::nonOrthogonality].offenders, std::vector<Label>{0});
}

TEST(CheckMesh, refusesLabelsOutOfRange) {
    PolyMesh mesh = test::unitCube();
    mesh.owner[3] = 7;
    EXPECT_THROW(checkMesh(mesh, {}), InputError);
    mesh = test::unitCube();
    mesh.patches[0].size = 1000;
    EXPECT_THROW(checkMesh(mesh, {}), InputError);
}

TEST(CheckMesh, survivesFacesWithoutExtentAndCellsWithoutFaces) {
    PolyMesh mesh = test::box(2, 1, 1);
    for (Vec3& p : mesh.points)
        p = {};
    ++mesh.cellCount;
    const MeshReport report = checkMesh(mesh, everything);
    EXPECT_TRUE(report[CheckId::cellFaces].failed);
    EXPECT_TRUE(report[CheckId::faceArea].failed);
    EXPECT_TRUE(report[CheckId::cellVolume].failed);
}

TEST(CheckMesh, survivesFacesWithFewPoints) {
    PolyMesh mesh;
    mesh.points.assign(2, Vec3{});
    mesh.faces.add(std::vector<Label>{});
    mesh.faces.add(std::vector<Label>{0});
    mesh.faces.add(std::vector<Label>{0, 1});
    mesh.faces.add(std::vector<Label>{0, 1, 0, 1});
    mesh.owner.assign(4, 0);
    mesh.cellCount = 1;
    mesh.patches.push_back({"wedge", "wedge", 0, 4, {}});
    EXPECT_FALSE(checkMesh(mesh, everything).isOk());
}

TEST(CheckMesh, isEqualForAnyNumberOfThreads) {
    const PolyMesh mesh = test::jittered(test::box(16, 16, 16), 0.02);
    const auto summary = [&](std::size_t threads) {
        const ThreadLimit limit(threads);
        const MeshReport report = checkMesh(mesh, everything);
        std::vector<double> numbers{report.figures.volume,
                                    report.figures.averageNonOrthogonality,
                                    report.figures.maxSkewness,
                                    report.figures.averageDeterminant,
                                    report.figures.averageFaceWeight,
                                    report.figures.averageFlatness};
        for (const CheckResult& result : report.results)
            for (const Label offender : result.offenders)
                numbers.push_back(static_cast<double>(offender));
        return numbers;
    };
    EXPECT_EQ(summary(1), summary(4));
}

TEST(StandardShape, isThatOfTheSupportsMeshes) {
    const auto only = [](const PolyMesh& mesh) {
        const ShapeCounts counts = checkMesh(mesh, {}).shapes;
        for (std::size_t i = 0; i < standardShapeCount; ++i)
            if (counts.cells[i] == mesh.cellCount) return static_cast<StandardShape>(i);
        return StandardShape::polyhedron;
    };
    EXPECT_EQ(only(test::unitCube()), StandardShape::hexahedron);
    EXPECT_EQ(only(test::prismFan(5)), StandardShape::prism);
    EXPECT_EQ(only(test::wedge()), StandardShape::wedge);
    EXPECT_EQ(only(test::pyramid()), StandardShape::pyramid);
    EXPECT_EQ(only(test::tetrahedron()), StandardShape::tetrahedron);
    EXPECT_EQ(only(test::lShapedCell()), StandardShape::polyhedron);
    const PolyMesh tetWedge = test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}},
                                           {{{0, 2, 1}, {0, 1, 3}, {0, 3, 4, 2}, {1, 2, 4, 3}}});
    EXPECT_EQ(only(tetWedge), StandardShape::tetWedge);
}

TEST(PatchTopology, tellsClosedFromOpenFromShared) {
    const PolyMesh cube = test::unitCube();
    std::vector<Label> faces{0, 1, 2, 3, 4, 5};
    EXPECT_EQ(patchTopology(cube, "p", faces).kind, SurfaceKind::closed);
    faces.pop_back();
    const PatchTopology open = patchTopology(cube, "p", faces);
    EXPECT_EQ(open.kind, SurfaceKind::open);
    EXPECT_EQ(open.points, 8);
    EXPECT_EQ(patchTopology(cube, "p", {}).kind, SurfaceKind::empty);

    // Two cubes that share one point, then one edge.
    const PolyMesh grid = test::box(2, 2, 2);
    const auto hex = [](Label i, Label j, Label k) {
        const auto at = [](Label a, Label b, Label c) { return a + 3 * (b + 3 * c); };
        return test::hexahedron({at(i, j, k),
                                 at(i + 1, j, k),
                                 at(i + 1, j + 1, k),
                                 at(i, j + 1, k),
                                 at(i, j, k + 1),
                                 at(i + 1, j, k + 1),
                                 at(i + 1, j + 1, k + 1),
                                 at(i, j + 1, k + 1)});
    };
    const auto kindOf = [&](const test::Polyhedron& a, const test::Polyhedron& b) {
        return checkMesh(test::meshOf(grid.points, {a, b}), {}).topology.patches[0];
    };
    const PatchTopology point = kindOf(hex(0, 0, 0), hex(1, 1, 1));
    EXPECT_EQ(point.kind, SurfaceKind::sharedPoint);
    EXPECT_EQ(point.conflictingPoints, std::vector<Label>{13});
    const PatchTopology edge = kindOf(hex(0, 0, 0), hex(1, 1, 0));
    EXPECT_EQ(edge.kind, SurfaceKind::sharedEdge);
    EXPECT_EQ(edge.conflictingPoints, (std::vector<Label>{4, 13}));
}

} // namespace
} // namespace polymesh
