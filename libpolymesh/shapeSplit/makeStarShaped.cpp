// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/makeStarShaped.h"

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/cutCell.h"
#include "libpolymesh/quality/possibleCuts.h"
#include "libpolymesh/shapeSplit/editedShape.h"
#include "libpolymesh/shapeSplit/faceCuts.h"
#include "libpolymesh/shapeSplit/innerPoint.h"
#include "libpolymesh/shapeSplit/rimCuts.h"
#include "libpolymesh/shapes/baseShapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

namespace polymesh {

namespace {

/// True when pyramids can be made of a cell.
bool hasApex(MeshEditor& editor, Label cell, bool mayFold) {
    if (hasLargeFace(editor, cell)) return false;
    return innerPoint(editor, cell) || (mayFold && pointBehindFaces(editor, cell));
}

bool isDone(MeshEditor& editor, Label cell, bool mayFold) {
    return isAcceptable(editor, cell) || hasApex(editor, cell, mayFold);
}

/// Cuts the boundary faces of a cell that are not plane into triangles.
void makeBoundaryPlane(MeshEditor& editor, Label cell) {
    if (editor.isFrozen(cell)) return;
    const auto faces = editor.cell(cell).faces; // a copy: cutting changes the list
    for (const Label f : faces)
        if (editor.face(f).isBoundary() && !isPlane(editor, f))
            if (!cutFromMiddle(editor, f, editor.face(f).points.size()))
                cutByChordsKeepingVolume(editor, f, 3);
}

/// Cuts the faces that are not plane and that other cells share into triangles from one corner.
/// False when there are none.
bool makeSharedPlane(MeshEditor& editor, Label cell, std::size_t corner) {
    const auto faces = editor.cell(cell).faces; // a copy: cutting changes the list
    bool any = false;
    for (const Label f : faces)
        if (!editor.face(f).isBoundary() && !isPlane(editor, f))
            any = cutFromCorner(editor, f, corner) || any;
    return any;
}

/// The cells that have a point in common with a cell, and the cell.
std::vector<Label> cellsAround(const MeshEditor& editor, Label cell) {
    std::vector<Label> cells;
    for (const Label f : editor.cell(cell).faces)
        for (const Label p : editor.face(f).points)
            for (const Label c : cellsOfPoint(editor, p))
                cells.push_back(c);
    std::ranges::sort(cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

/// The volume [m^3] that the boundary faces of cells bound, seen from a point.
double boundedVolume(MeshEditor& editor, std::span<const Label> cells, const Vec3& from) {
    double volume = 0;
    for (const Label c : cells)
        for (const Label f : editor.cell(c).faces)
            if (editor.face(f).isBoundary()) {
                const FaceGeometry& geometry = editor.faceGeometry(f);
                volume += dot(geometry.area, geometry.centre - from) / 3;
            }
    return volume;
}

class StarCutter {
public:
    StarCutter(MeshEditor& editor, const CutEffort& effort) : editor_(editor), effort_(effort) {}

    /// Cuts the cell and the parts again; false when some part is left that needs it.
    bool cut(Label cell) {
        std::vector<Label> waiting{cell};
        for (int cuts = 0; !waiting.empty();) {
            const Label part = waiting.back();
            if (isDone(editor_, part, effort_.mayFold)) {
                waiting.pop_back();
                parts_.push_back(part);
                continue;
            }
            const Label added = cuts++ < effort_.cuts ? bestCut(part) : -1;
            if (added < 0) return false;
            waiting.push_back(added);
        }
        return true;
    }

    std::vector<Label> parts() const { return parts_; }

private:
    /// What a cut is compared with.
    struct Before {
        std::vector<Label> around; // cells
        Vec3 from;
        double volume = 0; // [m^3] bounded by the boundary faces of these cells, seen from there
    };

    /// How much is left to do after a cut: parts that are not done count most. None for a cut that
    /// cannot be made or changes the volume, as a new point on the rim of a warped face does.
    std::optional<double> costOf(const CellCut& candidate, Label cell, const Before& before) {
        const MeshEditor::Mark mark = editor_.mark();
        const Label added = cutCell(editor_, cell, candidate);
        std::optional<double> cost;
        if (added >= 0 && keepsVolume(cell, added, before) && areSound(editor_, mark)) {
            cost = 0;
            for (const Label part : {cell, added})
                *cost += totalExcess(editor_, part, 0.01) + costOfPart(part);
        }
        editor_.undoTo(mark);
        return cost;
    }

    /// An acceptable part may be as flat as the faces that it was cut from.
    double costOfPart(Label part) {
        constexpr double notDone = 100;
        constexpr double acceptableOnly = 10;
        if (hasApex(editor_, part, effort_.mayFold)) return 0;
        return isAcceptable(editor_, part) ? acceptableOnly : notDone;
    }

    bool keepsVolume(Label cell, Label added, const Before& before) {
        constexpr double rounding = 1e-12;
        std::vector<Label> around = before.around;
        around.push_back(added);
        const double size = editor_.cell(cell).size;
        return std::abs(boundedVolume(editor_, around, before.from) - before.volume) <=
               rounding * size * size * size;
    }

    Label bestCut(Label cell) {
        for (const double tolerance : {0.1, 0.01})
            if (const Label added = bestOf(planeCuts(cell, tolerance), cell); added >= 0)
                return added;
        if (!effort_.alongRims) return -1;
        std::vector<CellCut> cuts;
        for (CellLoop& loop : rimCuts(editor_, cell))
            cuts.push_back({std::move(loop)});
        return bestOf(cuts, cell);
    }

    /// The cuts along planes that leave the least concavity.
    std::vector<CellCut> planeCuts(Label cell, double tolerance) {
        const std::array<Label, 1> one{cell};
        WorkBudget budget(effort_.tries);
        budget.startCell(0);
        std::vector<Cut> cuts =
            possibleCuts(editor_, cell, withNeighbours(editor_, one), {tolerance, true}, budget);
        std::ranges::stable_sort(cuts, {}, &Cut::excess);
        if (cuts.size() > effort_.candidates) cuts.resize(effort_.candidates);
        std::vector<CellCut> loops;
        loops.reserve(cuts.size());
        for (Cut& cut : cuts)
            loops.push_back(std::move(cut.loops));
        return loops;
    }

    /// Makes the cut that leaves least to do; returns the new cell, -1 when none can be made.
    Label bestOf(const std::vector<CellCut>& cuts, Label cell) {
        Before before{cellsAround(editor_, cell), editor_.cellGeometry(cell).centre, 0};
        before.volume = boundedVolume(editor_, before.around, before.from);
        const CellCut* best = nullptr;
        std::optional<double> bestCost;
        for (const CellCut& cut : cuts) {
            const auto cost = costOf(cut, cell, before);
            if (!cost || (bestCost && *cost >= *bestCost)) continue;
            best = &cut;
            bestCost = cost;
        }
        return best ? cutCell(editor_, cell, *best) : -1;
    }

    MeshEditor& editor_;
    CutEffort effort_;
    std::vector<Label> parts_;
};

/// Of the corners from which shared faces can be cut into triangles, the one that leaves the fewest
/// cells beside this one to be cut; none when it leaves this one to be cut. Changes nothing.
std::optional<std::size_t> bestCorner(MeshEditor& editor, Label cell) {
    const MeshEditor::Mark mark = editor.mark();
    std::optional<std::size_t> best;
    std::ptrdiff_t fewest = 0;
    for (std::size_t corner = 0; corner < maxShapeFacePoints; ++corner) {
        if (makeSharedPlane(editor, cell, corner) && isDone(editor, cell, false) &&
            areSound(editor, mark)) {
            const std::ptrdiff_t left =
                std::ranges::count_if(editor.reshapedSince(mark), [&](Label c) {
                    return !editor.isFrozen(c) && !isDone(editor, c, false);
                });
            if (!best || left < fewest) {
                best = corner;
                fewest = left;
            }
        }
        editor.undoTo(mark);
    }
    return best;
}

} // namespace

std::vector<Label> makeStarShaped(MeshEditor& editor, Label cell, const CutEffort& effort) {
    if (const auto corner = bestCorner(editor, cell)) {
        makeSharedPlane(editor, cell, *corner);
        return {cell};
    }
    const MeshEditor::Mark mark = editor.mark();
    const std::vector<Label> around = cellsAround(editor, cell);
    for (int preparation = 0; preparation < 4; ++preparation) {
        if (preparation > 0) makeBoundaryPlane(editor, cell);
        if (preparation > 1) makeSharedPlane(editor, cell, 0);
        if (preparation > 2)
            for (const Label c : around)
                makeBoundaryPlane(editor, c);
        StarCutter cutter(editor, effort);
        if (cutter.cut(cell) && areSound(editor, mark)) return cutter.parts();
        editor.undoTo(mark);
    }
    return {};
}

} // namespace polymesh
