// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/repairCells.h"

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/collapseEdges.h"
#include "libpolymesh/quality/convexDecomposition.h"
#include "libpolymesh/quality/cutCell.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/mergeCells.h"
#include "libpolymesh/quality/polygons.h"
#include "libpolymesh/quality/splitConcaveCells.h"
#include "libpolymesh/quality/starPoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>

namespace polymesh {

namespace {

constexpr double concaveAngle = 0.1;         // [rad]
constexpr double longestCollapse = 0.5;      // of the size of the cell
constexpr double largestVolumeChange = 2e-3; // of the cube of the size of the cell

constexpr double largestMerged = 2.6; // volume of a merged cell, of the cube of its size

enum class Remedy : std::uint8_t { cut, merge, collapse, collapseAll, splitFace };

constexpr std::array<double, 3> shortLimits{
    0.03, 0.06, 0.12}; // for collapseAll, of the size of the cell

/// A change that might be made, and what it would do to the badness round it.
struct Proposal {
    Remedy remedy = Remedy::cut;
    Label from = -1; // cell or point
    Label to = -1;   // cell or point; for collapseAll which limit
    Label face = -1; // for splitFace: the face, and the cell for which it is split
    Label cell = -1;
    Label invalid = 0; // the changes: negative is good
    Label failures = 0;
    double severity = 0;
    CellCut loops = {}; // for cut
};

bool isGood(const Proposal& p) {
    if (p.invalid != 0) return p.invalid < 0;
    return p.failures < 0 || (p.failures == 0 && p.severity < -1e-3);
}

bool isBetterThan(const Proposal& a, const Proposal& b) {
    if (a.invalid != b.invalid) return a.invalid < b.invalid;
    return a.failures != b.failures ? a.failures < b.failures : a.severity < b.severity - 1e-9;
}

double volumeOf(MeshEditor& editor, std::span<const Label> cells) {
    double volume = 0;
    for (const Label c : cells)
        if (!editor.isFrozen(c) && !editor.cell(c).isRemoved())
            volume += editor.cellGeometry(c).volume;
    return volume;
}

/// The edges of a cell that are shorter than `limit`, the shortest first.
std::vector<std::pair<Label, Label>>
shortEdgesOf(const MeshEditor& editor, Label cell, double limit) {
    std::vector<EdgeUse> uses;
    collectEdgeUses(editor.mesh(), cell, uses);
    std::vector<std::pair<double, std::pair<Label, Label>>> edges;
    for (std::size_t i = 0; i + 1 < uses.size(); i += 2) {
        const double length = norm(editor.point(uses[i].low) - editor.point(uses[i].high));
        if (length < limit) edges.push_back({length, {uses[i].low, uses[i].high}});
    }
    std::sort(edges.begin(), edges.end());
    std::vector<std::pair<Label, Label>> sorted;
    sorted.reserve(edges.size());
    for (const auto& edge : edges)
        sorted.push_back(edge.second);
    return sorted;
}

/// Collapses all short edges of a cell that can be, whatever a single one does to the quality: the
/// two ends of a narrow strip have to go together. Returns the number of edges.
Label collapseAll(MeshEditor& editor, Label cell, double limit) {
    Label count = 0;
    for (const auto& [a, b] : shortEdgesOf(editor, cell, limit * editor.cell(cell).size))
        for (const auto& ends : {std::pair{a, b}, std::pair{b, a}}) {
            const Label from = ends.first;
            const Label to = ends.second;
            const auto faces = editor.facesOfPoint(from);
            const bool exists = std::any_of(faces.begin(), faces.end(), [&](Label f) {
                return hasEdge(editor.face(f).points, from, to);
            });
            if (!exists || !mayCollapse(editor, from, to)) continue;
            const MeshEditor::Mark mark = editor.mark();
            if (collapseEdge(editor, from, to)) {
                ++count;
                break;
            }
            editor.undoTo(mark);
        }
    return count;
}

/// Makes a part of a cell that is no cell by itself a part of one of its neighbours, not of
/// `other`.
bool givePartAway(MeshEditor& editor, Label part, Label other) {
    for (const MergePartner& partner : mergePartners(editor, part)) {
        if (partner.cell == other) continue;
        const MeshEditor::Mark mark = editor.mark();
        if (mergeCells(editor, part, partner.cell)) return true;
        editor.undoTo(mark);
    }
    return false;
}

/// Cuts a face of the cell from a to b. Where the cell has that edge already, it falls apart there:
/// a thin flap that hangs on the cell by an edge goes to the neighbour beyond it.
bool splitAtChord(MeshEditor& editor, const Proposal& chord) {
    const Label cell = chord.cell;
    const Label other = editor.otherCell(chord.face, cell);
    if (!splitFace(editor, chord.face, chord.from, chord.to)) return false;
    const std::array<Label, 2> both{cell, other < 0 ? cell : other};
    if (allBalls(editor, both)) return true;
    if (separateParts(editor, cell) != 1) return false;
    const std::array<Label, 2> parts{cell, editor.cellCount() - 1};
    for (const Label part : parts)
        if (editor.cell(part).faces.size() < 4 &&
            !givePartAway(editor, part, part == cell ? parts[1] : cell))
            return false;
    return allBalls(editor, parts) && allBalls(editor, both);
}

/// Looks for the best change round one cell.
class RepairSearch {
public:
    RepairSearch(MeshEditor& editor, Label cell, WorkBudget& budget)
        : editor_(editor), cell_(cell), budget_(budget) {}

