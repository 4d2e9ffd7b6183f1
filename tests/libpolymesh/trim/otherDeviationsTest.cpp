// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Cells that come out bad are made again with another deviation.

#include "libpolymesh/base/threadLimit.h"
#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/quality/checks.h"
#include "libpolymesh/trim/trim.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <array>

namespace polymesh::test {
namespace {

/// A ball with a ball-shaped hole beside its middle, and how many cells there are across it.
struct HollowBall {
    double radius;
    Vec3 centre;
    int divisions;
    double cells;

    TriSurface surface() const {
        return join(sphere(2), inverted(sphere(divisions, radius, centre)));
    }

    PolyMesh mesh() const {
        const double size = 2 / cells;
        return cartesianMesh(boxAround({{-1, -1, -1}, {1, 1, 1}}, size, defaultMargin(size)));
    }
};

/// With the default deviation, repairs leave bad cells in each of these.
const std::array<HollowBall, 5> hollowBalls{{{0.3, {0.02, 0.05, 0.03}, 1, 5},
                                             {0.3, {0.02, 0.25, 0.13}, 2, 6},
                                             {0.4, {0.02, 0.05, 0.23}, 1, 9},
                                             {0.5, {0.02, 0.15, 0.13}, 2, 6},
                                             {0.6, {0.02, 0.25, 0.33}, 1, 7}}};

Trimmed trimmed(const HollowBall& ball, const TrimOptions& options = {}) {
    return trim(ball.mesh(), ball.surface(), options);
}

TEST(OtherDeviations, makeBadCellsGood) {
    int remade = 0;
    for (const HollowBall& ball : hollowBalls) {
        const auto [mesh, summary] = trimmed(ball);
        EXPECT_EQ(summary.badCells, 0);
        EXPECT_TRUE(checkMesh(mesh, {}).isOk());
        EXPECT_TRUE(validate(mesh).empty());
        EXPECT_EQ(summary.remadeCells > 0, !summary.remadePlaces.empty());
        EXPECT_LT(summary.remadeCells, summary.trimmedCells / 2); // the places are small
        remade += summary.remadeCells > 0 ? 1 : 0;
        for (const FidelityPlace& place : summary.remadePlaces)
            EXPECT_NE(place.factor, 1);
    }
    EXPECT_GE(remade, 3) << "these bodies no longer need what this test is about: find others";
}

TEST(OtherDeviations, areNotTriedWhereCellsAreToStayAsTheyAre) {
    TrimOptions options;
    options.mendsCells = false;
    for (const HollowBall& ball : hollowBalls) {
        const TrimSummary summary = trimmed(ball, options).summary;
        EXPECT_EQ(summary.remadeCells, 0);
        EXPECT_TRUE(summary.remadePlaces.empty());
    }
}

TEST(OtherDeviations, giveTheSameForAnyNumberOfThreads) {
    for (const HollowBall& ball : {hollowBalls[0], hollowBalls[3]}) {
        const Trimmed first = [&] {
            const ThreadLimit limit(1);
            return trimmed(ball);
        }();
        for (const std::size_t threads : {2U, 8U}) {
            const ThreadLimit limit(threads);
            const Trimmed other = trimmed(ball);
            EXPECT_EQ(other.mesh.points, first.mesh.points) << threads;
            EXPECT_EQ(other.mesh.faces, first.mesh.faces) << threads;
            EXPECT_EQ(other.mesh.owner, first.mesh.owner) << threads;
            EXPECT_EQ(other.summary.remadeCells, first.summary.remadeCells) << threads;
        }
    }
}

} // namespace
} // namespace polymesh::test
