// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/loops.h"

#include "tests/libpolymesh/trim/arranged.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace polymesh::test {
namespace {

Vec3 areaVector(const Arranged& a, std::span<const Label> points) {
    Vec3 sum;
    const Vec3& apex = a.positions[index(points[0])];
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        sum += 0.5 * cross(a.positions[index(points[i])] - apex,
                           a.positions[index(points[i + 1])] - apex);
    return sum;
}

/// Sum over the polygons that are left of a face.
Vec3 areaLeft(const Arranged& a, Label face) {
    Vec3 sum;
    for (Label k = a.loops.offsets[index(face)]; k < a.loops.offsets[index(face) + 1]; ++k)
        sum += areaVector(a, a.loops.polygons[k]);
    return sum;
}

/// Inside and outside of each face make the face, and no polygon uses a point twice.
void expectPartsMakeTheFace(const PolyMesh& mesh, const TriSurface& surface) {
    const Arranged inside(mesh, surface);
    const Arranged outside(mesh, surface, true);
    ASSERT_EQ(inside.probe.faceCount(), outside.probe.faceCount());
    for (Label f = 0; f < inside.probe.faceCount(); ++f) {
        const Vec3 whole = areaVector(inside, inside.probe.faceNodes[f]);
        const Vec3 sum = areaLeft(inside, f) + areaLeft(outside, f);
        ASSERT_LT(norm(sum - whole), 1e-13 * norm(whole)) << "face " << f;
    }
    for (const Arranged* a : {&inside, &outside})
        for (Label k = 0; k < a->loops.polygons.size(); ++k) {
            const auto polygon = a->loops.polygons[k];
            ASSERT_EQ(std::set<Label>(polygon.begin(), polygon.end()).size(), polygon.size());
        }
}

/// The area left of all faces in the plane z = `height`.
double areaAt(const Arranged& a, double height) {
    double area = 0;
    for (Label f = 0; f < a.probe.faceCount(); ++f) {
        bool isThere = true;
        for (const Label n : a.probe.faceNodes[f])
            isThere = isThere && a.probe.nodePoints[index(n)].z == height;
        if (isThere) area += norm(areaLeft(a, f));
    }
    return area;
}

TEST(WalkFaces, insideAndOutsideMakeTheFace) {
    expectPartsMakeTheFace(box(5, 5, 5), sphere(2, .37, {.51, .47, .5}));
    expectPartsMakeTheFace(box(3, 3, 3),
                           join(sphere(1, .2, {.3, .35, .3}), cuboid({.6, .6, .1}, {.65, .8, .9})));
    expectPartsMakeTheFace(hangingNodes(), sphere(1, .7, {1.1, 1.05, .95}));
}

TEST(WalkFaces, alsoWhereTheSurfaceTouchesNodesEdgesAndFaces) {
    expectPartsMakeTheFace(box(4, 4, 4), cuboid({.25, .25, .25}, {.75, .75, .75}));
    expectPartsMakeTheFace(box(4, 4, 4, {4, 4, 4}), sphere(0, 1.5, {1.5, 2, 2}));
    expectPartsMakeTheFace(box(2, 2, 2), cuboid({0, .5, .1}, {1, 1, .5}));
}

TEST(WalkFaces, cutAreaIsKnownWhereItCanBeDrawn) {
    const Arranged a(box(3, 3, 3, {3, 3, 3}), cuboid({.4, .6, .5}, {2.2, 1.9, 2.5}));
    EXPECT_NEAR(areaAt(a, 1), 1.8 * 1.3, 1e-14);
    EXPECT_NEAR(areaAt(a, 2), 1.8 * 1.3, 1e-14);
    EXPECT_EQ(areaAt(a, 0), 0);
    EXPECT_EQ(a.loops.holeCount, 0);
}

TEST(WalkFaces, rodsThroughAFaceAreHolesOrIslands) {
    const TriSurface rods =
        join(cuboid({1.2, 1.2, -1}, {1.3, 1.4, 4}), cuboid({1.6, 1.5, -1}, {1.9, 1.7, 4}));
    const PolyMesh mesh = box(3, 3, 3, {3, 3, 3});
    const Arranged islands(mesh, rods);
    EXPECT_EQ(islands.loops.holeCount, 0);
    EXPECT_NEAR(areaAt(islands, 1), .1 * .2 + .3 * .2, 1e-14);
    const Arranged holes(mesh, rods, true);
    EXPECT_EQ(holes.loops.holeCount, 8); // two in each of four planes
}

TEST(WalkFaces, warpedFacesAreWalkedAsFans) {
    const PolyMesh mesh = jittered(box(4, 4, 4), .06, 5);
    const TriSurface surface = sphere(2, .33, {.5, .5, .5});
    const Arranged inside(mesh, surface);
    const Arranged outside(mesh, surface, true);
    EXPECT_GT(inside.probe.facetCount(), inside.probe.faceCount());
    // The area vector of a fan depends on its outline alone, so that of the parts' does.
    for (Label f = 0; f < inside.probe.faceCount(); ++f) {
        const Vec3 whole = areaVector(inside, inside.probe.faceNodes[f]);
        ASSERT_LT(norm(areaLeft(inside, f) + areaLeft(outside, f) - whole), 1e-13);
    }
}

TEST(WalkFaces, crossingsOnEdgesOfTheMeshAreNeeded) {
    const Arranged a(jittered(box(4, 4, 4), .06, 5), sphere(2, .33, {.5, .5, .5}));
    for (Label e = 0; e < a.probe.edgeCount(); ++e)
        if (a.probe.isFanEdge[index(e)] == 0) {
            const auto& offsets = a.arrangement.crossings.offsets;
            for (Label x = offsets[index(e)]; x < offsets[index(e) + 1]; ++x)
                ASSERT_EQ(a.loops.isNeeded[index(x)], 1);
        }
}

} // namespace
} // namespace polymesh::test
