// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/mendPieces.h"

#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/repairMoves.h"
#include "libpolymesh/shapeSplit/editedShape.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace polymesh {

namespace {

/// A change that can be made, and what it does to the badness round it.
struct Proposal {
    std::function<bool()> make;
    Badness gain; // negative is good
};

std::optional<Proposal> bestOf(const std::vector<Proposal>& proposals) {
    std::optional<Proposal> best;
    for (const Proposal& p : proposals)
        if (isGood(p.gain) && (!best || isBetterChange(p.gain, best->gain))) best = p;
    return best;
}

bool isWorthwhile(const Badness& gain) {
    return isGood(gain) && gain.failures < 0;
}

/// Finds and makes the best change of one cell after the other.
class Mender {
public:
    Mender(MeshEditor& editor, const MendMeans& means) : editor_(editor), means_(means) {}

    Label mend() {
        constexpr int maxVisits = 12;
        std::deque<Label> waiting;
        for (const Label c : failingCells(editor_))
            waiting.push_back(c);
        std::map<Label, int> visits;
        Label changes = 0;
        while (!waiting.empty()) {
            const Label c = waiting.front();
            waiting.pop_front();
            if (!isToBeMended(c) || ++visits[c] > maxVisits) continue;
            const std::vector<Label> changed = mend(c);
            if (changed.empty()) continue;
            ++changes;
            waiting.insert(waiting.end(), changed.begin(), changed.end());
        }
        return changes;
    }

private:
    bool isToBeMended(Label c) {
        return !editor_.cell(c).isRemoved() && !editor_.isFrozen(c) &&
               !std::ranges::binary_search(means_.tolerated, c) && isFailing(editor_, c) &&
               isAcceptable(editor_, c);
    }

    /// Makes a change for the better. Returns the cells that are to be looked at again; none when
    /// there is no such change.
    std::vector<Label> mend(Label cell) {
        const MeshEditor::Mark mark = editor_.mark();
        const std::vector<Proposal> changes = judged(changesOfPiece(editor_, means_, cell));
        if (!makeBest(changes, cell) && !makeSeveral(changes, cell)) return {};
        std::vector<Label> round = changedSince(mark);
        editor_.commit();
        return round;
    }

    /// The cells that have changed and their neighbours.
    std::vector<Label> changedSince(const MeshEditor::Mark& mark) const {
        return withNeighbours(editor_, editedOf(editor_.reshapedSince(mark)));
    }

    std::vector<Label> editedOf(std::vector<Label> cells) const {
        std::erase_if(cells, [&](Label c) { return editor_.isFrozen(c); });
        return cells;
    }

    bool makeBest(const std::vector<Proposal>& changes, Label cell) {
        const auto best = bestWithMoves(changes, cell);
        return best && best->make();
    }

    std::optional<Proposal> bestWithMoves(std::vector<Proposal> changes, Label cell) {
        std::vector<Proposal> moves = judged(movesOfPiece(editor_, means_, cell));
        changes.insert(changes.end(), moves.begin(), moves.end());
        return bestOf(changes);
    }

    /// The changes that can be made and leave sound cells of acceptable shapes.
    std::vector<Proposal> judged(const std::vector<PieceChange>& changes) {
        std::vector<Proposal> proposals;
        for (const PieceChange& change : changes)
            if (const auto gain = gainOf(change)) proposals.push_back({change.make, *gain});
        return proposals;
    }

    std::optional<Badness> gainOf(const PieceChange& change) {
        ++tries_;
        const MeshEditor::Mark mark = editor_.mark();
        const Label oldCells = editor_.cellCount();
        std::vector<Label> cells = change.cells;
        std::optional<Badness> after;
        if (change.make()) {
            const std::vector<Label> region = editedOf(editor_.reshapedSince(mark));
            const auto accepted = [&](Label c) { return isAcceptable(editor_, c); };
            if (std::ranges::all_of(region, accepted) && areSound(editor_, mark))
                after = badnessOf(editor_, region);
            std::ranges::copy_if(
                region, std::back_inserter(cells), [&](Label c) { return c < oldCells; });
        }
        editor_.undoTo(mark);
        if (!after) return std::nullopt;
        std::ranges::sort(cells);
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        const Badness before = badnessOf(editor_, cells);
        return Badness{after->invalid - before.invalid,
                       after->failures - before.failures,
                       after->severity - before.severity};
    }

    /// Makes changes that are costly, or help only together. Sought once for a cell, and not for
    /// ever: where very many cells are hard, the mesh is too coarse for what it shows.
    bool makeSeveral(const std::vector<Proposal>& changes, Label cell) {
        constexpr std::int64_t mostTries = 100'000; // some seconds
        if (tries_ > mostTries || !hasBeenHard_.insert(cell).second) return false;
        std::vector<Proposal> wide = judgedWide(wideChanges(editor_, means_, cell));
        if (const auto best = bestOf(wide)) return best->make();
        wide.insert(wide.end(), changes.begin(), changes.end());
        if (makeSequence(wide)) return true;
        const auto best = bestOf(judgedWide(widestChanges(editor_, means_, cell)));
        return best && best->make();
    }

    std::vector<Proposal> judgedWide(const std::vector<PieceChange>& changes) {
        constexpr std::int64_t cost = 20; // a wide change takes as long as so many others
        tries_ += cost * toLabel(changes.size());
        return judged(changes);
    }

    /// Makes a change that does not help, and what mends the cells round it then.
    bool makeSequence(const std::vector<Proposal>& first) {
        constexpr int most = 4; // further changes
        constexpr std::int64_t mostTries = 4000;
        const MeshEditor::Mark mark = editor_.mark();
        const std::int64_t end = tries_ + mostTries;
        for (const Proposal& proposal : first) {
            if (tries_ > end) break;
            proposal.make();
            Badness gain = proposal.gain;
            for (int i = 0; i < most && !isWorthwhile(gain); ++i) {
                const auto next = bestSince(mark);
                if (!next) break;
                next->make();
                gain.invalid += next->gain.invalid;
                gain.failures += next->gain.failures;
                gain.severity += next->gain.severity;
            }
            if (isWorthwhile(gain)) return true;
            editor_.undoTo(mark);
        }
        return false;
    }

    /// The best change of a failing cell where something has changed since the mark.
    std::optional<Proposal> bestSince(const MeshEditor::Mark& mark) {
        std::vector<Proposal> found;
        for (const Label c : changedSince(mark))
            if (isToBeMended(c))
                if (auto next = bestWithMoves(judged(changesOfPiece(editor_, means_, c)), c))
                    found.push_back(std::move(*next));
        return bestOf(found);
    }

    MeshEditor& editor_;
    const MendMeans& means_;
    std::set<Label> hasBeenHard_; // cells for which several changes have been sought
    std::int64_t tries_ = 0;      // changes judged, by their cost
};

} // namespace

Label mendPieces(MeshEditor& editor, const MendMeans& means) {
    return Mender(editor, means).mend();
}

} // namespace polymesh
