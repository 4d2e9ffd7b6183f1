// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/splitConcaveCells.h"

#include "libpolymesh/quality/cutCell.h"
#include "libpolymesh/quality/editQuality.h"

#include <array>
#include <cstdint>
#include <deque>
#include <optional>

namespace polymesh {

namespace {

/// The cut that leaves the least badness, if that is less than `before`.
std::optional<CellCut> bestCut(const std::vector<Cut>& cuts, const Badness& before) {
    const Cut* best = nullptr;
    for (const Cut& cut : cuts)
        if (isBetter(cut.after, best ? best->after : before)) best = &cut;
    return best ? std::optional(best->loops) : std::nullopt;
}

/// The cut that leaves the least concavity, weighing failures as much as an edge of 90 degrees too
/// many, if that is clearly less than there is: a step on the way to convex pieces.
const Cut* straightestCut(const std::vector<Cut>& cuts, double excess) {
    constexpr double rightAngle = 1.57;
    constexpr double leastGain = 0.2; // [rad]
    const Cut* best = nullptr;
    const auto measure = [&](const Cut& cut) {
        return cut.excess + rightAngle * cut.after.failures;
    };
    for (const Cut& cut : cuts)
        if (cut.excess < excess - leastGain && (!best || measure(cut) < measure(*best)))
            best = &cut;
    return best;
}

} // namespace

std::optional<CellCut>
bestReflexCut(MeshEditor& editor, Label cell, double tolerance, WorkBudget& budget) {
    const std::array<Label, 1> one{cell};
    const std::vector<Label> region = withNeighbours(editor, one);
    const Badness before = badnessOf(editor, region);
    return bestCut(possibleCuts(editor, cell, region, {tolerance, false}, budget), before);
}

std::optional<CellCut> bestHalvingCut(MeshEditor& editor, Label cell, WorkBudget& budget) {
    const std::array<Label, 1> one{cell};
    const std::vector<Label> region = withNeighbours(editor, one);
    const Badness before = badnessOf(editor, region);
    return bestCut(halvingCuts(editor, cell, region, budget), before);
}

Label cutInSteps(MeshEditor& editor, Label cell, double tolerance, WorkBudget& budget) {
    constexpr Label maxCuts = 12;
    const std::array<Label, 1> one{cell};
    std::vector<Label> region = withNeighbours(editor, one);
    const Badness before = badnessOf(editor, region);
    const MeshEditor::Mark mark = editor.mark();
    std::deque<Label> pieces{cell};
    Label count = 0;
    while (!pieces.empty() && count < maxCuts) {
        const Label piece = pieces.front();
        pieces.pop_front();
        if (!isFailing(editor, piece)) continue;
        const std::vector<Cut> cuts =
            possibleCuts(editor, piece, region, {tolerance, true}, budget);
        const Cut* cut = straightestCut(cuts, totalExcess(editor, piece, tolerance));
        if (!cut) continue;
        const Label added = cutCell(editor, piece, cut->loops);
        region.push_back(added);
        pieces.push_back(piece);
        pieces.push_back(added);
        ++count;
    }
    if (count > 0 && isBetter(badnessOf(editor, region), before)) return count;
    editor.undoTo(mark);
    return 0;
}

SplitCounts splitConcaveCells(MeshEditor& editor, double tolerance) {
    SplitCounts counts;
    std::deque<Label> queue;
    for (const Label c : failingCells(editor))
        if (!reflexEdges(editor, c, tolerance).empty()) queue.push_back(c);
    counts.concave = toLabel(queue.size());
    WorkBudget budget(20000 + 2 * std::int64_t{editor.cellCount()});
    std::int64_t cutsLeft = std::int64_t{50} * counts.concave;
    while (!queue.empty()) {
        const Label c = queue.front();
        queue.pop_front();
        if (!isFailing(editor, c)) continue;
        if (cutsLeft <= 0 || budget.isSpent()) {
            ++counts.left;
            continue;
        }
        budget.startCell(queue.size());
        const std::optional<CellCut> loops = bestReflexCut(editor, c, tolerance, budget);
        const Label added = loops ? cutCell(editor, c, *loops) : -1;
        if (added >= 0) {
            ++counts.cuts;
            --cutsLeft;
            queue.push_back(c);
            queue.push_back(added);
        } else {
            const Label cuts = cutInSteps(editor, c, tolerance, budget);
            counts.cuts += cuts;
            cutsLeft -= cuts;
            counts.left += isFailing(editor, c);
        }
        editor.commit();
    }
    return counts;
}

} // namespace polymesh
