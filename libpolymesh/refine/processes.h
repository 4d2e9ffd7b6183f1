// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <cstdint>
#include <vector>

namespace polymesh {

/// The processes that work on one mesh. All must call the same functions in the same order.
class Processes {
public:
    /// This one alone.
    Processes() = default;

    /// Those that mpirun started. Starts MPI, which ends with the program.
    static Processes ofMpirun();

    int rank() const { return rank_; }

    int count() const { return count_; }

    /// The lists of all, by rank.
    std::vector<std::uint64_t> gather(const std::vector<std::uint64_t>& own) const;
    std::vector<Label> gather(const std::vector<Label>& own) const;

    /// Gives each process a list; returns those that they gave to this one, by rank.
    std::vector<std::vector<Label>> exchange(const std::vector<std::vector<Label>>& lists) const;

    /// Ends all processes at once: for one that failed while others wait for it.
    [[noreturn]] static void abort(int status);

private:
    int rank_ = 0;
    int count_ = 1;
};

/// Starts MPI, once. A program that mpirun did not start is alone.
void startMpi();

} // namespace polymesh
