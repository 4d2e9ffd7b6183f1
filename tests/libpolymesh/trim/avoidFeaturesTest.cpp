// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/threadLimit.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mesh/valences.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/surface/distance.h"
#include "libpolymesh/surface/triangleBoxes.h"
#include "libpolymesh/trim/adjustGuard.h"
#include "libpolymesh/trim/adjustNodes.h"
#include "libpolymesh/trim/closestOnSegments.h"
#include "libpolymesh/trim/trim.h"
#include "tests/libpolymesh/trim/adjusted.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <random>

namespace polymesh::test {
namespace {

const AdjustOptions avoid{Adjust::avoid, 0.3, {}};

Trimmed trimForMidPoints(const TriSurface& surface, Adjust how) {
    TrimOptions options;
    options.adjust.how = how;
    options.minVolume = 0;
    options.mendsCells = false;
    return trim(box(14, 14, 14), surface, options);
}

} // namespace

TEST(ClosestOnSegments, isAsNearAsAnyPairOfPoints) {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> whole(-2, 2);
    const auto point = [&] {
        return Vec3{static_cast<double>(whole(random)),
                    static_cast<double>(whole(random)),
                    static_cast<double>(whole(random))};
    };
    for (int i = 0; i < 300; ++i) { // whole numbers: also parallel ones and single points
        const StraightEdge a{point(), point()};
        const StraightEdge b{point(), point()};
        const SegmentPair found = closestOnSegments(a, b);
        const double least = norm(pointOn(a, found.onFirst) - pointOn(b, found.onSecond));
        for (int s = 0; s <= 20; ++s)
            for (int t = 0; t <= 20; ++t)
                EXPECT_LE(least, norm(pointOn(a, s / 20.0) - pointOn(b, t / 20.0)) + 1e-12);
    }
    const SegmentPair beside =
        closestOnSegments({Vec3{0, 0, 0}, Vec3{4, 0, 0}}, {Vec3{5, 1, 0}, Vec3{2, 1, 0}});
    EXPECT_DOUBLE_EQ(beside.onFirst, 0.75); // the middle of what is beside the other
}

TEST(Avoid, movesAnEdgeOffAFeatureEdge) {
    // The lower edge of this body passes the upright edge of the mesh at (1, 1) by 0.014.
    const TriSurface body =
        surfaceOf({{-1, -1, 0.5}, {2.02, 0, 0.5}, {0, 2.02, 0.5}, {0.2, 0.2, 9}},
                  {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    PolyMesh mesh = box(2, 2, 1, {2, 2, 1});
    const auto gap = [&] {
        const StraightEdge feature{body.points[1], body.points[2]};
        const StraightEdge edge{mesh.points[4], mesh.points[13]};
        const SegmentPair pair = closestOnSegments(feature, edge);
        return norm(pointOn(feature, pair.onFirst) - pointOn(edge, pair.onSecond));
    };
    ASSERT_LT(gap(), 0.02);
    const AdjustedNodes adjusted = adjust(mesh, body, avoid);
    EXPECT_GT(adjusted.counts.closeBefore.edges, 0);
    EXPECT_GT(gap(), 0.119); // 0.12 of the shortest edge there
}

TEST(Avoid, leavesFewerPassagesAndNoBadCellWhateverTheBody) {
    Label before = 0;
    Label after = 0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        PolyMesh mesh = jittered(box(12, 12, 12), 0.004, seed);
        const AdjustedNodes adjusted = adjust(mesh, skewCuboid(seed), avoid);
        before += adjusted.counts.closeBefore.edges + adjusted.counts.closeBefore.faces;
        after += adjusted.counts.closeAfter.edges + adjusted.counts.closeAfter.faces;
        EXPECT_GT(worstCell(mesh), 0.1);
        EXPECT_TRUE(adjusted.settled.empty());
    }
    EXPECT_GT(before, 100);
    EXPECT_LT(after, 0.6 * before);
}

TEST(Avoid, makesMoreNodesTrivalentThanRepelAndRepelMoreThanNone) {
    std::size_t none = 0;
    std::size_t repel = 0;
    std::size_t avoided = 0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const TriSurface body = skewCuboid(seed);
        const auto more = [&](Adjust how) {
            const PolyMesh mesh = trimForMidPoints(body, how).mesh;
            EXPECT_TRUE(validate(mesh).empty());
            return countValences(mesh, mesh.internalFaceCount()).more;
        };
        none += more(Adjust::none);
        repel += more(Adjust::repel);
        avoided += more(Adjust::avoid);
    }
    EXPECT_GT(none, 100U);
    EXPECT_LT(repel, none / 2);
    EXPECT_LT(avoided, repel / 4);
}

TEST(Avoid, keepsNodesOffTheSurfaceToo) {
    PolyMesh mesh = box(9, 9, 9);
    const TriSurface surface = skewCuboid(2);
    const SurfaceTree tree(surface);
    adjust(mesh, surface, avoid);
    for (const Vec3& p : mesh.points)
        EXPECT_GT(tree.closest(p).distance, 0.2 / 9);
}

TEST(Avoid, boundaryNodesStayInTheBoundaryAndHangingOnesOnTheirEdge) {
    const PolyMesh before = box(6, 6, 6);
    PolyMesh mesh = before;
    TriSurface surface = skewCuboid(4);
    for (Vec3& p : surface.points)
        p += {0.4, 0.3, 0};
    adjust(mesh, surface, avoid);
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
        for (int axis = 0; axis < 3; ++axis)
            if (before.points[p][axis] == 0 || before.points[p][axis] == 1) {
                EXPECT_EQ(mesh.points[p][axis], before.points[p][axis]);
            }

    PolyMesh refined = hangingNodes();
    const AdjustedNodes adjusted =
        adjust(refined, cuboid({0.4, 0.45, 0.5}, {0.95, 1.9, 1.93}), avoid);
    EXPECT_GT(adjusted.moved.size(), 0U);
    const auto at = [&](Label j, Label k) { return refined.points[index(1 + 2 * (j + 3 * k))]; };
    for (const Label end : {0, 2}) {
        EXPECT_EQ(at(1, end), 0.5 * (at(0, end) + at(2, end)));
        EXPECT_EQ(at(end, 1), 0.5 * (at(end, 0) + at(end, 2)));
    }
}

TEST(Avoid, givesTheSameForAnyNumberOfThreads) {
    std::vector<Vec3> first;
    for (const std::size_t threads : {1U, 2U, 8U}) {
        const ThreadLimit limit(threads);
        PolyMesh mesh = jittered(box(24, 24, 24), 0.003);
        adjust(mesh, skewCuboid(5), avoid);
        if (first.empty()) first = mesh.points;
        EXPECT_EQ(mesh.points, first) << threads;
    }
}

} // namespace polymesh::test
