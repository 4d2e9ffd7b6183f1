// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surfaceRepair/joinCracks.h"

#include "libpolymesh/surface/check.h"
#include "libpolymesh/surface/measure.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

namespace polymesh::test {
namespace {

/// A cube of size 100 whose lid has corners of its own, `gap` higher.
TriSurface withLooseLid(double gap, double size = 100) {
    TriSurface surface = cuboid({0, 0, 0}, {size, size, size});
    for (std::size_t t = surface.triangles.size() - 2; t < surface.triangles.size(); ++t)
        for (Label& corner : surface.triangles[t]) {
            const Vec3 p = surface.points[index(corner)] + Vec3{0, 0, gap};
            auto twin = std::ranges::find(surface.points, p);
            if (twin == surface.points.end()) twin = surface.points.insert(surface.points.end(), p);
            corner = toLabel(static_cast<std::size_t>(twin - surface.points.begin()));
        }
    return surface;
}

TEST(JoinCracks, closesACrackOfOneUnitInTheSixthDigit) {
    TriSurface surface = withLooseLid(0.001); // 100 and 100.001 as "%g" writes them
    EXPECT_EQ(checkSurface(surface).openEdges.count, 8);
    const auto joined = joinCracks(surface);
    ASSERT_TRUE(joined.has_value());
    EXPECT_TRUE(checkSurface(surface).isClosed());
    EXPECT_EQ(surface, cuboid({0, 0, 0}, {100, 100, 100}));
    EXPECT_EQ(joined->openEdges, 8);
    EXPECT_EQ(joined->points, 4);
    EXPECT_NEAR(joined->largestMove, 0.001, 1e-12);
    EXPECT_NEAR(joined->limit, 0.002, 1e-15);
}

TEST(JoinCracks, asksForSmallerCracksWhereTheFileHasMoreDigits) {
    TriSurface surface = withLooseLid(0.001);
    surface.points[0].x = 1.2345678e-3; // eight digits
    const TriSurface before = surface;
    EXPECT_FALSE(joinCracks(surface).has_value());
    EXPECT_EQ(surface, before);
    TriSurface narrow = withLooseLid(1e-5);
    narrow.points[0].x = 1.2345678e-3;
    EXPECT_TRUE(joinCracks(narrow).has_value());
}

TEST(JoinCracks, closesCracksOfSinglePrecisionWhateverTheDigits) {
    TriSurface surface = withLooseLid(0, 1.0 / 3);
    const double ulp = std::exp2(-25); // of single precision, at 1/3
    surface = withLooseLid(ulp, 1.0 / 3);
    const auto joined = joinCracks(surface);
    ASSERT_TRUE(joined.has_value());
    EXPECT_EQ(joined->limit, 2 * ulp);
    EXPECT_TRUE(checkSurface(surface).isClosed());
}

TEST(JoinCracks, leavesGapsThatRoundingDoesNotExplain) {
    TriSurface wide = withLooseLid(0.01);
    const TriSurface before = wide;
    EXPECT_FALSE(joinCracks(wide).has_value());
    EXPECT_EQ(wide, before);
    TriSurface open = without(sphere(2), 5);
    EXPECT_FALSE(joinCracks(open).has_value());
}

TEST(JoinCracks, closesAllOrNothing) {
    TriSurface surface = join(withLooseLid(0.001), without(cuboid({200, 0, 0}, {210, 10, 10}), 3));
    const TriSurface before = surface;
    EXPECT_FALSE(joinCracks(surface).has_value());
    EXPECT_EQ(surface, before);
}

TEST(JoinCracks, neverJoinsPointsThroughOthers) {
    // Three rims, each within the limit of the next but not of the one after it.
    TriSurface surface = withLooseLid(0.0015);
    const TriSurface other = withLooseLid(0.003);
    for (std::size_t t = other.triangles.size() - 2; t < other.triangles.size(); ++t) {
        std::array<Label, 3> corners = other.triangles[t];
        for (Label& corner : corners) {
            surface.points.push_back(other.points[index(corner)]);
            corner = surface.pointCount() - 1;
        }
        surface.triangles.push_back(corners);
        surface.region.push_back(0);
    }
    EXPECT_FALSE(joinCracks(surface).has_value());
}

TEST(JoinCracks, dropsTrianglesThatTheCrackWasMadeOf) {
    // A sliver of rounding between the lid and one wall closes with the rest.
    TriSurface surface = withLooseLid(0.001);
    const Label a = surface.triangles[10][0];
    surface.triangles.push_back({4, 5, a});
    surface.region.push_back(0);
    const auto joined = joinCracks(surface);
    ASSERT_TRUE(joined.has_value());
    EXPECT_EQ(surface.triangleCount(), 12);
}

} // namespace
} // namespace polymesh::test
