// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/repairCells.h"

#include "libpolymesh/quality/convexDecomposition.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/repairMoves.h"
#include "libpolymesh/quality/repairSequence.h"
#include "libpolymesh/quality/starPoint.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>

namespace polymesh {

namespace {

constexpr double concaveAngle = 0.1; // [rad]

void countMove(Remedy remedy, RepairCounts& counts) {
    switch (remedy) {
    case Remedy::cut:
        ++counts.cuts;
        break;
    case Remedy::merge:
        ++counts.merges;
        break;
    case Remedy::splitFace:
    case Remedy::detach:
        ++counts.splits;
        break;
    default:
        ++counts.collapses;
    }
}

/// Of the moves that make things better the best; nullptr if there is none.
const RepairMove* bestOf(const std::vector<RepairMove>& moves) {
    const RepairMove* best = nullptr;
    for (const RepairMove& move : moves)
        if (isGood(move.change) && (!best || isBetterChange(move.change, best->change)))
            best = &move;
    return best;
}

/// A narrow strip may go on in the next cell: taking it away here moves the trouble there, where
/// the next step takes it away too. A cut may give the point back: the caller counts.
bool passesOn(const RepairMove& move) {
    return move.remedy == Remedy::collapseAll && move.change.invalid <= 0 &&
           move.change.failures <= 0 && move.change.severity < 0.1;
}

/// The best change of a cell; where none makes it better and it is allowed, one that passes the
/// trouble on to the next cell.
std::optional<RepairMove>
bestMove(MeshEditor& editor, Label cell, WorkBudget& budget, bool mayPassOn) {
    const std::vector<RepairMove> plain = plainMoves(editor, cell, budget);
    if (const RepairMove* best = bestOf(plain)) return *best;
    const std::vector<RepairMove> further = furtherMoves(editor, cell, budget);
    if (const RepairMove* best = bestOf(further)) return *best;
    const auto passing = std::find_if(plain.begin(), plain.end(), passesOn);
    if (mayPassOn && passing != plain.end()) return *passing;
    return std::nullopt;
}

/// Notes the cells round changed ones, as those whose quality may have changed, and queues those of
/// them that fail. Others would count as waiting, and each cell's share of the work goes by these.
void lookAgain(MeshEditor& editor,
               std::span<const Label> changed,
               std::vector<Label>& noted,
               std::deque<Label>& queue) {
    for (const Label c : withNeighbours(editor, changed)) {
        noted.push_back(c);
        if (isFailing(editor, c)) queue.push_back(c);
    }
}

/// Makes the best changes one after the other.
/// `cells` are those that fail; all whose quality may have changed are added.
void mendFailingCells(MeshEditor& editor,
                      std::vector<Label>& cells,
                      WorkBudget& budget,
                      RepairCounts& counts) {
    constexpr int maxVisits =
        8; // a cell that takes more is going round in circles with its neighbours
    std::deque<Label> queue(cells.begin(), cells.end());
    counts.bad = toLabel(queue.size());
    // Each step lowers, in this order: the passes left, what is invalid, the failures, the severity
    // by a least amount. The changes left keep the number of steps in proportion.
    std::int64_t passesLeft = std::int64_t{8} * counts.bad;
    std::int64_t changesLeft = std::int64_t{50} * counts.bad;
    std::map<Label, int> visits;
    while (!queue.empty() && changesLeft > 0 && !budget.isSpent()) {
        const Label c = queue.front();
        queue.pop_front();
        if (editor.cell(c).isRemoved() || !isFailing(editor, c) || ++visits[c] > maxVisits)
            continue;
        budget.startCell(queue.size());
        const std::optional<RepairMove> proposal = bestMove(editor, c, budget, passesLeft > 0);
        if (!proposal) continue;
        const Label oldCells = editor.cellCount();
        const auto changed = makeMove(editor, *proposal);
        editor.commit();
        countMove(proposal->remedy, counts);
        if (!changed) continue; // never: it has been tried
        lookAgain(editor, *changed, cells, queue);
        --changesLeft;
        passesLeft -= !isGood(proposal->change);
        const int soFar = visits[c]; // what c is or becomes a part of has been visited as often
        for (Label part = oldCells; part < editor.cellCount(); ++part)
            visits[part] = soFar;
        if (proposal->remedy == Remedy::merge)
            visits[proposal->to] = std::max(visits[proposal->to], soFar);
    }
}

/// Those of the cells that fail, once each, in order.
std::vector<Label> stillFailing(MeshEditor& editor, std::vector<Label> cells) {
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    std::erase_if(cells, [&](Label c) {
        return editor.cell(c).isRemoved() || editor.isFrozen(c) || !isFailing(editor, c);
    });
    return cells;
}

/// A sequence is worth a thousand tries. Where hundreds of cells fail, the mesh is too coarse for
/// its surface: to mend some of them would help nobody.
std::int64_t workForSequences(std::int64_t work, std::size_t failing) {
    constexpr std::size_t manyFail = 200;
    return failing > manyFail ? work / 4 : work;
}

/// Cells that no single move has mended: moves that help together.
/// Cells whose quality may have changed are added.
void mendBySequences(MeshEditor& editor,
                     std::vector<Label>& cells,
                     WorkBudget& budget,
                     RepairCounts& counts) {
    constexpr int maxVisits = 4;
    const std::vector<Label> failing = stillFailing(editor, cells);
    std::deque<Label> queue(failing.begin(), failing.end());
    std::map<Label, int> visits;
    while (!queue.empty() && !budget.isSpent()) {
        const Label c = queue.front();
        queue.pop_front();
        if (editor.cell(c).isRemoved() || !isFailing(editor, c) || ++visits[c] > maxVisits)
            continue;
        budget.startCell(queue.size());
        const RepairSequence sequence = findSequence(editor, c, budget);
        const Label oldCells = editor.cellCount();
        const std::vector<Label> changed = makeSequence(editor, sequence);
        editor.commit();
        for (const RepairMove& move : sequence.moves)
            countMove(move.remedy, counts);
        for (Label part = oldCells; part < editor.cellCount(); ++part)
            visits[part] = visits[c]; // a part of what has been visited as often
        lookAgain(editor, changed, cells, queue);
    }
}

/// Makes a cell into many by `remake` if that leaves the cells round it better.
template<class Remake>
bool remakeCell(MeshEditor& editor, Label cell, Remake&& remake) {
    const std::array<Label, 1> one{cell};
    std::vector<Label> region = withNeighbours(editor, one);
    const Badness before = badnessOf(editor, region);
    const MeshEditor::Mark mark = editor.mark();
    const Label oldCells = editor.cellCount();
    remake();
    for (Label c = oldCells; c < editor.cellCount(); ++c)
        region.push_back(c);
    if (isBetter(badnessOf(editor, region), before)) return true;
    editor.undoTo(mark);
    return false;
}

/// Makes cells that still fail into convex ones, or into pyramids on their faces.
/// Cells whose quality may have changed are added.
void remakeFailingCells(MeshEditor& editor,
                        std::vector<Label>& cells,
                        WorkBudget& budget,
                        RepairCounts& counts) {
    const std::vector<Label> failing = stillFailing(editor, cells);
    for (std::size_t i = 0; i < failing.size() && !budget.isSpent(); ++i) {
        const Label c = failing[i];
        if (!isFailing(editor, c)) continue;
        budget.startCell(failing.size() - i);
        const auto makeConvex = [&] { decomposeCell(editor, c, {concaveAngle, 20}, budget); };
        const auto makePyramidsOfIt = [&] {
            const auto apex = starPoint(editor, c);
            if (apex) makePyramids(editor, c, *apex);
        };
        const Label oldCells = editor.cellCount();
        const bool remade =
            remakeCell(editor, c, makeConvex) || (budget.spend(4 * editor.cell(c).faces.size()) &&
                                                  remakeCell(editor, c, makePyramidsOfIt));
        editor.commit();
        if (!remade) continue;
        ++counts.remakes;
        std::vector<Label> parts{c};
        for (Label part = oldCells; part < editor.cellCount(); ++part)
            parts.push_back(part);
        const std::vector<Label> round = withNeighbours(editor, parts);
        cells.insert(cells.end(), round.begin(), round.end());
    }
}

} // namespace

RepairCounts repairCells(MeshEditor& editor) {
    RepairCounts counts;
    std::vector<Label> cells = failingCells(editor);
    const std::int64_t cellCount = editor.cellCount();
    WorkBudget budget(std::min(5000 + 20 * cellCount, 40000 + cellCount));
    mendFailingCells(editor, cells, budget, counts);
    counts.work = budget.used();
    counts.left = stillFailing(editor, std::move(cells));
    return counts;
}

RepairCounts repairThoroughly(MeshEditor& editor, std::vector<Label> cells, std::int64_t work) {
    RepairCounts counts;
    cells = stillFailing(editor, std::move(cells));
    counts.bad = toLabel(cells.size());
    WorkBudget sequences(workForSequences(work, cells.size()));
    WorkBudget remakes(work);
    mendBySequences(editor, cells, sequences, counts);
    remakeFailingCells(editor, cells, remakes, counts);
    if (counts.remakes > 0) mendBySequences(editor, cells, sequences, counts);
    counts.work = sequences.used() + remakes.used();
    counts.left = stillFailing(editor, std::move(cells));
    return counts;
}

} // namespace polymesh
