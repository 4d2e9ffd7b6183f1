// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/cleanUp.h"

#include "libpolymesh/quality/collapseEdges.h"
#include "libpolymesh/quality/collapsePoints.h"
#include "libpolymesh/quality/mergeCells.h"
#include "libpolymesh/quality/mergeFaces.h"
#include "libpolymesh/quality/removeZeroSize.h"
#include "libpolymesh/quality/repairCells.h"
#include "libpolymesh/quality/splitConcaveCells.h"

namespace polymesh {

CleanUpCounts
cleanUp(EditMesh& mesh, std::span<const Label> representative, const CleanUpOptions& options) {
    MeshEditor editor(mesh);
    CleanUpCounts counts;
    const CollapseCounts collapsed = collapsePoints(editor, representative);
    const ZeroSizeCounts zero = removeZeroSize(editor);
    counts.zeroCells = collapsed.removedCells + zero.cells;
    counts.brokenCells = collapsed.brokenCells;
    counts.mergedFaces = mergeFaces(editor, 0);
    counts.collapsedEdges = collapseShortEdges(editor, options.minEdge);
    counts.mergedCells = mergeSmallCells(editor, options.minVolume);
    if (!options.mendsCells) return counts;
    counts.cutCells = splitConcaveCells(editor, options.concaveAngle).cuts;
    const RepairCounts repaired = repairCells(editor);
    counts.cutCells += repaired.cuts;
    counts.repairs = repaired.merges + repaired.collapses + repaired.splits;
    counts.badCells = repaired.left;
    return counts;
}

} // namespace polymesh
