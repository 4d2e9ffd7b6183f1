// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/nodes.h"

#include "libpolymesh/geometry/solidAngle.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "tests/libpolymesh/trim/arranged.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace polymesh::test {
namespace {

/// The winding number as the solid angle that the triangles fill, over the whole sphere's.
int solidAngleWinding(const TriSurface& surface, const Vec3& p) {
    double sum = 0;
    for (Label t = 0; t < surface.triangleCount(); ++t)
        sum += solidAngle(p, surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2));
    return static_cast<int>(std::lround(sum / (4 * std::numbers::pi)));
}

/// The place of a mesh point in the frame of the surface that moves by a small but real vector.
Vec3 seenFromMoved(const Vec3& p) {
    return p - Vec3{1e-4, 1e-6, 1e-8};
}

void expectRightWinding(const PolyMesh& mesh, const TriSurface& surface) {
    const Arranged inside(mesh, surface);
    const Probe& probe = inside.probe;
    ASSERT_EQ(toLabel(inside.arrangement.winding.size()), probe.nodeCount());
    for (Label n = 0; n < probe.nodeCount(); ++n)
        ASSERT_EQ(int{inside.arrangement.winding[index(n)]},
                  solidAngleWinding(surface, seenFromMoved(probe.nodePoints[index(n)])))
            << "node " << n;
    const MeshGeometry geometry = computeGeometry(mesh);
    for (Label c = 0; c < mesh.cellCount; ++c) {
        const bool isProbed = probe.localCell[index(c)] >= 0;
        const int winding =
            isProbed ? 0 : solidAngleWinding(surface, geometry.cellCentres[index(c)]);
        ASSERT_EQ(int{inside.cellWinding[index(c)]}, winding) << "cell " << c;
    }
    const Arranged outside(mesh, surface, true);
    for (std::size_t n = 0; n < outside.arrangement.winding.size(); ++n)
        ASSERT_EQ(outside.arrangement.winding[n], 1 - inside.arrangement.winding[n]);
}

TEST(WindNodes, agreesWithTheSolidAngle) {
    expectRightWinding(box(7, 7, 7), sphere(2, .33, {.51, .47, .5}));
    expectRightWinding(jittered(box(6, 6, 6), .03), sphere(2, .33, {.51, .47, .5}));
    expectRightWinding(hangingNodes(), sphere(1, .7, {1.1, 1.05, .95}));
}

TEST(WindNodes, nodesOnTheSurfaceGoByTheMove) {
    expectRightWinding(box(8, 8, 8), cuboid({.25, .25, .25}, {.75, .75, .625}));
    expectRightWinding(box(4, 4, 4, {4, 4, 4}), sphere(0, 1, {2, 2, 2}));
    expectRightWinding(box(3, 3, 3), cuboid());
}

TEST(WindNodes, cavitiesAndSeparateShellsCount) {
    const TriSurface shell =
        join(cuboid({.1, .1, .1}, {.9, .9, .9}), inverted(cuboid({.3, .3, .3}, {.7, .7, .7})));
    expectRightWinding(box(12, 12, 12), shell);
    expectRightWinding(box(3, 3, 3),
                       join(sphere(1, .1, {.2, .2, .2}), sphere(1, .1, {.8, .5, .5})));
}

TEST(WindNodes, partsThatNoCellTouchesGoByRays) {
    // A thick box of few cells: all of its cells far from the surface, all inside.
    expectRightWinding(box(3, 3, 3), cuboid({-5, -5, -5}, {5, 5, 5}));
}

TEST(WindingNumber, agreesWithTheSolidAngleAnywhere) {
    const TriSurface surface =
        join(sphere(2, 1), join(inverted(sphere(1, .5)), cuboid({1.2, 0, 0}, {2, .5, .5})));
    const CuttingSurface cutter{&surface, pairEdges(surface), triangleBoxes(surface)};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-2.2, 2.2);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 p{unit(random), 0.5 * unit(random), 0.5 * unit(random)};
        ASSERT_EQ(windingNumber(cutter, p), solidAngleWinding(surface, p));
    }
}

TEST(WindingNumber, aSmallHoleDoesNoHarmToMostPoints) {
    // The majority of three rays: only points with the hole in two of them are misled.
    const TriSurface open = without(sphere(3, 1), 100);
    const CuttingSurface cutter{&open, {}, triangleBoxes(open)};
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(-.5, .5);
    for (int i = 0; i < 500; ++i)
        EXPECT_EQ(windingNumber(cutter, {unit(random), unit(random), unit(random)}), 1);
}

} // namespace
} // namespace polymesh::test
