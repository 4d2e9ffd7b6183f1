// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/disjointSets.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace polymesh {

namespace {

using Pairs = std::vector<std::array<Label, 2>>;

DisjointSets joined(Label count, const Pairs& pairs) {
    DisjointSets sets(count);
    for (const auto& [a, b] : pairs)
        sets.join(a, b);
    return sets;
}

/// The lowest member that each can be reached from, step by step.
std::vector<Label> lowestByRelabelling(Label count, const Pairs& pairs) {
    std::vector<Label> lowest(index(count));
    std::iota(lowest.begin(), lowest.end(), Label{0});
    for (const auto& [a, b] : pairs) {
        const auto [low, high] = std::minmax({lowest[index(a)], lowest[index(b)]});
        std::ranges::replace(lowest, high, low);
    }
    return lowest;
}

Pairs randomPairs(Label count, int pairCount, std::mt19937& random) {
    std::uniform_int_distribution<Label> member(0, count - 1);
    Pairs pairs;
    for (int i = 0; i < pairCount; ++i)
        pairs.push_back({member(random), member(random)});
    return pairs;
}

TEST(DisjointSets, areAloneAtFirst) {
    DisjointSets sets(3);
    EXPECT_EQ(sets.count(), 3);
    for (Label i = 0; i < 3; ++i)
        EXPECT_EQ(sets.lowest(i), i);
}

TEST(DisjointSets, areKnownByTheirLowestMember) {
    DisjointSets sets = joined(6, {{5, 3}, {3, 4}, {2, 0}});
    EXPECT_EQ(sets.lowest(5), 3);
    EXPECT_EQ(sets.lowest(2), 0);
    EXPECT_EQ(sets.lowest(1), 1);
    sets.join(2, 5);
    EXPECT_EQ(sets.lowest(4), 0);
}

TEST(DisjointSets, doNotDependOnTheOrderOfJoining) {
    std::mt19937 random(1);
    for (const int pairCount : {0, 5, 40, 80, 300}) {
        Pairs pairs = randomPairs(100, pairCount, random);
        const std::vector<Label> expected = lowestByRelabelling(100, pairs);
        for (int trial = 0; trial < 5; ++trial) {
            DisjointSets sets = joined(100, pairs);
            for (Label i = 0; i < 100; ++i)
                EXPECT_EQ(sets.lowest(i), expected[index(i)]);
            EXPECT_EQ(joined(100, pairs).lowestOfEach(), expected);
            std::ranges::shuffle(pairs, random);
        }
    }
}

TEST(DisjointSets, areNumberedInOrderOfTheirLowestMembers) {
    const DisjointSets::Numbers numbers = joined(7, {{6, 1}, {5, 2}, {2, 4}}).numbers();
    EXPECT_EQ(numbers.of, (std::vector<Label>{0, 1, 2, 3, 2, 2, 1}));
    EXPECT_EQ(numbers.count, 4);
    EXPECT_EQ(DisjointSets().numbers().count, 0);
}

TEST(DisjointSets, growAndBeginAnew) {
    DisjointSets sets;
    sets.add();
    sets.add();
    sets.join(1, 0);
    sets.add();
    EXPECT_EQ(sets.count(), 3);
    EXPECT_EQ(sets.lowest(1), 0);
    EXPECT_EQ(sets.lowest(2), 2);
    sets.reset(2);
    EXPECT_EQ(sets.count(), 2);
    EXPECT_EQ(sets.lowest(1), 1);
}

} // namespace

} // namespace polymesh
