// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Bodies with features finer than the cells: where cells come out bad, features are not kept.

#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/quality/checks.h"
#include "libpolymesh/surface/measure.h"
#include "libpolymesh/trim/trim.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polymesh::test {
namespace {

/// A star with `points` points, drawn up along a tilted axis while it turns: a thread.
struct TwistedStar {
    Label points = 3;
    double turn = 0; // [rad] in all
    double tilt = 0; // [rad] of the axis against z
    double cells = 8;

    Vec3 corner(Label slice, Label i, double radius) const {
        constexpr double height = 2;
        const double part = static_cast<double>(slice) / slices;
        const double angle = std::numbers::pi * i / points + turn * part;
        const double y = radius * std::sin(angle);
        const double z = height * part;
        return {radius * std::cos(angle),
                y * std::cos(tilt) - z * std::sin(tilt),
                y * std::sin(tilt) + z * std::cos(tilt)};
    }

    TriSurface surface() const {
        const Label corners = 2 * points;
        std::vector<Vec3> all;
        for (Label s = 0; s <= slices; ++s)
            for (Label i = 0; i < corners; ++i)
                all.push_back(corner(s, i, i % 2 == 0 ? 1 : 0.8));
        all.push_back(corner(0, 0, 0));
        all.push_back(corner(slices, 0, 0));
        const Label top = slices * corners;
        const Label floor = top + corners;
        std::vector<std::vector<Label>> triangles;
        for (Label i = 0; i < corners; ++i) {
            const Label j = (i + 1) % corners;
            for (Label s = 0; s < top; s += corners) {
                triangles.push_back({s + i, s + j, s + corners + j});
                triangles.push_back({s + i, s + corners + j, s + corners + i});
            }
            triangles.push_back({floor, j, i});
            triangles.push_back({floor + 1, top + i, top + j});
        }
        return surfaceOf(all, triangles);
    }

    Trimmed trimmed(Keep keep) const {
        const TriSurface part = surface();
        Box box;
        for (const Vec3& p : part.points)
            box.add(p);
        const double size = 2 / cells;
        TrimOptions options;
        options.keep = keep;
        return trim(cartesianMesh(boxAround(box, size, defaultMargin(size))), part, options);
    }

    static constexpr Label slices = 24;
};

bool hasBluntPlace(const TrimSummary& summary) {
    return std::ranges::any_of(summary.remadePlaces, &FidelityPlace::isBlunt);
}

TEST(BluntPlaces, makeGoodCellsWhereFeaturesAreFinerThanCells) {
    const TwistedStar thread{3, 20, 0.3, 5};
    const double volume = measure(thread.surface()).volume;
    const auto [mesh, summary] = thread.trimmed(Keep::inside);
    EXPECT_EQ(summary.badCells, 0);
    EXPECT_TRUE(checkMesh(mesh, {}).isOk());
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_TRUE(hasBluntPlace(summary))
        << "this body no longer needs what this test is about: find another";
    EXPECT_NEAR(boundedVolume(mesh), volume, 0.05 * volume);
}

TEST(BluntPlaces, areNotNeededWhereMovesTogetherMendCells) {
    // Each cell that fails gets its share of the work, whatever is round it.
    for (const TwistedStar& star : {TwistedStar{4, 3, 0.2, 15}, TwistedStar{5, 3, 0.2, 12}}) {
        const TrimSummary summary = star.trimmed(Keep::outside).summary;
        EXPECT_EQ(summary.badCells, 0);
        EXPECT_EQ(summary.remadeCells, 0);
    }
}

} // namespace
} // namespace polymesh::test