    /// The best change; where none makes it better and it is allowed, one that passes the trouble
    /// on to the next cell.
    std::optional<Proposal> best(bool mayPassOn) {
        proposeCut(bestReflexCut(editor_, cell_, concaveAngle, budget_));
        for (const MergePartner& partner : mergePartners(editor_, cell_))
            proposeMerge(cell_, partner.cell);
        proposeCollapses();
        for (std::size_t i = 0; i < shortLimits.size(); ++i)
            proposeCollapseAll(toLabel(i));
        if (!best_) proposeCut(bestHalvingCut(editor_, cell_, budget_));
        if (!best_) proposeFaceSplits();
        return best_ || !mayPassOn ? best_ : fallback_;
    }

private:
    void consider(Proposal proposal, const Badness& before, const Badness& after) {
        proposal.invalid = after.invalid - before.invalid;
        proposal.failures = after.failures - before.failures;
        proposal.severity = after.severity - before.severity;
        if (isGood(proposal) && (!best_ || isBetterThan(proposal, *best_))) best_ = proposal;
        // A narrow strip may go on in the next cell: taking it away here moves the trouble there,
        // where the next step takes it away too. A cut may give the point back: the caller counts.
        const bool passesOn =
            proposal.invalid <= 0 && proposal.failures <= 0 && proposal.severity < 0.1;
        if (proposal.remedy == Remedy::collapseAll && passesOn && !fallback_) fallback_ = proposal;
    }

    bool isHuge(Label cell) {
        const double size = editor_.cell(cell).size;
        return editor_.cellGeometry(cell).volume > largestMerged * size * size * size;
    }

    void proposeCut(const std::optional<CellCut>& loops) {
        if (!loops) return;
        const std::array<Label, 1> one{cell_};
        std::vector<Label> region = withNeighbours(editor_, one);
        const Badness before = badnessOf(editor_, region);
        const MeshEditor::Mark mark = editor_.mark();
        const Label added = cutCell(editor_, cell_, *loops);
        if (added >= 0) {
            region.push_back(added);
            Proposal proposal{.remedy = Remedy::cut, .from = cell_};
            proposal.loops = *loops;
            consider(proposal, before, badnessOf(editor_, region));
        }
        editor_.undoTo(mark);
    }

    bool spend() { return budget_.spend(editor_.cell(cell_).faces.size()); }

    void proposeMerge(Label from, Label into) {
        const std::size_t faces = editor_.cell(from).faces.size() + editor_.cell(into).faces.size();
        if (!budget_.spend(faces)) return;
        const std::array<Label, 2> both{from, into};
        const std::vector<Label> region = withNeighbours(editor_, both);
        const Badness before = badnessOf(editor_, region);
        const MeshEditor::Mark mark = editor_.mark();
        if (mergeCells(editor_, from, into) && allBalls(editor_, region) && !isHuge(into))
            consider({Remedy::merge, from, into}, before, badnessOf(editor_, region));
        editor_.undoTo(mark);
    }

