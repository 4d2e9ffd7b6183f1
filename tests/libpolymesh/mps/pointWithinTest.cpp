// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/pointWithin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace polymesh {

namespace {

/// The six sides of a box, as seen from inside.
std::vector<HalfSpace> sidesOf(const Vec3& low, const Vec3& high) {
    return {{{1, 0, 0}, low},
            {{0, 1, 0}, low},
            {{0, 0, 1}, low},
            {{-1, 0, 0}, high},
            {{0, -1, 0}, high},
            {{0, 0, -1}, high}};
}

double depthAt(const std::vector<HalfSpace>& sides, const Vec3& x) {
    double least = std::numeric_limits<double>::max();
    for (const HalfSpace& h : sides)
        least = std::min(least, dot(h.normal, x - h.at));
    return least;
}

Vec3 randomUnit(std::mt19937& generator) {
    std::normal_distribution<double> normal;
    const Vec3 v{normal(generator), normal(generator), normal(generator)};
    return v / norm(v);
}

} // namespace

TEST(PointWithin, staysWhereTheStartIsDeep) {
    const Vec3 start{0.4, 0.6, 0.5};
    EXPECT_EQ(pointWithin(sidesOf({0, 0, 0}, {1, 1, 1}), start, 1), start);
}

TEST(PointWithin, findsThinSlabsFromOutside) {
    const auto sides = sidesOf({0, 0, 0}, {1, 1, 1e-3});
    const auto found = pointWithin(sides, {0.5, 0.5, 0.7}, 1);
    ASSERT_TRUE(found);
    EXPECT_GT(depthAt(sides, *found), 2.4e-4);
}

TEST(PointWithin, respectsTheLeastDepth) {
    const auto sides = sidesOf({0, 0, 0}, {1, 1, 1e-3});
    EXPECT_FALSE(pointWithin(sides, {0.5, 0.5, 0.7}, 1, {.least = 6e-4}));
}

TEST(PointWithin, isNoneWherePlanesFaceAway) {
    auto sides = sidesOf({0, 0, 0}, {1, 1, 1});
    sides.push_back({{0, 0, 1}, {0, 0, 1.1}});
    EXPECT_FALSE(pointWithin(sides, {0.5, 0.5, 0.5}, 1));
    EXPECT_FALSE(pointWithin(std::vector<HalfSpace>{{{}, {}}}, {0, 0, 0}, 1));
}

TEST(PointWithin, findsPointsWhereThereAreAny) {
    std::mt19937 generator(7);
    for (int round = 0; round < 500; ++round) {
        const Vec3 inside = 0.5 * randomUnit(generator);
        std::vector<HalfSpace> sides;
        for (int i = 0; i < 60; ++i) {
            const Vec3 n = randomUnit(generator);
            sides.push_back({n, inside - 1e-3 * n});
        }
        const auto found = pointWithin(sides, {0, 0, 0}, 1);
        ASSERT_TRUE(found) << round;
        EXPECT_GT(depthAt(sides, *found), 4e-4) << round;
        sides.push_back({{1, 0, 0}, inside + Vec3{0.5, 0, 0}});
        EXPECT_FALSE(pointWithin(sides, {0, 0, 0}, 1)) << round;
    }
}

} // namespace polymesh
