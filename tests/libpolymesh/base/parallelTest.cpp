// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/parallel.h"

#include "libpolymesh/base/parallelSort.h"
#include "libpolymesh/base/threadLimit.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace polymesh {

namespace {

TEST(ParallelFor, visitsEachElementOnce) {
    for (const Label count : {0, 1, 511, 512, 513, 100000}) {
        std::vector<int> visits(index(count), 0);
        parallelFor(count, [&](Label i) { ++visits[index(i)]; });
        EXPECT_EQ(visits, std::vector<int>(index(count), 1));
    }
}

TEST(ParallelFor, passesExceptionsOn) {
    const auto throwAt = [](Label i) {
        if (i == 70000) throw std::out_of_range("70000");
    };
    EXPECT_THROW(parallelFor(100000, throwAt), std::out_of_range);
}

TEST(ParallelBlocks, areTheSameForAnyNumberOfThreads) {
    for (const std::size_t threads : {1U, 4U}) {
        const ThreadLimit limit(threads);
        std::vector<Label> firsts(4, -1);
        std::vector<Label> lasts(4, -1);
        parallelBlocks(31, 10, [&](Label block, Label first, Label last) {
            firsts[index(block)] = first;
            lasts[index(block)] = last;
        });
        EXPECT_EQ(firsts, (std::vector<Label>{0, 10, 20, 30}));
        EXPECT_EQ(lasts, (std::vector<Label>{10, 20, 30, 31}));
    }
}

TEST(ParallelBlocks, ofNothingAreNone) {
    parallelBlocks(0, 10, [](Label, Label, Label) { FAIL(); });
}

TEST(ParallelReduce, keepsTheOrderOfTerms) {
    using List = std::vector<Label>;
    const auto joined = [](List a, const List& b) {
        a.insert(a.end(), b.begin(), b.end());
        return a;
    };
    for (const Label count : {0, 1, 4096, 4097, 12289}) {
        std::vector<Label> expected(index(count));
        std::iota(expected.begin(), expected.end(), 0);
        EXPECT_EQ(parallelReduce(
                      count, List{}, [](Label i) { return List{i}; }, joined),
                  expected);
    }
}

TEST(ParallelSum, isTheSameForAnyNumberOfThreads) {
    const auto sum = [](std::size_t threads) {
        const ThreadLimit limit(threads);
        return parallelSum(300000, 0.0, [](Label i) { return std::sin(i) / (1 + i); });
    };
    EXPECT_EQ(sum(1), sum(2));
    EXPECT_EQ(sum(1), sum(7));
}

TEST(ParallelSum, isMadeOfHalves) {
    // The sum of large terms with one small at either end depends on what is added to what: four
    // quarters of 3000 terms, each from zero, then pairs.
    const auto term = [](Label i) { return i % 3000 == 0 ? 0.1 : 1e16 * (i % 2 == 0 ? 1 : -1); };
    const auto quarter = [&](Label first) {
        double sum = 0;
        for (Label i = first; i != first + 3000; ++i)
            sum += term(i);
        return sum;
    };
    const double expected = (quarter(0) + quarter(3000)) + (quarter(6000) + quarter(9000));
    EXPECT_EQ(parallelSum(12000, 0.0, term), expected);
}

TEST(ThreadLimit, holdsForItsLifetime) {
    std::atomic<int> running = 0;
    std::atomic<bool> together = false;
    const ThreadLimit limit(1);
    parallelBlocks(1000, 1, [&](Label, Label, Label) {
        if (++running > 1) together = true;
        --running;
    });
    EXPECT_FALSE(together);
}

TEST(ParallelSort, sorts) {
    const Label count = 10007; // a prime
    std::vector<Label> values(index(count));
    for (Label i = 0; i < count; ++i)
        values[index(i)] = i * 37 % count;
    parallelSort(values);
    std::vector<Label> expected(values.size());
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(values, expected);
}

} // namespace

} // namespace polymesh
