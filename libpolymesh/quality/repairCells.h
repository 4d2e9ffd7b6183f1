// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <cstdint>
#include <vector>

namespace polymesh {

/// How hard to try.
enum class RepairEffort : std::uint8_t {
    quick,   // single changes
    thorough // also sequences of changes that help only together, and cells made anew
};

/// What repairCells did.
struct RepairCounts {
    Label bad = 0;           // cells that checkMesh would fail, before
    Label cuts = 0;          // improvements by cutting a concave cell,
    Label merges = 0;        // by merging a cell into a neighbour,
    Label collapses = 0;     // by collapsing an edge,
    Label splits = 0;        // by cutting a face,
    Label remakes = 0;       // by making a cell into convex ones or into pyramids
    std::int64_t work = 0;   // units of WorkBudget
    std::vector<Label> left; // cells that still fail, ascending
};

/// Mends cells that OpenFOAM's checkMesh fails by default, one by one: of all the local changes
/// that are possible (cuts at reflex edges, merges with a neighbour, collapses of an edge,
/// cuts of a face; where none helps the cell is made into convex ones, or into pyramids) the best
/// is made, as long as it leaves fewer failures, or less severe ones, round it. Edges of the
/// boundary are collapsed only if the volume hardly changes. Where nothing improves, a narrow strip
/// may be collapsed though that moves the trouble on to the next cell: at most 8 times for each
/// cell that is bad before. Ends when nothing improves any more, at the latest after 50 changes for
/// each cell that is bad before. Cost: a look at each cell, about a millisecond for a bad one, many
/// for those that need sequences.
RepairCounts repairCells(EditMesh& mesh, RepairEffort effort);
RepairCounts repairCells(MeshEditor& editor, RepairEffort effort);

} // namespace polymesh
