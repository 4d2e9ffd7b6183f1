// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/cellGeometry.h"

#include "libpolymesh/base/threadLimit.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

namespace polymesh {
namespace {

TEST(FaceGeometry, ofATriangleIsItsOwn) {
    const std::vector<Vec3> points{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
    const FaceGeometry face = faceGeometry(points, std::vector<Label>{0, 1, 2});
    EXPECT_DOUBLE_EQ(face.centre.x, 1);
    EXPECT_DOUBLE_EQ(face.centre.y, 1);
    EXPECT_EQ(face.area, (Vec3{0, 0, 4.5}));
}

TEST(FaceGeometry, ofAnLShapeIsExact) {
    const PolyMesh mesh = test::lShapedCell();
    const FaceGeometry top = faceGeometry(mesh.points, std::vector<Label>{6, 7, 8, 9, 10, 11});
    EXPECT_NEAR(top.area.z, 3, 1e-14);
}

TEST(FaceGeometry, weightsWithMagnitudesSoThatAConcaveFacesCentreIsOpenFoams) {
    // A dart: the fan's triangles at the reflex corner turn the other way, and still count as
    // positive weights.
    const std::vector<Vec3> points{{0, 0, 0}, {4, 4, 0}, {0, 1, 0}, {-4, 4, 0}};
    const FaceGeometry dart = faceGeometry(points, std::vector<Label>{0, 1, 2, 3});
    const Vec3 mean{0, 2.25, 0};
    Vec3 sum;
    double weight = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3& a = points[i];
        const Vec3& b = points[(i + 1) % 4];
        const double area = norm(cross(b - a, mean - a));
        sum += area * (a + b + mean);
        weight += area;
    }
    EXPECT_NEAR(dart.centre.y, sum.y / weight / 3, 1e-15);
    EXPECT_NEAR(dart.area.z, 4, 1e-14);
}

TEST(FaceGeometry, withoutExtentHasTheMeanAsItsCentre) {
    const std::vector<Vec3> points(4, Vec3{1, 2, 3});
    const FaceGeometry face = faceGeometry(points, std::vector<Label>{0, 1, 2, 3});
    EXPECT_EQ(face.centre, (Vec3{1, 2, 3}));
    EXPECT_EQ(face.area, Vec3{});
}

TEST(CellGeometry, ofStandardShapesHasTheTextbookVolume) {
    EXPECT_NEAR(test::volumeOf(test::unitCube()), 1, 1e-15);
    EXPECT_NEAR(test::volumeOf(test::tetrahedron()), 1.0 / 6, 1e-15);
    EXPECT_NEAR(test::volumeOf(test::pyramid()), 1.0 / 3, 1e-15);
    EXPECT_NEAR(test::volumeOf(test::lShapedCell()), 3, 1e-14);
    EXPECT_NEAR(test::volumeOf(test::hangingNodes()), 12, 1e-13);
    EXPECT_NEAR(test::volumeOf(test::prismFan(6)), 1.5 * std::sqrt(3.0), 1e-14);
}

TEST(CellGeometry, ofAPyramidHasItsCentreAtAQuarterOfTheHeight) {
    const MeshGeometry geometry = computeGeometry(test::pyramid());
    EXPECT_NEAR(geometry.cellCentres[0].z, 0.25, 1e-15);
    EXPECT_NEAR(geometry.cellCentres[0].x, 0.5, 1e-15);
}

TEST(CellGeometry, ofAnInvertedCellIsNegative) {
    EXPECT_NEAR(test::volumeOf(test::invertedCell()), -1, 1e-15);
}

TEST(CellGeometry, ofNothingIsNothing) {
    EXPECT_EQ(cellGeometry({}).volume, 0);
    EXPECT_TRUE(computeGeometry(PolyMesh{}).cellVolumes.empty());
}

TEST(MeshGeometry, fillsTheBoxWhateverTheJitter) {
    PolyMesh mesh = test::box(4, 5, 6, {1, 2, 3});
    EXPECT_NEAR(test::volumeOf(mesh), 6, 1e-13);
    const PolyMesh moved = test::jittered(mesh, 0.05);
    // The moved boundary is warped; no cell is asked for its volume.
    EXPECT_NEAR(test::volumeOf(moved), boundedVolume(moved), 1e-13);
    EXPECT_NEAR(boundedVolume(mesh), 6, 1e-13);
    EXPECT_EQ(boundedVolume(PolyMesh{}), 0);
}

TEST(MeshGeometry, isEqualForAnyNumberOfThreads) {
    const PolyMesh mesh = test::jittered(test::box(20, 20, 20), 0.01);
    MeshGeometry one;
    {
        const ThreadLimit limit(1);
        one = computeGeometry(mesh);
    }
    const ThreadLimit limit(4);
    const MeshGeometry four = computeGeometry(mesh);
    EXPECT_EQ(one.faceCentres, four.faceCentres);
    EXPECT_EQ(one.faceAreas, four.faceAreas);
    EXPECT_EQ(one.cellCentres, four.cellCentres);
    EXPECT_EQ(one.cellVolumes, four.cellVolumes);
}

} // namespace
} // namespace polymesh
