// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/grading.h"

#include <gtest/gtest.h>

#include <random>

namespace polymesh::test {
namespace {

TEST(Grading, evenWithoutOne) {
    EXPECT_EQ(gradedParameters(4, {}), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
}

TEST(Grading, lastCellIsTheExpansionTimesTheFirst) {
    const std::vector<double> t = gradedParameters(10, {{1, 1, 5}});
    EXPECT_NEAR((t[10] - t[9]) / (t[1] - t[0]), 5, 1e-12);
    EXPECT_NEAR((t[5] - t[4]) / (t[4] - t[3]), (t[2] - t[1]) / (t[1] - t[0]), 1e-12);
}

TEST(Grading, sectionsHaveTheirShares) {
    // the example of the user guide: fifths of the length, thirds of the cells
    const std::vector<double> t = gradedParameters(10, {{20, 30, 4}, {60, 40, 1}, {20, 30, 0.25}});
    EXPECT_DOUBLE_EQ(t[3], 0.2);
    EXPECT_DOUBLE_EQ(t[7], 0.8);
    EXPECT_NEAR((t[3] - t[2]) / t[1], 4, 1e-12);
    EXPECT_NEAR(t[5] - t[4], 0.15, 1e-12);
}

TEST(Grading, largestSectionTakesWhatRoundingLeaves) {
    const std::vector<double> t = gradedParameters(7, {{1, 1, 1}, {1, 3, 1}, {1, 1, 1}});
    EXPECT_DOUBLE_EQ(t[1], 1.0 / 3); // 1.4 cells: 1; 4.2: 4, and the one that is left
    EXPECT_DOUBLE_EQ(t[6], 2.0 / 3);
}

TEST(Grading, fewerCellsThanSectionsAreEven) {
    EXPECT_EQ(gradedParameters(2, {{1, 1, 3}, {5, 1, 1}, {1, 1, 1}}),
              (std::vector<double>{0, 0.5, 1}));
}

TEST(Grading, reversedIsTheSameFromTheOtherEnd) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0.1, 5);
    for (int repeat = 0; repeat < 100; ++repeat) {
        Grading grading;
        for (int s = 0; s < 1 + repeat % 4; ++s)
            grading.push_back({share(random), share(random), share(random)});
        const Label cells = 200 + repeat; // enough for every section to have some
        const std::vector<double> there = gradedParameters(cells, grading);
        const std::vector<double> back = gradedParameters(cells, reversed(grading));
        for (std::size_t i = 0; i < there.size(); ++i)
            EXPECT_NEAR(there[i], 1 - back[index(cells) - i], 1e-12);
    }
}

} // namespace
} // namespace polymesh::test
