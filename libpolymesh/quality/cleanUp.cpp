// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/cleanUp.h"

#include "libpolymesh/quality/collapseEdges.h"
#include "libpolymesh/quality/collapsePoints.h"
#include "libpolymesh/quality/editParts.h"
#include "libpolymesh/quality/mergeCells.h"
#include "libpolymesh/quality/mergeFaces.h"
#include "libpolymesh/quality/meshEditor.h"
#include "libpolymesh/quality/removeZeroSize.h"
#include "libpolymesh/quality/repairCells.h"
#include "libpolymesh/quality/separatePinches.h"
#include "libpolymesh/quality/splitConcaveCells.h"

namespace polymesh {

namespace {

/// Small meshes are edited whole: a part has to be much thicker than what is done twice at its
/// seams.
constexpr Label leastCellsOfPart = 30000;

void removeWhatHasNoSize(EditMesh& mesh,
                         std::span<const Label> representative,
                         bool mayPinch,
                         CleanUpCounts& counts) {
    MeshEditor editor(mesh);
    const CollapseCounts collapsed = collapsePoints(editor, representative);
    const ZeroSizeCounts zero = removeZeroSize(editor);
    counts.zeroCells = collapsed.removedCells + zero.cells;
    counts.mergedFaces = mergeFaces(editor, 0);
    if (mayPinch || collapsed.brokenCells > 0) counts.brokenCells = separatePinches(editor);
}

void add(const RepairCounts& repaired, CleanUpCounts& counts) {
    counts.cutCells += repaired.cuts;
    counts.repairs += repaired.merges + repaired.collapses + repaired.splits + repaired.remakes;
    counts.work += repaired.work;
}

/// Returns what was done; `badCells` become the cells that checkMesh still fails.
CleanUpCounts improve(EditMesh& mesh, const CleanUpOptions& options, std::vector<Label>& badCells) {
    MeshEditor editor(mesh);
    CleanUpCounts counts;
    counts.collapsedEdges = collapseShortEdges(editor, options.minEdge);
    counts.mergedCells = mergeSmallCells(editor, options.minVolume);
    if (!options.mendsCells) return counts;
    counts.cutCells = splitConcaveCells(editor, options.concaveAngle).cuts;
    RepairCounts repaired = repairCells(editor);
    add(repaired, counts);
    badCells = std::move(repaired.left);
    return counts;
}

void add(const CleanUpCounts& part, CleanUpCounts& counts) {
    counts.collapsedEdges += part.collapsedEdges;
    counts.mergedCells += part.mergedCells;
    counts.cutCells += part.cutCells;
    counts.repairs += part.repairs;
    counts.work += part.work;
}

/// Improves the parts side by side and adds up what was done; returns the bad cells left in them.
std::vector<Label> improveParts(EditMesh& mesh,
                                CellParts& parts,
                                const CleanUpOptions& options,
                                CleanUpCounts& counts) {
    std::vector<CleanUpCounts> ofPart(index(parts.count));
    std::vector<Label> badCells = editParts(mesh, parts, [&](EditMesh& own, Label part) {
        std::vector<Label> bad;
        ofPart[index(part)] = improve(own, options, bad);
        return bad;
    });
    for (const CleanUpCounts& part : ofPart)
        add(part, counts);
    return badCells;
}

/// Improves slab by slab, then along the seams between them. Returns the cells that are bad then;
/// some may have been mended or removed along the seams.
std::vector<Label> improveInSlabs(EditMesh& mesh,
                                  CellParts& slabs,
                                  const CleanUpOptions& options,
                                  CleanUpCounts& counts) {
    std::vector<Label> bad = improveParts(mesh, slabs, options, counts);
    CellParts seams = alongSeams(mesh, slabs);
    const std::vector<Label> badAtSeams = improveParts(mesh, seams, options, counts);
    bad.insert(bad.end(), badAtSeams.begin(), badAtSeams.end());
    return bad;
}

/// What single repairs have left, wherever it is. Returns the number of cells left bad.
Label mendTheRest(EditMesh& mesh,
                  std::vector<Label> badCells,
                  const CleanUpOptions& options,
                  CleanUpCounts& counts) {
    if (badCells.empty()) return 0;
    MeshEditor editor(mesh);
    const RepairCounts repaired =
        repairThoroughly(editor, std::move(badCells), options.thoroughWork);
    add(repaired, counts);
    return toLabel(repaired.left.size());
}

} // namespace

CleanUpCounts
cleanUp(EditMesh& mesh, std::span<const Label> representative, const CleanUpOptions& options) {
    CleanUpCounts counts;
    removeWhatHasNoSize(mesh, representative, options.mayPinch, counts);
    if (options.minEdge <= 0 && options.minVolume <= 0 && !options.mendsCells) return counts;
    CellParts slabs = divideIntoSlabs(mesh, leastCellsOfPart);
    std::vector<Label> badCells;
    if (slabs.count > 1)
        badCells = improveInSlabs(mesh, slabs, options, counts);
    else
        add(improve(mesh, options, badCells), counts);
    counts.badCells = mendTheRest(mesh, std::move(badCells), options, counts);
    return counts;
}

} // namespace polymesh
