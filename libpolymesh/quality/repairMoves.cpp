// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/repairMoves.h"

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/collapseEdges.h"
#include "libpolymesh/quality/cutCell.h"
#include "libpolymesh/quality/mergeCells.h"
#include "libpolymesh/quality/mergeFaces.h"
#include "libpolymesh/quality/movePoint.h"
#include "libpolymesh/quality/polygons.h"
#include "libpolymesh/quality/possibleCuts.h"
#include "libpolymesh/quality/splitConcaveCells.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polymesh {

namespace {

constexpr double concaveAngle = 0.1;         // [rad]
constexpr double longestCollapse = 0.5;      // of the size of the cell
constexpr double largestVolumeChange = 2e-3; // of the cube of the size of the cell
constexpr double largestMerged = 2.6;        // volume of a merged cell, of the cube of its size
constexpr double thin = 0.06; // of the size of the cell: a point nearer to an edge may go into it

constexpr std::array<double, 3> shortLimits{
    0.03, 0.06, 0.12}; // for collapseAll, of the size of the cell
constexpr std::array<double, 3> turnLimits{0.01, 0.06, 0.25}; // for unite [rad]

double volumeOf(MeshEditor& editor, std::span<const Label> cells) {
    double volume = 0;
    for (const Label c : cells)
        if (!editor.isFrozen(c) && !editor.cell(c).isRemoved())
            volume += editor.cellGeometry(c).volume;
    return volume;
}

void sortUnique(std::vector<Label>& labels) {
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
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

/// Makes one of two faces of a cell, and takes both back when that leaves no balls.
bool uniteSoundly(MeshEditor& editor, Label f, Label g, Label cell) {
    const Label other = editor.otherCell(f, cell);
    const std::array<Label, 2> cells{cell, other < 0 ? cell : other};
    const Polygon ends = editor.face(g).points;
    const MeshEditor::Mark mark = editor.mark();
    if (uniteFaces(editor, f, g, cell)) {
        for (const Label p : ends)
            dropRedundantPoint(editor, p);
        if (allBalls(editor, cells)) return true;
    }
    editor.undoTo(mark);
    return false;
}

/// Whether the faces meet at a feature edge: faces that turn are not united there.
bool meetAtFeature(MeshEditor& editor, Label f, Label g) {
    const auto isFeature = [&](Label p) { return editor.rank(p) >= PointRank::feature; };
    const Polygon& polygon = editor.face(f).points;
    Label a = polygon.back();
    for (const Label b : polygon) {
        if (isFeature(a) && isFeature(b) && hasEdge(editor.face(g).points, a, b)) return true;
        a = b;
    }
    return false;
}

/// Unites faces of a cell on one patch, or against one other cell, that turn by at most `angle`
/// [rad]. Returns the number of faces that went.
Label uniteAll(MeshEditor& editor, Label cell, double angle) {
    constexpr double sameAtFeatures = 0.02; // [rad]
    Label count = 0;
    const auto& faces = editor.cell(cell).faces;
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = 0; j < faces.size(); ++j) {
            const Label f = faces[i];
            const Label g = faces[j];
            if (i == j || !isSameInterface(editor, f, g, cell) ||
                !isCoplanar(editor, f, g, cell, angle) ||
                unitedPolygon(editor.face(f).points, editor.face(g).points).empty())
                continue;
            if (angle > sameAtFeatures && meetAtFeature(editor, f, g)) continue;
            if (!uniteSoundly(editor, f, g, cell)) continue;
            ++count;
            i = 0; // the list has changed
            j = 0;
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
bool splitAtChord(MeshEditor& editor, const RepairMove& chord) {
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

/// The cells whose shape a move changes, before it is made.
std::vector<Label> cellsChangedBy(const MeshEditor& editor, const RepairMove& move) {
    std::vector<Label> cells;
    const auto addCellsOf = [&](Label p) {
        const std::vector<Label> round = cellsOfPoint(editor, p);
        cells.insert(cells.end(), round.begin(), round.end());
    };
    switch (move.remedy) {
    case Remedy::cut:
    case Remedy::unite:
        cells = {move.from};
        break;
    case Remedy::merge:
        cells = {move.from, move.to};
        break;
    case Remedy::splitFace:
    case Remedy::detach:
        cells = {move.cell};
        break;
    case Remedy::collapseAll: {
        const double limit = shortLimits[index(move.to)] * editor.cell(move.from).size;
        for (const auto& [a, b] : shortEdgesOf(editor, move.from, limit))
            for (const Label p : {a, b})
                addCellsOf(p);
        break;
    }
    case Remedy::collapse:
    case Remedy::slide:
        addCellsOf(move.from);
        break;
    case Remedy::pinch:
        for (const Label p : {move.from, move.to, move.end})
            addCellsOf(p);
        break;
    }
    sortUnique(cells);
    return cells;
}

bool change(MeshEditor& editor, const RepairMove& move) {
    switch (move.remedy) {
    case Remedy::cut:
        return cutCell(editor, move.from, move.loops) >= 0;
    case Remedy::merge:
        return mergeCells(editor, move.from, move.to);
    case Remedy::splitFace:
    case Remedy::detach:
        return splitAtChord(editor, move);
    case Remedy::collapseAll:
        return collapseAll(editor, move.from, shortLimits[index(move.to)]) > 0;
    case Remedy::collapse:
        return collapseEdge(editor, move.from, move.to);
    case Remedy::unite:
        return uniteAll(editor, move.from, turnLimits[index(move.to)]) > 0;
    case Remedy::slide:
        movePoint(editor, move.from, move.position, editor.rank(move.from));
        return true;
    case Remedy::pinch:
        return pinchIntoEdge(editor, move.from, move.to, move.end);
    }
    return false;
}

/// Whether the boundary may move by it.
bool movesPoints(Remedy remedy) {
    return remedy != Remedy::cut && remedy != Remedy::merge && remedy != Remedy::splitFace &&
           remedy != Remedy::detach;
}

/// The cells that are judged before and after a move: with all that share a face with what changes.
bool needsNeighbours(Remedy remedy) {
    return remedy != Remedy::collapse && remedy != Remedy::collapseAll && remedy != Remedy::slide;
}

Badness difference(const Badness& after, const Badness& before) {
    return {after.invalid - before.invalid,
            after.failures - before.failures,
            after.severity - before.severity};
}

/// Those of the cells that are closed but no balls: cells with a hole through them.
std::vector<Label> closedCells(const MeshEditor& editor, std::span<const Label> cells) {
    std::vector<Label> closed;
    for (const Label c : cells)
        if (!allBalls(editor, {&c, 1})) closed.push_back(c);
    return closed;
}

/// Whether the cells are balls, but for some that need only be closed.
bool keepShapes(const MeshEditor& editor,
                std::span<const Label> cells,
                std::span<const Label> closed) {
    return std::all_of(cells.begin(), cells.end(), [&](Label c) {
        return allBalls(editor, {&c, 1}) ||
               (std::find(closed.begin(), closed.end(), c) != closed.end() &&
                cellShape(editor.mesh(), c) == CellShape::closed);
    });
}

/// Tries moves round one cell.
class MoveSearch {
public:
    MoveSearch(MeshEditor& editor, Label cell, WorkBudget& budget)
        : editor_(editor), cell_(cell), budget_(budget), size_(editor.cell(cell).size) {}

    void proposeCut(const std::optional<CellCut>& loops) {
        if (!loops) return;
        RepairMove move{.remedy = Remedy::cut, .from = cell_};
        move.loops = *loops;
        judge(std::move(move));
    }

    void proposeMerges() {
        for (const MergePartner& partner : mergePartners(editor_, cell_))
            if (budget_.spend(editor_.cell(cell_).faces.size() +
                              editor_.cell(partner.cell).faces.size()))
                judge({.remedy = Remedy::merge, .from = cell_, .to = partner.cell});
    }

    void proposeCollapses() {
        for (const auto& [low, high] : shortEdgesOf(editor_, cell_, longestCollapse * size_)) {
            proposeCollapse(low, high);
            proposeCollapse(high, low);
        }
    }

    void proposeCollapsesTogether() {
        for (std::size_t i = 0; i < shortLimits.size(); ++i)
            if (spend()) judge({.remedy = Remedy::collapseAll, .from = cell_, .to = toLabel(i)});
    }

    /// Bent and concave faces: chords between any two corners.
    void proposeFaceSplits() {
        constexpr std::size_t maxCorners = 12;
        const auto faces = editor_.cell(cell_).faces; // a copy: splitting changes the list
        for (const Label f : faces) {
            const Polygon polygon = editor_.face(f).points;
            if (polygon.size() > maxCorners || editor_.isFrozenFace(f)) continue;
            for (std::size_t i = 0; i < polygon.size(); ++i)
                for (std::size_t j = i + 2; j < polygon.size() - (i == 0); ++j)
                    if (spend())
                        judge({.remedy = cellHasEdge(editor_, cell_, polygon[i], polygon[j])
                                             ? Remedy::detach
                                             : Remedy::splitFace,
                               .from = polygon[i],
                               .to = polygon[j],
                               .face = f,
                               .cell = cell_});
        }
    }

    void proposeUnions() {
        for (std::size_t i = 0; i < turnLimits.size(); ++i)
            if (spend()) judge({.remedy = Remedy::unite, .from = cell_, .to = toLabel(i)});
    }

    void proposeAllCuts() {
        constexpr std::size_t mostCuts = 6;
        const std::array<Label, 1> one{cell_};
        const std::vector<Label> region = withNeighbours(editor_, one);
        std::vector<Cut> cuts = possibleCuts(editor_, cell_, region, {concaveAngle, true}, budget_);
        std::stable_sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) {
            return a.excess + a.after.severity < b.excess + b.after.severity;
        });
        if (cuts.size() > mostCuts) cuts.resize(mostCuts);
        for (const Cut& cut : cuts)
            proposeCut(cut.loops);
    }

    void proposeSlides() {
        for (const auto& [low, high] : shortEdgesOf(editor_, cell_, 2 * size_)) {
            proposeSlide(low, high);
            proposeSlide(high, low);
        }
    }

    /// Points that are nearly on an edge go into it: what is between the two has no thickness then.
    void proposePinches() {
        const auto edges = shortEdgesOf(editor_, cell_, 1e300);
        std::vector<Label> points;
        for (const auto& [a, b] : edges)
            points.insert(points.end(), {a, b});
        sortUnique(points);
        for (const Label p : points)
            for (const auto& [a, b] : edges)
                if (mayPinch(editor_, p, {a, b, thin * size_}) && spend())
                    judge({.remedy = Remedy::pinch, .from = p, .to = a, .end = b});
    }

    std::vector<RepairMove> moves;

private:
    bool spend() { return budget_.spend(editor_.cell(cell_).faces.size()); }

    bool isHuge(Label cell) {
        const double size = editor_.cell(cell).size;
        return editor_.cellGeometry(cell).volume > largestMerged * size * size * size;
    }

    /// Fills in what a move does, and lists it if it can be made.
    void judge(RepairMove move) {
        std::vector<Label> region = cellsChangedBy(editor_, move);
        if (region.empty()) return;
        if (needsNeighbours(move.remedy)) region = withNeighbours(editor_, region);
        const std::vector<Label> closed = closedCells(editor_, region);
        const Badness before = badnessOf(editor_, region);
        const double volume = movesPoints(move.remedy) ? volumeOf(editor_, region) : 0;
        const MeshEditor::Mark mark = editor_.mark();
        const Label oldCells = editor_.cellCount();
        if (change(editor_, move)) {
            for (Label c = oldCells; c < editor_.cellCount(); ++c)
                region.push_back(c);
            if (keepShapes(editor_, region, closed) && isAllowed(move, region, volume)) {
                move.change = difference(badnessOf(editor_, region), before);
                moves.push_back(std::move(move));
            }
        }
        editor_.undoTo(mark);
    }

    bool isAllowed(const RepairMove& move, std::span<const Label> region, double volume) {
        if (move.remedy == Remedy::merge) return !isHuge(move.to);
        return !movesPoints(move.remedy) || std::abs(volumeOf(editor_, region) - volume) <
                                                largestVolumeChange * size_ * size_ * size_;
    }

    void proposeCollapse(Label from, Label to) {
        if (mayCollapse(editor_, from, to) && spend())
            judge({.remedy = Remedy::collapse, .from = from, .to = to});
    }

    void proposeSlide(Label from, Label to) {
        if (!maySlide(editor_, from, to)) return;
        for (const double part : {0.25, 0.6})
            if (spend())
                judge({.remedy = Remedy::slide,
                       .from = from,
                       .to = to,
                       .position = (1 - part) * editor_.point(from) + part * editor_.point(to)});
    }

    MeshEditor& editor_;
    Label cell_;
    WorkBudget& budget_;
    double size_; // [m]
};

} // namespace

bool isGood(const Badness& change) {
    if (change.invalid != 0) return change.invalid < 0;
    return change.failures < 0 || (change.failures == 0 && change.severity < -1e-3);
}

bool isBetterChange(const Badness& a, const Badness& b) {
    if (a.invalid != b.invalid) return a.invalid < b.invalid;
    return a.failures != b.failures ? a.failures < b.failures : a.severity < b.severity - 1e-9;
}

std::vector<RepairMove> plainMoves(MeshEditor& editor, Label cell, WorkBudget& budget) {
    MoveSearch search(editor, cell, budget);
    search.proposeCut(bestReflexCut(editor, cell, concaveAngle, budget));
    search.proposeMerges();
    search.proposeCollapses();
    search.proposeCollapsesTogether();
    return std::move(search.moves);
}

std::vector<RepairMove> furtherMoves(MeshEditor& editor, Label cell, WorkBudget& budget) {
    MoveSearch search(editor, cell, budget);
    search.proposeCut(bestHalvingCut(editor, cell, budget));
    if (std::none_of(search.moves.begin(), search.moves.end(), [](const RepairMove& move) {
            return isGood(move.change);
        }))
        search.proposeFaceSplits();
    return std::move(search.moves);
}

std::vector<RepairMove> moreMoves(MeshEditor& editor, Label cell, WorkBudget& budget) {
    MoveSearch search(editor, cell, budget);
    search.proposeUnions();
    search.proposePinches();
    search.proposeSlides();
    search.proposeAllCuts();
    return std::move(search.moves);
}

std::optional<std::vector<Label>> makeMove(MeshEditor& editor, const RepairMove& move) {
    std::vector<Label> cells = cellsChangedBy(editor, move);
    if (move.remedy == Remedy::collapseAll) {
        const std::array<Label, 1> one{move.from};
        cells = withNeighbours(editor, one);
    }
    const MeshEditor::Mark mark = editor.mark();
    const Label oldCells = editor.cellCount();
    if (!change(editor, move)) return std::nullopt;
    for (Label c = oldCells; c < editor.cellCount(); ++c)
        cells.push_back(c);
    // What a move drops on the way (points, flaps) can change cells further off.
    const std::vector<Label> reshaped = editor.reshapedSince(mark);
    cells.insert(cells.end(), reshaped.begin(), reshaped.end());
    std::ranges::sort(cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    std::erase_if(cells, [&](Label c) { return editor.cell(c).isRemoved() || editor.isFrozen(c); });
    return cells;
}

} // namespace polymesh
