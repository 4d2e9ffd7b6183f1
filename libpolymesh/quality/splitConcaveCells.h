// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/possibleCuts.h"

namespace polymesh {

/// What splitConcaveCells did.
struct SplitCounts {
    Label concave = 0; // cells with reflex edges that checkMesh would fail
    Label cuts = 0;    // cuts made: each adds a cell
    Label left = 0;    // cells that still fail
};

/// Cuts cells that are concave and fail for it (wrong face pyramids, skewness or non-orthogonality
/// at one of their faces) at their reflex edges with an excess over `tolerance` [rad], into pieces
/// that are better than the whole; the pieces again where they need it, as long as there are fewer
/// than 50 cuts for each cell that is concave and fails before, and the work budget lasts (20,000
/// tries and 2 for each cell). The faces that a cut crosses are cut for both cells that share them.
/// Cost: a parallel look at each cell, half a millisecond for a cell to cut. Reference: the paper,
/// section 3.2, with planes in place of its face criteria.
SplitCounts splitConcaveCells(MeshEditor& editor, double tolerance);

/// Cuts a cell, and the pieces again, by the cuts that leave the least concavity, though a single
/// one may not make anything better; kept if all of them together do. Returns the number of cuts
/// made.
Label cutInSteps(MeshEditor& editor, Label cell, double tolerance, WorkBudget& budget);

/// The best cut of a cell at one of its reflex edges, if it leaves the cells round it better.
std::optional<CellCut>
bestReflexCut(MeshEditor& editor, Label cell, double tolerance, WorkBudget& budget);

/// The same with the planes that halve the angle at each edge of the cell, concave or not: the last
/// resort, dearer by an order of magnitude.
std::optional<CellCut> bestHalvingCut(MeshEditor& editor, Label cell, WorkBudget& budget);

} // namespace polymesh
