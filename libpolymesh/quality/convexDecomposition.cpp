// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/convexDecomposition.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/quality/concaveFaces.h"
#include "libpolymesh/quality/cutCell.h"
#include "libpolymesh/quality/meshPart.h"
#include "libpolymesh/quality/possibleCuts.h"
#include "libpolymesh/quality/starPoint.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>

namespace polymesh {

namespace {

bool isConvex(MeshEditor& editor, Label cell, double angle) {
    const auto& faces = editor.cell(cell).faces;
    return reflexEdges(editor, cell, angle).empty() &&
           std::none_of(
               faces.begin(), faces.end(), [&](Label f) { return faceExcess(editor, f) > angle; });
}

/// Makes a cell convex.
class Decomposer {
public:
    Decomposer(MeshEditor& editor, const DecompositionOptions& options, WorkBudget& budget)
        : editor_(editor), options_(options), budget_(budget) {}

    DecompositionCounts decompose(Label cell) {
        if (isConvex(editor_, cell, options_.angle)) return counts_;
        ++counts_.concaveCells;
        decomposeCell(cell);
        return std::move(counts_);
    }

private:
    void decomposeCell(Label cell) {
        std::deque<Label> waiting{cell};
        std::vector<Label> pieces;
        Label cutsLeft = options_.maxCuts;
        while (!waiting.empty()) {
            const Label piece = waiting.front();
            waiting.pop_front();
            const double excess = totalExcess(editor_, piece, options_.angle);
            const Label added = excess > 0 && cutsLeft > 0 ? cut(piece, excess) : -1;
            if (added >= 0) {
                --cutsLeft;
                waiting.push_back(piece);
                waiting.push_back(added);
                continue;
            }
            const std::vector<Label> made = excess > 0 ? star(piece) : std::vector<Label>{piece};
            pieces.insert(pieces.end(), made.begin(), made.end());
        }
        for (const Label piece : pieces)
            finish(piece);
    }

    /// The cut that leaves the least concavity, if that is less than there is; the new cell or -1.
    Label cut(Label cell, double excess) {
        const std::array<Label, 1> one{cell};
        const std::vector<Label> region = withNeighbours(editor_, one);
        const std::vector<Cut> cuts =
            possibleCuts(editor_, cell, region, {options_.angle, true}, budget_);
        const Cut* best = nullptr;
        for (const Cut& candidate : cuts)
            if (candidate.excess < excess - leastGain &&
                (!best || costOf(candidate) < costOf(*best)))
                best = &candidate;
        if (!best) return -1;
        const Label oldPoints = toLabel(editor_.mesh().points.size());
        const Label added = cutCell(editor_, cell, best->loops);
        counts_.edgePoints += toLabel(editor_.mesh().points.size()) - oldPoints;
        ++counts_.cuts;
        return added;
    }

    /// What else is wrong counts as an edge of some degrees too many.
    static double costOf(const Cut& cut) {
        constexpr double failure = 0.5; // [rad]
        return cut.excess + failure * cut.after.failures + 0.1 * std::min(cut.after.severity, 10.0);
    }

    std::vector<Label> star(Label cell) {
        const auto apex = starPoint(editor_, cell);
        if (!apex) return {cell};
        std::vector<Label> pyramids = makePyramids(editor_, cell, *apex);
        if (pyramids.empty()) return {cell};
        ++counts_.cellPoints;
        return pyramids;
    }

    void finish(Label cell) {
        const auto faces = editor_.cell(cell).faces; // a copy: cutting changes the list
        for (const Label f : faces)
            counts_.splitFaces += splitConcaveFace(editor_, f, options_.angle) > 0;
        if (!isConvex(editor_, cell, options_.angle)) counts_.remaining.push_back(cell);
    }

    static constexpr double leastGain = 0.02; // [rad]

    MeshEditor& editor_;
    const DecompositionOptions& options_;
    WorkBudget& budget_;
    DecompositionCounts counts_;
};

void add(const DecompositionCounts& cell, DecompositionCounts& sum) {
    sum.concaveCells += cell.concaveCells;
    sum.cuts += cell.cuts;
    sum.edgePoints += cell.edgePoints;
    sum.cellPoints += cell.cellPoints;
    sum.splitFaces += cell.splitFaces;
    sum.remaining.insert(sum.remaining.end(), cell.remaining.begin(), cell.remaining.end());
}

} // namespace

std::vector<Label> concaveCells(const PolyMesh& mesh, double angle) {
    std::vector<Label> all(index(mesh.cellCount));
    for (std::size_t c = 0; c < all.size(); ++c)
        all[c] = toLabel(c);
    MeshPart part = partRound(mesh, all);
    MeshEditor editor(part.mesh);
    editor.computeGeometry(); // so that the loop only reads
    std::vector<std::uint8_t> concave(all.size(), 0);
    parallelFor(mesh.cellCount, [&](Label c) { concave[index(c)] = !isConvex(editor, c, angle); });
    std::vector<Label> cells;
    for (std::size_t c = 0; c < concave.size(); ++c)
        if (concave[c]) cells.push_back(toLabel(c));
    return cells;
}

DecompositionCounts decomposeCell(MeshEditor& editor,
                                  Label cell,
                                  const DecompositionOptions& options,
                                  WorkBudget& budget) {
    return Decomposer(editor, options, budget).decompose(cell);
}

DecompositionCounts decomposeCells(PolyMesh& mesh,
                                   std::span<const Label> cells,
                                   const DecompositionOptions& options,
                                   std::vector<Label>* origins) {
    MeshPart part = partRound(mesh, cells);
    DecompositionCounts counts;
    std::vector<Label> inPart;
    for (const Label c : cells) {
        const auto found = std::lower_bound(part.cells.begin(), part.cells.end(), c);
        inPart.push_back(static_cast<Label>(found - part.cells.begin()));
    }
    MeshEditor editor(part.mesh);
    for (const Label c : inPart) {
        constexpr std::int64_t tries = 4000; // some cuts for each of the parts
        WorkBudget budget(tries);
        budget.startCell(0);
        add(decomposeCell(editor, c, options, budget), counts);
        editor.commit();
    }
    JoinedPart joined = withPart(mesh, part);
    for (Label& c : counts.remaining)
        c = joined.cells[index(c)];
    std::sort(counts.remaining.begin(), counts.remaining.end());
    if (origins) *origins = std::move(joined.origins);
    mesh = std::move(joined.mesh);
    return counts;
}

} // namespace polymesh
