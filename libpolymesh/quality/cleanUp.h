// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/editMesh.h"

#include <cstdint>
#include <span>

namespace polymesh {

/// How far clean-up may go.
struct CleanUpOptions {
    double minEdge = 0;   // collapse edges shorter than this fraction of the cell size; 0: none
    double minVolume = 0; // merge cells smaller than this fraction of the cell size cubed; 0: none
    bool mendsCells = true;            // cut concave cells and repair what checkMesh would fail
    std::int64_t thoroughWork = 80000; // most units of WorkBudget on what single repairs leave bad
    bool mayPinch = false;     // cells may touch themselves along edges: see separatePinches.h
    double concaveAngle = 0.1; // [rad] cells are cut at edges with more than 180 degrees and this
};

/// What clean-up did.
struct CleanUpCounts {
    Label zeroCells = 0;   // cells without volume that went
    Label brokenCells = 0; // cells that could not be closed: 0 unless there is a bug
    Label mergedFaces = 0;
    Label collapsedEdges = 0;
    Label mergedCells = 0;
    Label cutCells = 0;    // cuts of concave cells
    Label repairs = 0;     // other local changes
    Label badCells = 0;    // cells that checkMesh fails, at the end
    std::int64_t work = 0; // on repairs, in units of WorkBudget
};

/// All of clean-up in order: what has no size goes, also with all options off (collapsePoints,
/// removeZeroSize, mergeFaces for coplanar faces); then collapseShortEdges, mergeSmallCells,
/// splitConcaveCells and repairCells, then repairThoroughly, as the options ask for.
/// docs/cleanUp.md tells more. Requires: representative as in collapsePoints. Cost: about a
/// microsecond for a cell in order.
CleanUpCounts
cleanUp(EditMesh& mesh, std::span<const Label> representative, const CleanUpOptions& options);

} // namespace polymesh
