// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/repairMoves.h"

namespace polymesh {

/// Moves to be made one after the other, and what they do together.
struct RepairSequence {
    std::vector<RepairMove> moves;
    Badness change; // after - before: negative is good
};

/// Looks for up to 5 moves of which only all together make the cells round a failing cell better.
/// From each state the moves of the cells that fail in it are tried, and the best few states are
/// gone on from, also when they are worse than what was there. Empty if nothing helps, or when the
/// cell has had its share of the budget. Cost: some 1,000 tries.
RepairSequence findSequence(MeshEditor& editor, Label cell, WorkBudget& budget);

/// Makes the moves; returns the cells that are changed or new, ascending, without removed ones.
/// If one of them cannot be made the caller undoes: `complete` is then false.
std::vector<Label>
makeSequence(MeshEditor& editor, const RepairSequence& sequence, bool* complete = nullptr);

} // namespace polymesh
