// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/surfaceTargets.h"

#include "libpolymesh/surface/triangleBoxes.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace polymesh::test {
namespace {

/// A surface with what is looked for on it. Not to be moved: parts point to it.
struct Targets {
    explicit Targets(TriSurface part)
        : surface(std::move(part)),
          cutter{&surface, pairEdges(surface), triangleBoxes(surface)},
          features(findFeatures(surface, cutter.edges, 0.5)),
          targets(cutter, features) {}

    Targets(const Targets&) = delete;
    Targets& operator=(const Targets&) = delete;

    TriSurface surface;
    CuttingSurface cutter;
    SurfaceFeatures features;
    SurfaceTargets targets;
};

NodeFreedom inPlane(const Vec3& normal) {
    NodeFreedom freedom;
    freedom.addPlane(normal);
    return freedom;
}

TEST(SurfaceTargets, aNodeInAPlaneGoesToAnEdgeOnlyWhereThatMeetsThePlane) {
    const Targets cube(cuboid());
    const NodeFreedom freedom = inPlane({1, 0, 0});
    const auto on = cube.targets.onEdge({0.9, 0.1, 0}, 0.3, freedom);
    ASSERT_TRUE(on);
    EXPECT_EQ(on->place, (Vec3{0.9, 0, 0}));
    EXPECT_FALSE(cube.targets.onEdge({1.1, 0.1, 0}, 0.3, freedom)) << "beyond the end";
}

TEST(SurfaceTargets, aNodeInAPlaneGoesToAFaceUnlessThatIsNearlyParallel) {
    for (const double degrees : {12.0, 30.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        TriSurface tilted = cuboid({-1, -1, 0}, {1, 1, 1}); // about the y axis
        for (Vec3& p : tilted.points)
            p = {p.x * std::cos(angle) - p.z * std::sin(angle),
                 p.y,
                 p.x * std::sin(angle) + p.z * std::cos(angle)};
        const Targets body(std::move(tilted));
        const auto on = body.targets.onFace({-0.02, 0.2, 0}, 0.3, inPlane({0, 0, 1}));
        EXPECT_EQ(on.has_value(), degrees > 20);
        if (on) {
            EXPECT_NEAR(norm(on->place - Vec3{0, 0.2, 0}), 0, 1e-12);
        }
    }
}

} // namespace
} // namespace polymesh::test
