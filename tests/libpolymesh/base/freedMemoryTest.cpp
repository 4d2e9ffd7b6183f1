// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/freedMemory.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <unistd.h>
#include <vector>

namespace polymesh {

namespace {

/// Memory of this process that is backed by pages [bytes].
std::size_t residentBytes() {
    std::ifstream file("/proc/self/statm");
    std::size_t total = 0;
    std::size_t resident = 0;
    file >> total >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

TEST(FreedMemory, goesBackToTheSystemEvenBelowWhatIsInUse) {
#if !defined(__GLIBC__) || defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "another allocator";
#endif
    constexpr std::size_t blockSize = 16384; // too small for a mapping of its own
    std::vector<std::unique_ptr<std::vector<char>>> blocks;
    blocks.reserve(4000);
    for (int i = 0; i < 4000; ++i)
        blocks.push_back(std::make_unique<std::vector<char>>(blockSize, 'x'));
    const std::unique_ptr<std::vector<char>> last = std::move(blocks.back());
    blocks.clear();
    const std::size_t before = residentBytes();
    giveBackFreedMemory();
    EXPECT_LT(residentBytes() + 3000 * blockSize, before);
    EXPECT_EQ(last->back(), 'x');
}

} // namespace

} // namespace polymesh
