// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/coincident.h"

#include "tests/libpolymesh/trim/arranged.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

namespace polymesh::test {
namespace {

std::vector<Label> merged(const Arranged& a) {
    return mergeCoincident(a.probe, a.cutter, a.arrangement);
}

int precedence(const Arranged& a, Label point) {
    if (a.arrangement.isNode(point)) return 0;
    return point >= a.arrangement.firstVertex() ? 1 : 2;
}

/// What holds always: one step leads to the representative, at the same place, of no lesser kind.
void expectSamePlace(const Arranged& a, const std::vector<Label>& representative) {
    ASSERT_EQ(representative.size(), a.positions.size());
    for (std::size_t p = 0; p < representative.size(); ++p) {
        const Label r = representative[p];
        ASSERT_EQ(representative[index(r)], r);
        ASSERT_LT(norm(a.positions[p] - a.positions[index(r)]), 1e-14);
        ASSERT_LE(precedence(a, r), precedence(a, toLabel(p)));
    }
}

/// Coordinates are dyadic, so that all points are where they belong to the last bit: those at one
/// place share one representative.
void expectOnePointAPlace(const PolyMesh& mesh, const TriSurface& surface) {
    const Arranged a(mesh, surface);
    const std::vector<Label> representative = merged(a);
    expectSamePlace(a, representative);
    std::map<Vec3, Label> at;
    for (std::size_t p = 0; p < representative.size(); ++p) {
        const bool isElsewhere =
            toLabel(p) >= a.arrangement.firstVertex() &&
            a.arrangement.vertexCell[p - index(a.arrangement.firstVertex())] < 0;
        if (isElsewhere) continue; // a surface point outside the mesh
        const auto [entry, isNew] = at.try_emplace(a.positions[p], representative[p]);
        ASSERT_EQ(entry->second, representative[p])
            << "(" << a.positions[p].x << " " << a.positions[p].y << " " << a.positions[p].z << ")";
    }
}

TEST(MergeCoincident, pointsInGeneralPositionStandForThemselves) {
    const Arranged a(box(5, 5, 5), sphere(2, .3712, {.5123, .4734, .5034}));
    const std::vector<Label> representative = merged(a);
    for (std::size_t p = 0; p < representative.size(); ++p)
        EXPECT_EQ(representative[p], toLabel(p));
}

TEST(MergeCoincident, pointsAtOnePlaceShareOne) {
    expectOnePointAPlace(box(4, 4, 4), cuboid({.25, .25, .25}, {.75, .75, .75}));
    expectOnePointAPlace(box(4, 4, 4), cuboid({.125, .25, .25}, {.75, .625, .75}));
    expectOnePointAPlace(box(4, 4, 4, {4, 4, 4}), sphere(0, 1, {2, 2, 2}));
    expectOnePointAPlace(box(4, 4, 4, {4, 4, 4}), sphere(0, 1.5, {2, 2, 2}));
    expectOnePointAPlace(box(4, 4, 4, {4, 4, 4}), sphere(0, 1.5, {1.5, 2, 2}));
    expectOnePointAPlace(box(2, 2, 2), cuboid());
    expectOnePointAPlace(hangingNodes(), sphere(0, .5, {1, 1, 1}));
}

TEST(MergeCoincident, whereSurfacesTouchEachOtherToo) {
    expectOnePointAPlace(
        box(4, 4, 4),
        join(cuboid({.125, .125, .25}, {.5, .5, .75}), cuboid({.5, .5, .25}, {.75, .75, .75})));
    // The edge that they share passes edges of the mesh between their nodes.
    expectOnePointAPlace(box(4, 4, 4),
                         join(cuboid({.125, .125, .3125}, {.375, .5, .8125}),
                              cuboid({.375, .5, .3125}, {.75, .75, .8125})));
}

TEST(MergeCoincident, distortedMeshesWithNodesOnTheSurface) {
    const PolyMesh mesh = jittered(box(4, 4, 4), .05, 3);
    TriSurface surface = sphere(1, .3, {.5, .5, .5});
    // Move surface points onto nodes of the mesh.
    for (Vec3& p : surface.points) {
        const auto nearest = std::ranges::min_element(
            mesh.points, {}, [&](const Vec3& q) { return squaredNorm(q - p); });
        if (norm(*nearest - p) < .07) p = *nearest;
    }
    const Arranged a(mesh, surface);
    const std::vector<Label> representative = merged(a);
    expectSamePlace(a, representative);
    Label onNodes = 0;
    for (Label v = 0; v < surface.pointCount(); ++v) {
        const Label p = a.arrangement.firstVertex() + v;
        const bool isOnNode =
            std::ranges::find(mesh.points, surface.points[index(v)]) != mesh.points.end();
        EXPECT_EQ(a.arrangement.isNode(representative[index(p)]), isOnNode);
        onNodes += isOnNode ? 1 : 0;
    }
    EXPECT_GT(onNodes, 0);
}

} // namespace
} // namespace polymesh::test
