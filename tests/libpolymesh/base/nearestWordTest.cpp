// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/nearestWord.h"

#include <gtest/gtest.h>

#include <vector>

namespace polymesh {

TEST(NearestWord, forgivesOneLetterSwapsAndCase) {
    const std::vector<std::string> known{"deviation", "minEdge", "minVolume", "keep"};
    EXPECT_EQ(nearestWord("deviatoin", known), "deviation");
    EXPECT_EQ(nearestWord("minedge", known), "minEdge");
    EXPECT_EQ(nearestWord("minVolum", known), "minVolume");
    EXPECT_EQ(nearestWord("kep", known), "keep");
}

TEST(NearestWord, isTheFirstOfEqualsAndEmptyForNone) {
    EXPECT_EQ(nearestWord("x", std::vector<std::string>{"a", "b"}), "a");
    EXPECT_EQ(nearestWord("x", std::vector<std::string>{}), "");
}

} // namespace polymesh
