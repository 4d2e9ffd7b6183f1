// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trimCell/cutByCells.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/trim/settleNodes.h"
#include "libpolymesh/trimCell/joinOutlines.h"
#include "libpolymesh/trimCell/joinPieces.h"

namespace polymesh {

namespace {

std::vector<CellCut> cutCells(const CellInputs& inputs) {
    constexpr Label block = 16;
    std::vector<CellCut> cuts(inputs.probe.cells.size());
    parallelBlocks(inputs.probe.cellCount(), block, [&](Label, Label first, Label last) {
        for (Label c = first; c < last; ++c)
            cuts[index(c)] = cutOneCell(inputs, c);
    });
    return cuts;
}

/// Throws where a cell that the surface should not touch has a node on another side.
void checkCellsBehind(const PolyMesh& mesh, const MeshCut& cut) {
    const Probe& probe = cut.probe;
    for (Label f = 0; f < probe.faceCount(); ++f) {
        const Label face = probe.faces[index(f)];
        if (!mesh.isInternal(face)) continue;
        for (const Label c : {mesh.owner[index(face)], mesh.neighbour[index(face)]}) {
            if (probe.localCell[index(c)] >= 0) continue;
            for (const Label n : probe.faceNodes[f])
                if (cut.arrangement.winding[index(n)] != cut.cellWinding[index(c)])
                    refuseDifference("a node", probe.nodePoints[index(n)]);
        }
    }
}

} // namespace

MeshCut findCutByCells(PolyMesh& mesh,
                       const FeaturedSurface& surface,
                       const AdjustedNodes& adjusted,
                       const TrimOptions& options) {
    const CuttingSurface& cutter = surface.cutter;
    const int shift = options.keep == Keep::outside ? 1 : 0;
    MeshCut cut;
    options.onStage("candidates");
    cut.probe = findProbe(mesh, *cutter.surface, cutter.triangleBoxes);
    cut.settled = probedNodes(cut.probe, adjusted.settled);
    addFacets(cutter.triangleBoxes, cut.probe);
    const SearchedSurface searched(cutter);
    cut.cellWinding = windCellsOneByOne(mesh, cut.probe, searched, shift);

    options.onStage("cells");
    const std::vector<CellCut> cuts = cutCells({cut.probe, searched, shift});

    options.onStage("join cells");
    const JoinInputs inputs{cut.probe, cutter, cuts};
    cut.arrangement = joinSites(inputs);
    checkCellsBehind(mesh, cut);
    cut.positions = placePoints(cut.probe, cutter, cut.arrangement);
    ExactFaces& faces = cut.faces.emplace();
    faces.loops = joinOutlines(inputs, cut.positions, cut.arrangement);
    faces.pieces = joinPieces(inputs, cut.arrangement);
    return cut;
}

} // namespace polymesh
