// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/repairSequence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace polymesh {

namespace {

constexpr int mostMoves = 5;
constexpr std::size_t beamWidth = 10; // states that are gone on from,
constexpr int mostOfAKind = 2;        // and those of them that end with the same kind of move
constexpr std::size_t cellsTried = 2; // failing cells of a state whose moves are tried
constexpr Label mostFailures = 8;     // more than before: not worth going on from

/// A sequence and the cells that fail after it.
struct State {
    RepairSequence sequence;
    std::vector<Label> failing;
};

Badness sum(const Badness& a, const Badness& b) {
    return {a.invalid + b.invalid, a.failures + b.failures, a.severity + b.severity};
}

void append(std::vector<RepairMove>&& more, std::vector<RepairMove>& moves) {
    for (RepairMove& move : more)
        moves.push_back(std::move(move));
}

/// Sequences with the same change are mostly the same moves in another order.
bool isSameState(const RepairSequence& a, const RepairSequence& b) {
    return a.change.invalid == b.change.invalid && a.change.failures == b.change.failures &&
           std::abs(a.change.severity - b.change.severity) < 1e-9;
}

/// Less severe failures are not worth a sequence.
bool helps(const Badness& change) {
    return change.invalid < 0 || (change.invalid == 0 && change.failures < 0);
}

class SequenceSearch {
public:
    SequenceSearch(MeshEditor& editor, WorkBudget& budget) : editor_(editor), budget_(budget) {}

    RepairSequence run(Label cell) {
        std::vector<State> beam{{{}, {cell}}};
        for (int depth = 0; depth < mostMoves && !beam.empty(); ++depth) {
            std::vector<RepairSequence> next;
            for (const State& state : beam)
                extend(state, next);
            if (helps(best_.change)) return best_;
            beam = bestStates(std::move(next));
        }
        return {};
    }

private:
    /// Adds the sequence with each further move; keeps the best one that helps.
    void extend(const State& state, std::vector<RepairSequence>& next) {
        const MeshEditor::Mark mark = editor_.mark();
        makeSequence(editor_, state.sequence);
        std::vector<RepairMove> moves;
        for (std::size_t i = 0; i < std::min(cellsTried, state.failing.size()); ++i) {
            append(plainMoves(editor_, state.failing[i], budget_), moves);
            append(moreMoves(editor_, state.failing[i], budget_), moves);
            append(furtherMoves(editor_, state.failing[i], budget_), moves);
        }
        editor_.undoTo(mark);
        for (RepairMove& move : moves) {
            RepairSequence longer{state.sequence.moves, sum(state.sequence.change, move.change)};
            if (longer.change.invalid > 0 || longer.change.failures > mostFailures) continue;
            longer.moves.push_back(std::move(move));
            if (helps(longer.change) && isBetterChange(longer.change, best_.change)) best_ = longer;
            next.push_back(std::move(longer));
        }
    }

    std::vector<State> bestStates(std::vector<RepairSequence>&& sequences) {
        std::stable_sort(
            sequences.begin(),
            sequences.end(),
            [](const RepairSequence& a, const RepairSequence& b) {
                return std::tie(a.change.invalid, a.change.failures, a.change.severity) <
                       std::tie(b.change.invalid, b.change.failures, b.change.severity);
            });
        std::vector<State> states;
        std::array<int, remedyCount> ofAKind{};
        for (RepairSequence& sequence : sequences) {
            if (states.size() == beamWidth) break;
            int& known = ofAKind[static_cast<std::size_t>(sequence.moves.back().remedy)];
            if (known == mostOfAKind) continue;
            if (!states.empty() && isSameState(states.back().sequence, sequence)) continue;
            std::vector<Label> failing = failingAfter(sequence);
            if (failing.empty()) continue;
            states.push_back({std::move(sequence), std::move(failing)});
            ++known;
        }
        return states;
    }

    /// The cells near what has changed that fail; none when the moves cannot be made.
    std::vector<Label> failingAfter(const RepairSequence& sequence) {
        const MeshEditor::Mark mark = editor_.mark();
        bool complete = true;
        std::vector<Label> cells = makeSequence(editor_, sequence, &complete);
        cells = withNeighbours(editor_, cells);
        std::erase_if(cells, [&](Label c) { return !isFailing(editor_, c); });
        editor_.undoTo(mark);
        if (!complete) cells.clear();
        return cells;
    }

    MeshEditor& editor_;
    WorkBudget& budget_;
    RepairSequence best_;
};

} // namespace

std::vector<Label>
makeSequence(MeshEditor& editor, const RepairSequence& sequence, bool* complete) {
    std::vector<Label> cells;
    for (const RepairMove& move : sequence.moves) {
        const auto changed = makeMove(editor, move);
        if (!changed && complete != nullptr) *complete = false;
        if (!changed) break;
        cells.insert(cells.end(), changed->begin(), changed->end());
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    std::erase_if(cells, [&](Label c) { return editor.cell(c).isRemoved() || editor.isFrozen(c); });
    return cells;
}

RepairSequence findSequence(MeshEditor& editor, Label cell, WorkBudget& budget) {
    return SequenceSearch(editor, budget).run(cell);
}

} // namespace polymesh
