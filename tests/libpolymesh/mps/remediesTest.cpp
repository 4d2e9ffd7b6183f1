// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/remedies.h"

#include "libpolymesh/mps/chords.h"
#include "libpolymesh/mps/joinCells.h"
#include "libpolymesh/mps/makeDivisible.h"
#include "libpolymesh/mps/triangulate.h"
#include "libpolymesh/reference/tetgen.h"
#include "tests/libpolymesh/mps/divided.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <numeric>

namespace polymesh {

namespace {

bool always(Label, Label) {
    return true;
}

double areaOf(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
    double sum = 0;
    for (const Triangle& t : triangles)
        sum += 0.5 * cross(points[index(t[1])] - points[index(t[0])],
                           points[index(t[2])] - points[index(t[0])])
                         .z;
    return sum;
}

/// A prism of height 1 over a polygon that runs round to the left.
PolyMesh prism(const std::vector<Vec3>& base) {
    const Label n = toLabel(base.size());
    PolyMesh mesh;
    mesh.points = base;
    for (const Vec3& p : base)
        mesh.points.push_back(p + Vec3{0, 0, 1});
    std::vector<Label> bottom(base.size());
    std::vector<Label> top(base.size());
    std::iota(top.begin(), top.end(), n);
    std::iota(bottom.rbegin(), bottom.rend(), 0);
    mesh.faces.add(bottom);
    mesh.faces.add(top);
    for (Label i = 0; i < n; ++i)
        mesh.faces.add(std::vector<Label>{i, (i + 1) % n, (i + 1) % n + n, i + n});
    mesh.owner.assign(base.size() + 2, 0);
    mesh.cellCount = 1;
    mesh.patches.push_back({"walls", "wall", 0, n + 2, {}});
    return mesh;
}

/// A U, which no single point sees all of.
PolyMesh uShape() {
    return prism({{0, 0, 0},
                  {3, 0, 0},
                  {3, 2, 0},
                  {2, 2, 0},
                  {2, 0.5, 0},
                  {1, 0.5, 0},
                  {1, 2, 0},
                  {0, 2, 0}});
}

} // namespace

TEST(Triangulate, fillsAConcavePolygonWithoutTurningTrianglesOver) {
    const PolyMesh u = uShape();
    const std::vector<Label> top(u.faces[1].begin(), u.faces[1].end());
    const auto triangles = triangulate(u.points, top, always);
    EXPECT_EQ(triangles.size(), 6U);
    EXPECT_NEAR(areaOf(u.points, triangles), 4.5, 1e-14);
    for (const Triangle& t : triangles)
        EXPECT_GT(areaOf(u.points, {t}), 0);
}

TEST(Triangulate, isEmptyWhereNoDiagonalIsAllowed) {
    const PolyMesh u = uShape();
    EXPECT_TRUE(triangulate(u.points, u.faces[1], [](Label, Label) { return false; }).empty());
}

TEST(Chords, runInsideThePolygonAndRespectBends) {
    const PolyMesh u = uShape();
    const auto top = u.faces[1]; // corners as in the list of points
    EXPECT_TRUE(isChord(u, {}, top, 0, 5));
    EXPECT_FALSE(isChord(u, {}, top, 2, 7)); // across the gap
    EXPECT_FALSE(isChord(u, {}, top, 0, 3)); // leaves and comes back
    const Bends bend{{{top[4], top[5]}, {1.5, -0.2, 1}}};
    EXPECT_TRUE(isChord(u, {}, top, 0, 4));
    EXPECT_FALSE(isChord(u, bend, top, 0, 4));
}

TEST(Chords, doNotCutOffACornerThatStandsOutOfTheFace) {
    PolyMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.001, 0.5, 0.3}};
    const std::vector<Label> warped{0, 1, 2, 3, 4};
    EXPECT_FALSE(isChord(mesh, {}, warped, 0, 3)); // the triangle at point 4 would stand across
    EXPECT_TRUE(isChord(mesh, {}, warped, 1, 4));
    mesh.points[4] = {-0.3, 0.5, 0};
    EXPECT_TRUE(isChord(mesh, {}, warped, 0, 3));
}

/// A tetrahedron whose edge to the left has been moved to the plane of its back by an edge's
/// collapse, so that a flap stands out there; over its top is a pyramid.
PolyMesh tipWithFlap() {
    PolyMesh mesh;
    mesh.points = {{0, 0, 0},
                   {-0.9536, -0.0249, 0},
                   {-1, 0, 0},
                   {0, 0, -0.7888},
                   {0, -0.5363, 0},
                   {-0.4, -0.15, 0.5}};
    mesh.faces.add(std::vector<Label>{4, 0, 2, 1});
    mesh.faces.add(std::vector<Label>{3, 0, 4});
    mesh.faces.add(std::vector<Label>{1, 2, 0, 3});
    mesh.faces.add(std::vector<Label>{1, 3, 4});
    mesh.faces.add(std::vector<Label>{4, 0, 5});
    mesh.faces.add(std::vector<Label>{0, 2, 5});
    mesh.faces.add(std::vector<Label>{2, 1, 5});
    mesh.faces.add(std::vector<Label>{1, 4, 5});
    mesh.owner = {0, 0, 0, 0, 1, 1, 1, 1};
    mesh.neighbour = {1};
    mesh.cellCount = 2;
    mesh.patches.push_back({"walls", "wall", 1, 7, {}});
    return mesh;
}

