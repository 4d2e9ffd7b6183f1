// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/freshList.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace polymesh {

namespace {

TEST(FreshList, holdsTheValueEverywhere) {
    // Around the sizes from which pages are asked for, and not a whole number of pages.
    for (const std::size_t count : {0U, 1U, 4097U, 1U << 20U, (1U << 22U) + 3U, 5000001U}) {
        const std::vector<std::int32_t> list = freshList<std::int32_t>(count, -1);
        ASSERT_EQ(list.size(), count);
        EXPECT_TRUE(std::ranges::all_of(list, [](std::int32_t value) { return value == -1; }));
    }
}

TEST(FreshList, backedPagesKeepWhatTheyHold) {
    std::vector<char> bytes(std::size_t{1} << 23, 'x');
    backPages(bytes.data() + 1, bytes.size() - 2); // neither end on a page
    EXPECT_TRUE(std::ranges::all_of(bytes, [](char byte) { return byte == 'x'; }));
}

} // namespace

} // namespace polymesh