    /// Bent and concave faces: chords between any two corners.
    void proposeFaceSplits() {
        constexpr std::size_t maxCorners = 12;
        const std::array<Label, 1> one{cell_};
        const std::vector<Label> region = withNeighbours(editor_, one);
        const Badness before = badnessOf(editor_, region);
        const auto faces = editor_.cell(cell_).faces; // a copy: splitting changes the list
        for (const Label f : faces) {
            const Polygon polygon = editor_.face(f).points;
            if (polygon.size() > maxCorners || editor_.isFrozenFace(f)) continue;
            for (std::size_t i = 0; i < polygon.size(); ++i)
                for (std::size_t j = i + 2; j < polygon.size() - (i == 0); ++j)
                    proposeFaceSplit(
                        {Remedy::splitFace, polygon[i], polygon[j], f, cell_}, region, before);
        }
    }

    void proposeFaceSplit(const Proposal& proposal,
                          std::span<const Label> region,
                          const Badness& before) {
        if (!spend()) return;
        const MeshEditor::Mark mark = editor_.mark();
        const Label oldCells = editor_.cellCount();
        if (splitAtChord(editor_, proposal) && allBalls(editor_, region)) {
            std::vector<Label> all(region.begin(), region.end());
            if (editor_.cellCount() > oldCells) all.push_back(oldCells);
            consider(proposal, before, badnessOf(editor_, all));
        }
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
        if (!mayCollapse(editor_, from, to) || !spend()) return;
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

    void proposeCollapseAll(Label limit) {
        const double size = editor_.cell(cell_).size;
        std::vector<Label> region;
        for (const auto& [a, b] : shortEdgesOf(editor_, cell_, shortLimits[index(limit)] * size))
            for (const Label p : {a, b}) {
                const std::vector<Label> cells = cellsOfPoint(editor_, p);
                region.insert(region.end(), cells.begin(), cells.end());
            }
        if (region.empty() || !spend()) return;
        std::sort(region.begin(), region.end());
        region.erase(std::unique(region.begin(), region.end()), region.end());
        const Badness before = badnessOf(editor_, region);
        const double volume = volumeOf(editor_, region);
        const MeshEditor::Mark mark = editor_.mark();
        if (collapseAll(editor_, cell_, shortLimits[index(limit)]) > 0 &&
            allBalls(editor_, region) &&
            std::abs(volumeOf(editor_, region) - volume) < largestVolumeChange * size * size * size)
            consider({Remedy::collapseAll, cell_, limit}, before, badnessOf(editor_, region));
        editor_.undoTo(mark);
    }

    MeshEditor& editor_;
    Label cell_;
    WorkBudget& budget_;
    std::optional<Proposal> best_;
    std::optional<Proposal> fallback_;
};

/// Makes the change; the cells that should be looked at again are added to `touched`.
void apply(MeshEditor& editor,
           const Proposal& proposal,
           RepairCounts& counts,
           std::deque<Label>& touched) {
    std::vector<Label> cells;
    if (proposal.remedy == Remedy::cut) {
        const Label added = cutCell(editor, proposal.from, proposal.loops);
        cells = {proposal.from, added};
        ++counts.cuts;
    } else if (proposal.remedy == Remedy::merge) {
        mergeCells(editor, proposal.from, proposal.to);
        cells = {proposal.to};
        ++counts.merges;
    } else if (proposal.remedy == Remedy::splitFace) {
        cells = {proposal.cell};
        const Label oldCells = editor.cellCount();
        splitAtChord(editor, proposal);
        if (editor.cellCount() > oldCells) cells.push_back(oldCells);
        ++counts.splits;
    } else if (proposal.remedy == Remedy::collapseAll) {
        const std::array<Label, 1> one{proposal.from};
        cells = withNeighbours(editor, one);
        counts.collapses += collapseAll(editor, proposal.from, shortLimits[index(proposal.to)]);
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
        const std::optional<Proposal> proposal =
            RepairSearch(editor, c, budget).best(passesLeft > 0);
        if (!proposal) continue;
        const Label oldCells = editor.cellCount();
        const std::size_t known = queue.size();
        apply(editor, *proposal, counts, queue);
        cells.insert(cells.end(), queue.begin() + static_cast<std::ptrdiff_t>(known), queue.end());
        --changesLeft;
        passesLeft -= !isGood(*proposal);
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
    WorkBudget budget(40000 + std::int64_t{editor.cellCount()});
    mendFailingCells(editor, cells, budget, counts);
    remakeFailingCells(editor, cells, budget, counts);
    counts.left = stillFailing(editor, cells);
    return counts;
}

RepairCounts repairCells(EditMesh& mesh) {
    MeshEditor editor(mesh);
    return repairCells(editor);
}

} // namespace polymesh