TEST(Remedies, aTipHasAPartnerWithWhichItIsWhole) {
    PolyMesh mesh = tipWithFlap();
    EXPECT_TRUE(validate(mesh).empty());
    const SubdivisionPlan plan = planSubdivision(mesh);
    ASSERT_EQ(plan.inverted, std::vector<Label>{0});
    const auto pairs = partnersOf(mesh, plan, plan.inverted);
    ASSERT_EQ(pairs.size(), 1U);
    const double volume = test::volumeOf(mesh);
    mesh = withJoinedCells(std::move(mesh), pairs);
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_EQ(mesh.cellCount, 1);
    const Divisible work = makeDivisible(mesh);
    EXPECT_TRUE(work.plan.inverted.empty());
    EXPECT_NEAR(test::volumeOf(work.mesh), volume, 1e-12 * volume);
}

TEST(Remedies, cellsOfDifferentZonesAreNoPartners) {
    PolyMesh mesh = tipWithFlap();
    mesh.cellZones.push_back({"tip", {0}, {}});
    const SubdivisionPlan plan = planSubdivision(mesh);
    EXPECT_TRUE(partnersOf(mesh, plan, plan.inverted).empty());
    EXPECT_EQ(partnersOf(mesh, plan, plan.inverted, {0, 0}).size(), 1U);
}

TEST(JoinCells, facesBetweenThemGoAndZonesFollow) {
    PolyMesh mesh = test::box(3, 1, 1);
    mesh.cellZones.push_back({"all", {0, 1, 2}, {}});
    mesh.faceZones.push_back({"first", {0}, {false}});
    const PolyMesh joined = withJoinedCells(mesh, std::vector{std::pair<Label, Label>{1, 0}});
    EXPECT_TRUE(validate(joined).empty());
    EXPECT_EQ(joined.cellCount, 2);
    EXPECT_EQ(joined.internalFaceCount(), mesh.internalFaceCount() - 1);
    EXPECT_EQ(joined.cellZones[0].labels, (std::vector<Label>{0, 1}));
    EXPECT_TRUE(joined.faceZones[0].labels.empty());
    EXPECT_NEAR(test::volumeOf(joined), test::volumeOf(mesh), 1e-12);
}

/// The mesh with these steps taken.
PolyMesh withRemedies(PolyMesh mesh, const Remedies& remedies) {
    mesh.points.insert(mesh.points.end(), remedies.points.begin(), remedies.points.end());
    mesh = withPieces(std::move(mesh), remedies.faces);
    const Rows<Label> faces = cellFaces(mesh);
    mesh = withCones(std::move(mesh), faces, remedies.cells);
    return withJoinedCells(std::move(mesh), remedies.joined);
}

/// Takes step after step until no part is inverted; counts the cells joined.
std::size_t remedied(PolyMesh& mesh) {
    constexpr int steps = 8;
    const double volume = test::volumeOf(mesh);
    std::size_t joined = 0;
    SubdivisionPlan plan = planSubdivision(mesh);
    EXPECT_FALSE(plan.inverted.empty());
    for (int step = 0; step < steps && !plan.inverted.empty(); ++step) {
        const Remedies remedies =
            remediesOf(mesh, plan, plan.inverted, {{}, tetgenTetrahedraliser()});
        joined += remedies.joined.size();
        mesh = withRemedies(mesh, remedies);
        EXPECT_TRUE(validate(mesh).empty());
        plan = planSubdivision(mesh);
    }
    EXPECT_TRUE(plan.inverted.empty());
    EXPECT_NEAR(test::volumeOf(mesh), volume, 1e-12 * volume);
    return joined;
}

/// A pyramid on a flat tetrahedron, which has the two diagonals of the base.
PolyMesh pyramidOnASliver() {
    return test::meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}},
                        {{{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}},
                         {{0, 3, 1}, {1, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}});
}

TEST(Remedies, aFlatCellIsJoinedWithItsNeighbour) {
    if (!hasTetgen()) GTEST_SKIP() << "built without TetGen";
    PolyMesh mesh = pyramidOnASliver();
    EXPECT_GT(remedied(mesh), 0U);
}

TEST(Remedies, aFlatCellInAZoneOfItsOwnIsNotJoined) {
    constexpr int steps = 4;
    PolyMesh mesh = pyramidOnASliver();
    mesh.cellZones.push_back({"sliver", {0}, {}});
    SubdivisionPlan plan = planSubdivision(mesh);
    ASSERT_TRUE(std::ranges::binary_search(plan.inverted, 0));
    for (int step = 0; step < steps; ++step) {
        const Remedies remedies =
            remediesOf(mesh, plan, plan.inverted, {{}, tetgenTetrahedraliser()});
        EXPECT_TRUE(remedies.joined.empty());
        mesh = withRemedies(mesh, remedies);
        plan = planSubdivision(mesh);
    }
}

TEST(Remedies, aUEndsAsPartsThatAreAllRight) {
    if (!hasTetgen()) GTEST_SKIP() << "built without TetGen";
    PolyMesh mesh = uShape();
    EXPECT_EQ(remedied(mesh), 0U);
    EXPECT_EQ(demandedCounts(mesh).pyramids, 0);
}

} // namespace polymesh
