// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Bodies with features finer than the cells: where cells come out bad, features are not kept.

#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/quality/checks.h"
#include "libpolymesh/surface/measure.h"
#include "libpolymesh/trim/trim.h"
#include "tests/support/twistedStar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace polymesh::test {
namespace {

Trimmed trimmed(const TwistedStar& star, double cells, Keep keep) {
    const TriSurface part = star.surface();
    Box box;
    for (const Vec3& p : part.points)
        box.add(p);
    const double size = 2 / cells;
    TrimOptions options;
    options.keep = keep;
    return trim(cartesianMesh(boxAround(box, size, defaultMargin(size))), part, options);
}

bool hasBluntPlace(const TrimSummary& summary) {
    return std::ranges::any_of(summary.remadePlaces, &FidelityPlace::isBlunt);
}

TEST(BluntPlaces, makeGoodCellsWhereFeaturesAreFinerThanCells) {
    const TwistedStar thread{3, 20, 0.3};
    const double volume = measure(thread.surface()).volume;
    const auto [mesh, summary] = trimmed(thread, 5, Keep::inside);
    EXPECT_EQ(summary.badCells, 0);
    EXPECT_TRUE(checkMesh(mesh, {}).isOk());
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_TRUE(hasBluntPlace(summary))
        << "this body no longer needs what this test is about: find another";
    EXPECT_NEAR(boundedVolume(mesh), volume, 0.05 * volume);
}

TEST(BluntPlaces, areNotNeededWhereMovesTogetherMendCells) {
    // Each cell that fails gets its share of the work, whatever is round it.
    for (const auto& [star, cells] :
         {std::pair(TwistedStar{4, 3, 0.2}, 15), std::pair(TwistedStar{5, 3, 0.2}, 12)}) {
        const TrimSummary summary = trimmed(star, cells, Keep::outside).summary;
        EXPECT_EQ(summary.badCells, 0);
        EXPECT_EQ(summary.remadeCells, 0);
    }
}

} // namespace
} // namespace polymesh::test
