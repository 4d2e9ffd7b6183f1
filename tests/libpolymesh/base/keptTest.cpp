// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/kept.h"

#include <gtest/gtest.h>

namespace polymesh {

namespace {

TEST(Kept, numbersWhatStaysInOrder) {
    for (const Label count : {0, 1, 256, 8192, 8193, 20000}) {
        const auto isThird = [](Label i) { return i % 3 == 1; };
        const Kept kept(count, isThird);
        std::vector<Label> expected;
        for (Label i = 0; i < count; ++i) {
            EXPECT_EQ(kept.countBefore(i), toLabel(expected.size()));
            EXPECT_EQ(kept.isKept(i), isThird(i));
            if (isThird(i)) expected.push_back(i);
        }
        ASSERT_EQ(kept.count(), toLabel(expected.size()));
        EXPECT_EQ(kept.countBefore(count), kept.count());
        std::vector<Label> found(expected.size(), -1);
        kept.forEach([&](Label i, Label to) { found[index(to)] = i; });
        EXPECT_EQ(found, expected);
    }
}

} // namespace

} // namespace polymesh
