// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace polymesh::test {
namespace {

struct Chain {
    std::vector<Vec3> points;
    std::vector<Label> polygon;
};

/// A closed wavy curve round the z axis; point labels are shuffled.
Chain wavy(std::size_t n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-0.02, 0.02);
    Chain chain;
    chain.points.resize(n);
    for (std::size_t i = 0; i < n; ++i)
        chain.polygon.push_back(toLabel(i));
    for (std::size_t i = n; i > 1; --i)
        std::swap(chain.polygon[i - 1], chain.polygon[random() % i]);
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        const double radius = 1 + 0.2 * std::sin(3 * angle) + noise(random);
        chain.points[index(chain.polygon[i])] = {
            radius * std::cos(angle), radius * std::sin(angle), noise(random)};
    }
    return chain;
}

std::vector<char> keptOf(const Chain& chain, double tolerance, std::vector<char> isKept) {
    keepWithin(
        chain.points,
        chain.polygon,
        tolerance,
        [&](std::size_t i) { return isKept[i] != 0; },
        [&](std::size_t i) { isKept[i] = 1; });
    return isKept;
}

std::vector<char> none(const Chain& chain) {
    return std::vector<char>(chain.polygon.size(), 0);
}

/// The largest distance of a dropped point from the edge that replaces its part.
double worstDistance(const Chain& chain, const std::vector<char>& isKept) {
    const std::size_t n = isKept.size();
    const auto at = [&](std::size_t i) { return chain.points[index(chain.polygon[i % n])]; };
    double worst = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (isKept[i] != 0) continue;
        std::size_t before = i + n;
        std::size_t after = i;
        while (isKept[before % n] == 0)
            --before;
        while (isKept[after % n] == 0)
            ++after;
        worst = std::max(worst, distanceToSegment(at(i), at(before), at(after)));
    }
    return worst;
}

TEST(KeepWithin, noDroppedPointIsFartherThanTheTolerance) {
    for (const unsigned seed : {1U, 2U, 3U})
        for (const double tolerance : {0.0, 0.003, 0.03, 0.3}) {
            const Chain chain = wavy(200, seed);
            EXPECT_LE(worstDistance(chain, keptOf(chain, tolerance, none(chain))), tolerance);
        }
}

TEST(KeepWithin, keepsFewerPointsWithALargerTolerance) {
    const Chain chain = wavy(300, 4);
    std::ptrdiff_t before = 301;
    for (const double tolerance : {0.0, 0.01, 0.05, 0.2}) {
        const auto count = std::ranges::count(keptOf(chain, tolerance, none(chain)), char{1});
        EXPECT_LT(count, before);
        before = count;
    }
}

TEST(KeepWithin, keepsAtLeastThreePoints) {
    for (const std::size_t n : {3U, 4U, 17U}) {
        const Chain chain = wavy(n, 5);
        EXPECT_EQ(std::ranges::count(keptOf(chain, 1e9, none(chain)), char{1}), 3);
        std::vector<char> two = none(chain);
        two[0] = two[1] = 1;
        EXPECT_EQ(std::ranges::count(keptOf(chain, 1e9, two), char{1}), 3);
    }
}

TEST(KeepWithin, whatIsKeptStaysAndNothingMoreIsNeeded) {
    const Chain chain = wavy(100, 6);
    std::vector<char> some = none(chain);
    some[7] = some[50] = some[51] = some[99] = 1;
    const std::vector<char> once = keptOf(chain, 0.02, some);
    for (const std::size_t i : {7U, 50U, 51U, 99U})
        EXPECT_EQ(once[i], 1);
    EXPECT_EQ(keptOf(chain, 0.02, once), once);
}

TEST(KeepWithin, dropsPointsOnStraightSidesExactly) {
    const std::array<Vec3, 4> corners{Vec3{0, 0, 0}, Vec3{8, 0, 0}, Vec3{8, 8, 0}, Vec3{0, 8, 0}};
    Chain square;
    for (std::size_t i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k) {
            square.polygon.push_back(toLabel(square.points.size()));
            square.points.push_back(corners[i] + 0.25 * k * (corners[(i + 1) % 4] - corners[i]));
        }
    std::vector<char> start = none(square);
    start[0] = 1;
    const std::vector<char> isKept = keptOf(square, 0, start);
    for (std::size_t i = 0; i < 16; ++i)
        EXPECT_EQ(isKept[i] != 0, i % 4 == 0) << i;
}

TEST(Distances, agreeWithManySamples) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto point = [&] { return Vec3{unit(random), unit(random), unit(random)}; };
    for (int i = 0; i < 200; ++i) {
        const Vec3 p = 2 * point();
        const Vec3 a = point();
        const Vec3 b = point();
        const Vec3 c = point();
        double segment = 1e9;
        double triangle = 1e9;
        constexpr int n = 60;
        for (int u = 0; u <= n; ++u) {
            segment = std::min(segment, norm(p - (a + u / double{n} * (b - a))));
            for (int v = 0; u + v <= n; ++v)
                triangle = std::min(
                    triangle, norm(p - (a + u / double{n} * (b - a) + v / double{n} * (c - a))));
        }
        EXPECT_LE(distanceToSegment(p, a, b), segment + 1e-15);
        EXPECT_NEAR(distanceToSegment(p, a, b), segment, 0.03);
        EXPECT_LE(distanceToTriangle(p, a, b, c), triangle + 1e-15);
        EXPECT_NEAR(distanceToTriangle(p, a, b, c), triangle, 0.05);
    }
}

TEST(Distances, shapesWithoutSizeAreTheirCorners) {
    const Vec3 a{1, 2, 3};
    EXPECT_DOUBLE_EQ(distanceToSegment({1, 2, 5}, a, a), 2);
    EXPECT_DOUBLE_EQ(distanceToTriangle({1, 2, 5}, a, a, a), 2);
    EXPECT_DOUBLE_EQ(distanceToTriangle({1, 2, 5}, a, {1, 2, 4}, {1, 2, 4.5}), 0.5);
}

} // namespace
} // namespace polymesh::test
