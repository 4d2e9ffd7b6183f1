// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/polygonTriangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polymesh {
namespace {

using Triangles = std::vector<std::array<std::size_t, 3>>;

Vec3 areaOf(const std::vector<Vec3>& polygon, const std::array<std::size_t, 3>& t) {
    return 0.5 * cross(polygon[t[1]] - polygon[t[0]], polygon[t[2]] - polygon[t[0]]);
}

/// The triangles cover the plane polygon once: all face its way, and their areas sum to its own.
void expectCovered(const std::vector<Vec3>& polygon, double area) {
    const Triangles triangles = polygonTriangles(polygon);
    EXPECT_EQ(triangles.size(), polygon.size() - 2);
    double sum = 0;
    for (const auto& t : triangles)
        sum += norm(areaOf(polygon, t)); // a fold would be counted twice
    EXPECT_NEAR(sum, area, 1e-12 * area);
}

TEST(PolygonTriangles, convexPolygonsAreFansFromTheirFirstCorner) {
    EXPECT_EQ(polygonTriangles(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
              (Triangles{{0, 1, 2}}));
    EXPECT_EQ(polygonTriangles(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
              (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(PolygonTriangles, anLDoesNotFoldWhateverItsFirstCorner) {
    std::vector<Vec3> polygon{{0, 0, 2}, {2, 0, 2}, {2, 1, 2}, {1, 1, 2}, {1, 2, 2}, {0, 2, 2}};
    for (std::size_t turn = 0; turn < polygon.size(); ++turn) {
        expectCovered(polygon, 3);
        std::vector<Vec3> below = polygon;
        std::ranges::reverse(below);
        expectCovered(below, 3);
        std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    }
}

TEST(PolygonTriangles, aStarAndACombAreCoveredOnce) {
    std::vector<Vec3> star;
    double area = 0;
    for (int i = 0; i < 20; ++i) {
        const double r = i % 2 == 0 ? 1 : 0.2;
        const double angle = 2 * std::numbers::pi * i / 20;
        star.push_back({0.3, r * std::cos(angle), r * std::sin(angle)});
        area += 0.5 * 0.2 * std::sin(2 * std::numbers::pi / 20);
    }
    expectCovered(star, area);
    std::vector<Vec3> comb{{0, 0, 0}, {9, 0, 0}};
    for (int tooth = 4; tooth >= 0; --tooth) {
        comb.push_back({2.0 * tooth + 1, 3, 0});
        comb.push_back({2.0 * tooth, 3, 0});
        if (tooth > 0) comb.push_back({2.0 * tooth, 1, 0});
        if (tooth > 0) comb.push_back({2.0 * tooth - 1, 1, 0});
    }
    expectCovered(comb, 9 * 1 + 5 * 2);
}

TEST(PolygonTriangles, aPolygonThatCrossesItselfIsAFan) {
    const std::vector<Vec3> bow{{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 2, 0}};
    EXPECT_EQ(polygonTriangles(bow), (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

} // namespace
} // namespace polymesh
