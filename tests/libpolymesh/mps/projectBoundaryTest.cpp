// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/projectBoundary.h"

#include "libpolymesh/surface/distance.h"
#include "tests/libpolymesh/mps/divided.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polymesh {

TEST(ProjectBoundary, pointsOfAFlatSidedMeshStay) {
    const PolyMesh mesh = test::unitCube();
    SubdivisionPlan plan = planSubdivision(mesh);
    const std::vector<Vec3> before = plan.points;
    const TriSurface cube = test::cuboid({0, 0, 0}, {1, 1, 1}, "cube");
    const ProjectionCounts counts = projectBoundary(mesh, plan, cube, 0.5);
    EXPECT_EQ(counts.moved, 0);
    EXPECT_EQ(plan.points, before);
}

TEST(ProjectBoundary, facesGoOntoTheSurfaceAndSharpEdgesOntoItsEdges) {
    const PolyMesh mesh = test::unitCube();
    SubdivisionPlan plan = planSubdivision(mesh);
    const TriSurface cube = test::cuboid({-.1, -.1, -.1}, {1.1, 1.1, 1.1}, "cube");
    const ProjectionCounts counts = projectBoundary(mesh, plan, cube, 0.5);
    EXPECT_EQ(counts.moved, 18);
    EXPECT_EQ(counts.onFeatures, 12);
    EXPECT_EQ(counts.refused, 0);
    EXPECT_NEAR(counts.largestMove, 0.1 * std::sqrt(2), 1e-12);
    const SurfaceTree tree(cube);
    for (Label p = plan.layout.firstEdge; p < plan.layout.firstCell; ++p)
        EXPECT_NEAR(tree.closest(plan.points[index(p)]).distance, 0, 1e-15);
}

TEST(ProjectBoundary, moveThatWouldInvertAPartIsTakenBack) {
    // A plate far thinner than its distance from the surface, to which both its sides would go.
    const PolyMesh mesh = test::box(1, 1, 1, {1, 1, 0.01});
    SubdivisionPlan plan = planSubdivision(mesh);
    const std::vector<Vec3> before = plan.points;
    const TriSurface far = test::cuboid({-.1, -.1, 0.2}, {1.1, 1.1, 0.3}, "far");
    const ProjectionCounts counts = projectBoundary(mesh, plan, far, 0.5);
    EXPECT_GT(counts.refused, 0);
    EXPECT_EQ(counts.moved, 0);
    EXPECT_EQ(plan.points, before);
}

} // namespace polymesh
