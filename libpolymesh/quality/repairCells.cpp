// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/repairCells.h"

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/collapseEdges.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/mergeCells.h"
#include "libpolymesh/quality/splitConcaveCells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <optional>

namespace polymesh {

namespace {

constexpr double concaveAngle = 0.1;         // [rad]
constexpr std::size_t maxFaces = 64;         // of a cell that is worth the effort
constexpr double longestCollapse = 0.5;      // of the size of the cell
constexpr double largestVolumeChange = 2e-3; // of the cube of the size of the cell

enum class Remedy : std::uint8_t { cut, merge, collapse };

/// A change that might be made, and what it would do to the badness round it.
struct Proposal {
    Remedy remedy = Remedy::cut;
    Label from = -1; // cell or point
    Label to = -1;
    Label failures = 0; // the change: negative is good
    double severity = 0;
};

bool isGood(const Proposal& p) {
    return p.failures < 0 || (p.failures == 0 && p.severity < -1e-3);
}

bool isBetterThan(const Proposal& a, const Proposal& b) {
    return a.failures != b.failures ? a.failures < b.failures : a.severity < b.severity - 1e-9;
}

bool isBad(MeshEditor& editor, Label cell) {
    const std::array<Label, 1> one{cell};
    return badnessOf(editor, one).failures > 0;
}

double volumeOf(MeshEditor& editor, std::span<const Label> cells) {
    double volume = 0;
    for (const Label c : cells)
        if (!editor.isFrozen(c) && !editor.cell(c).isRemoved())
            volume += editor.cellGeometry(c).volume;
    return volume;
}

/// Looks for the best change round one cell.
class RepairSearch {
public:
    RepairSearch(MeshEditor& editor, Label cell) : editor_(editor), cell_(cell) {}

    std::optional<Proposal> best() {
        proposeCut();
        for (const MergePartner& partner : mergePartners(editor_, cell_))
            if (editor_.cell(partner.cell).faces.size() <= maxFaces)
                proposeMerge(cell_, partner.cell);
        proposeCollapses();
        return best_;
    }

private:
    void consider(Proposal proposal, const Badness& before, const Badness& after) {
        proposal.failures = after.failures - before.failures;
        proposal.severity = after.severity - before.severity;
        if (isGood(proposal) && (!best_ || isBetterThan(proposal, *best_))) best_ = proposal;
    }

    void proposeCut() {
        const std::array<Label, 1> one{cell_};
        std::vector<Label> region = withNeighbours(editor_, one);
        const Badness before = badnessOf(editor_, region);
        const MeshEditor::Mark mark = editor_.mark();
        const Label added = cutAtReflexEdge(editor_, cell_, concaveAngle);
        if (added >= 0) {
            region.push_back(added);
            consider({Remedy::cut, cell_, -1}, before, badnessOf(editor_, region));
        }
        editor_.undoTo(mark);
    }

    void proposeMerge(Label from, Label into) {
        const std::array<Label, 2> both{from, into};
        const std::vector<Label> region = withNeighbours(editor_, both);
        const Badness before = badnessOf(editor_, region);
        const MeshEditor::Mark mark = editor_.mark();
        if (mergeCells(editor_, from, into) && allBalls(editor_, region))
            consider({Remedy::merge, from, into}, before, badnessOf(editor_, region));
        editor_.undoTo(mark);
    }

    void proposeCollapses() {
        std::vector<EdgeUse> uses;
        collectEdgeUses(editor_.mesh(), cell_, uses);
        const double size = editor_.cell(cell_).size;
        for (std::size_t i = 0; i + 1 < uses.size(); i += 2) {
            const Label low = uses[i].low;
            const Label high = uses[i].high;
            if (norm(editor_.point(low) - editor_.point(high)) > longestCollapse * size) continue;
            proposeCollapse(low, high);
            proposeCollapse(high, low);
        }
    }

    void proposeCollapse(Label from, Label to) {
        if (!mayCollapse(editor_, from, to)) return;
        const std::vector<Label> region = cellsOfPoint(editor_, from);
        const Badness before = badnessOf(editor_, region);
        const double volume = volumeOf(editor_, region);
        const double size = editor_.cell(cell_).size;
        const MeshEditor::Mark mark = editor_.mark();
        if (collapseEdge(editor_, from, to) &&
            std::abs(volumeOf(editor_, region) - volume) < largestVolumeChange * size * size * size)
            consider({Remedy::collapse, from, to}, before, badnessOf(editor_, region));
        editor_.undoTo(mark);
    }

    MeshEditor& editor_;
    Label cell_;
    std::optional<Proposal> best_;
};

/// Makes the change; the cells that should be looked at again are added to `touched`.
void apply(MeshEditor& editor,
           const Proposal& proposal,
           RepairCounts& counts,
           std::deque<Label>& touched) {
    std::vector<Label> cells;
    if (proposal.remedy == Remedy::cut) {
        const Label added = cutAtReflexEdge(editor, proposal.from, concaveAngle);
        cells = {proposal.from, added};
        ++counts.cuts;
    } else if (proposal.remedy == Remedy::merge) {
        mergeCells(editor, proposal.from, proposal.to);
        cells = {proposal.to};
        ++counts.merges;
    } else {
        cells = cellsOfPoint(editor, proposal.from);
        collapseEdge(editor, proposal.from, proposal.to);
        ++counts.collapses;
    }
    editor.commit();
    std::erase_if(cells, [&](Label c) { return editor.cell(c).isRemoved() || editor.isFrozen(c); });
    const std::vector<Label> all = withNeighbours(editor, cells);
    touched.insert(touched.end(), all.begin(), all.end());
}

} // namespace

RepairCounts repairCells(MeshEditor& editor) {
    constexpr int maxVisits =
        8; // a cell that takes more is going round in circles with its neighbours
    editor.computeGeometry();
    RepairCounts counts;
    std::deque<Label> queue;
    for (Label c = 0; c < editor.cellCount(); ++c)
        if (!editor.cell(c).isRemoved() && !editor.isFrozen(c) && isBad(editor, c))
            queue.push_back(c);
    counts.bad = toLabel(queue.size());
    std::map<Label, int> visits;
    while (!queue.empty()) {
        const Label c = queue.front();
        queue.pop_front();
        if (editor.cell(c).isRemoved() || !isBad(editor, c) || ++visits[c] > maxVisits) continue;
        if (editor.cell(c).faces.size() > maxFaces) continue;
        const std::optional<Proposal> proposal = RepairSearch(editor, c).best();
        if (proposal) apply(editor, *proposal, counts, queue);
    }
    for (const auto& [c, count] : visits)
        counts.left += !editor.cell(c).isRemoved() && isBad(editor, c);
    return counts;
}

RepairCounts repairCells(EditMesh& mesh) {
    MeshEditor editor(mesh);
    return repairCells(editor);
}

} // namespace polymesh
