// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace polymesh {

/// Bounds the work on cells that need mending, in counts so that the result does not depend on the
/// speed of the machine. The unit is a change that is tried and judged on a cell of some 16 faces,
/// 20 to 50 microseconds. Few cells get as much as they can use; where a large part of a mesh needs
/// mending (features smaller than its cells) each gets a fair share of what is there.
class WorkBudget {
public:
    explicit WorkBudget(std::int64_t units) : whole_(units), left_(units) {}

    /// Starts with a cell while `waiting` others are in the queue: it may use four times its share.
    void startCell(std::size_t waiting) {
        constexpr std::int64_t least = 8;
        share_ = std::max(least, 4 * left_ / (static_cast<std::int64_t>(waiting) + 1));
    }

    /// Counts a try on a cell with so many faces. False when the cell has had its share.
    bool spend(std::size_t faces) {
        if (share_ <= 0 || left_ <= 0) return false;
        const std::int64_t units = 1 + static_cast<std::int64_t>(faces) / 16;
        share_ -= units;
        left_ -= units;
        return true;
    }

    bool isSpent() const { return left_ <= 0; }

    /// Units used so far.
    std::int64_t used() const { return whole_ - left_; }

private:
    std::int64_t whole_;
    std::int64_t left_;
    std::int64_t share_ = 0;
};

} // namespace polymesh
