// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/triangleHull.h"

#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/mps/mendFlat.h"
#include "libpolymesh/mps/triangulatedFaces.h"
#include "libpolymesh/reference/tetgen.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

namespace polymesh {

namespace {

/// The triangles of the only cell of a mesh, such as its faces may have.
TriangleHull hullOf(const PolyMesh& mesh) {
    const SubdivisionPlan plan = planSubdivision(mesh);
    const auto faces = plan.cellFaces[0];
    const TriangulatedFaces triangles(mesh, plan, {faces.begin(), faces.end()});
    return triangles.hullOf(Label{0});
}

/// A mesh of one cell with the triangles of a hull.
PolyMesh cellOf(const TriangleHull& hull) {
    test::Polyhedron faces;
    for (const Triangle& t : hull.triangles)
        faces.emplace_back(t.begin(), t.end());
    return test::meshOf(hull.points, {faces});
}

/// A box with a pit from above and one from below, beside each other: no point sees both.
PolyMesh pits() {
    return test::meshOf({{0, 0, 0},
                         {2, 0, 0},
                         {2, 2, 0},
                         {0, 2, 0},
                         {0, 0, 1},
                         {2, 0, 1},
                         {2, 2, 1},
                         {0, 2, 1},
                         {0.5, 1, 0.4},
                         {1.5, 1, 0.6}},
                        {{{1, 0, 9},
                          {2, 1, 9},
                          {3, 2, 9},
                          {0, 3, 9},
                          {0, 1, 5, 4},
                          {1, 2, 6, 5},
                          {2, 3, 7, 6},
                          {3, 0, 4, 7},
                          {4, 5, 8},
                          {5, 6, 8},
                          {6, 7, 8},
                          {7, 4, 8}}});
}

double volumeOf(const std::vector<Vec3>& points, const std::array<Label, 4>& t) {
    const Vec3& a = points[index(t[0])];
    return dot(cross(points[index(t[1])] - a, points[index(t[2])] - a), points[index(t[3])] - a) /
           6;
}

} // namespace

TEST(TriangleHull, aPointWithinSeesAllOfACube) {
    const TriangleHull hull = hullOf(test::unitCube());
    EXPECT_EQ(hull.triangles.size(), 12U);
    const auto point = pointThatSees(hull);
    ASSERT_TRUE(point);
    EXPECT_NEAR(norm(*point - Vec3{0.5, 0.5, 0.5}), 0, 0.3);
    EXPECT_EQ(crossingsOf(hull), 0);
}

TEST(TriangleHull, noPointSeesATwoSidedNotch) {
    const PolyMesh mesh = test::lShapedCell();
    EXPECT_TRUE(pointThatSees(hullOf(mesh))); // from the corner of the L
    TriangleHull hull = hullOf(test::unitCube());
    hull.points[0] = {2, 2, 2}; // turned inside out
    EXPECT_FALSE(pointThatSees(hull));
    EXPECT_GT(crossingsOf(hull), 0);
}

TEST(TriangleHull, tetrahedraFillACellOfTrianglesAndKeepItsVolume) {
    if (!hasTetgen()) GTEST_SKIP() << "built without TetGen";
    const TriangleHull hull = hullOf(pits());
    EXPECT_FALSE(pointThatSees(hull));
    EXPECT_EQ(crossingsOf(hull), 0);
    PolyMesh mesh = cellOf(hull);
    const double volume = test::volumeOf(pits());
    const auto cones = tetrahedraIn(0, hullOf(mesh), tetgenTetrahedraliser());
    ASSERT_TRUE(cones);
    mesh = withCones(mesh, cellFaces(mesh), std::vector{*cones});
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_GT(mesh.cellCount, 1);
    EXPECT_NEAR(test::volumeOf(mesh), volume, 1e-14);
    for (const double cell : computeGeometry(mesh).cellVolumes)
        EXPECT_GT(cell, 0);
    EXPECT_TRUE(planSubdivision(mesh).inverted.empty());
}

TEST(TriangleHull, insideOutHasNoTetrahedra) {
    if (!hasTetgen()) GTEST_SKIP() << "built without TetGen";
    TriangleHull hull = hullOf(test::unitCube());
    ASSERT_TRUE(tetrahedraIn(0, hull, tetgenTetrahedraliser()));
    for (Triangle& t : hull.triangles)
        std::swap(t[0], t[1]);
    EXPECT_FALSE(tetrahedraIn(0, hull, tetgenTetrahedraliser()));
}

TEST(TriangleHull, withoutATetrahedraliserOrWithAWrongOneThereAreNoTetrahedra) {
    const TriangleHull hull = hullOf(test::unitCube());
    EXPECT_FALSE(tetrahedraIn(0, hull, {}));
    const auto one = [](const TriSurface&) { return TetMesh{{}, {{0, 1, 2, 4}}}; };
    EXPECT_FALSE(tetrahedraIn(0, hull, one));
    const auto beyond = [](const TriSurface&) { return TetMesh{{}, {{0, 1, 2, 99}}}; };
    EXPECT_FALSE(tetrahedraIn(0, hull, beyond));
}

TEST(MendFlat, aFlatTetrahedronOnTwoTrianglesGoesAndTheVolumeStays) {
    // A pyramid on the square 0 1 2 3; the flat one turns the diagonal round under it.
    std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, -1e-12}, {0, 1, 0}, {0.5, 0.5, 1}};
    TetMesh mesh{{}, {{0, 1, 3, 4}, {1, 2, 3, 4}, {0, 1, 2, 3}}};
    double before = 0;
    for (auto& t : mesh.tetrahedra) {
        if (volumeOf(points, t) < 0) std::swap(t[0], t[1]);
        before += volumeOf(points, t);
    }
    mendFlat(points, mesh);
    EXPECT_EQ(mesh.newPoints.size(), 1U);
    double after = 0;
    for (const auto& t : mesh.tetrahedra) {
        EXPECT_GT(volumeOf(points, t), 1e-3);
        after += volumeOf(points, t);
    }
    EXPECT_NEAR(after, before, 1e-11);
}

TEST(TriangulatedFaces, takeOtherDiagonalsWhereTrianglesCross) {
    // Over a base a roof whose two faces are bent; most diagonals make them cross the base.
    const PolyMesh mesh = test::meshOf(
        {{0, 0, 0},
         {1, 0, 0},
         {1, 1, 0},
         {0, 1, 0},
         {0, 0, 0.2},
         {1, 0, 0.2},
         {1, 1, 0.2},
         {0, 1, -0.1}},
        {{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}});
    const SubdivisionPlan plan = planSubdivision(mesh);
    const auto own = plan.cellFaces[0];
    TriangulatedFaces faces(mesh, plan, {own.begin(), own.end()});
    const Label before = crossingsOf(faces.hullOf(Label{0}));
    faces.avoidCrossings(std::vector<Label>{0});
    EXPECT_LE(crossingsOf(faces.hullOf(Label{0})), before);
    for (const Label face : own) {
        const auto triangles = faces.of(face);
        EXPECT_TRUE(triangles.size() == 2 || triangles.size() == 4);
    }
}

} // namespace polymesh
