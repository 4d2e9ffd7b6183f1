// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <cstdint>
#include <vector>

namespace polymesh {

/// What was repaired.
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
/// cuts of a face) the best is made, as long as it leaves fewer failures, or less severe ones,
/// round it. Edges of the boundary are collapsed only if the volume hardly changes. Where nothing
/// improves, a narrow strip may be collapsed though that moves the trouble on to the next cell: at
/// most 8 times for each cell that is bad before. Ends when nothing improves any more, at the
/// latest after 50 changes for each cell that is bad before.
/// Cost: a look at each cell, about a millisecond for a bad one.
RepairCounts repairCells(MeshEditor& editor);

/// Mends the cells of a list that still fail by sequences of changes that help only together; what
/// that leaves is made into convex cells, or into pyramids, where it is better then. `work` bounds
/// the effort, in units of WorkBudget.
/// Cost: many milliseconds for a cell, whatever the size of the mesh.
RepairCounts repairThoroughly(MeshEditor& editor, std::vector<Label> cells, std::int64_t work);

} // namespace polymesh
