// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/mergeCells.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/mergeFaces.h"
#include "libpolymesh/quality/splitConcaveCells.h"

#include <algorithm>
#include <array>
#include <deque>
#include <iterator>
#include <map>
#include <utility>

namespace polymesh {

namespace {

constexpr double largestMerged = 2.6;  // volume of a merged cell, of the cube of its size
constexpr double interfaceAngle = 0.1; // [rad] faces against one cell that turn less become one

void sortUnique(std::vector<Label>& labels) {
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
}

bool shareAny(const EditFace& face, std::span<const Label> sortedPoints) {
    return std::any_of(face.points.begin(), face.points.end(), [&](Label p) {
        return std::binary_search(sortedPoints.begin(), sortedPoints.end(), p);
    });
}

/// Unites each face that came from the other cell with a face of this cell next to it across the
/// seam.
void uniteAcrossSeam(MeshEditor& editor,
                     Label cell,
                     std::span<const Label> came,
                     std::span<const Label> seam) {
    for (const Label f : came) {
        if (editor.face(f).isRemoved() || !shareAny(editor.face(f), seam)) continue;
        const auto faces = editor.cell(cell).faces; // a copy: uniting changes the list
        for (const Label g : faces) {
            if (g == f || std::binary_search(came.begin(), came.end(), g)) continue;
            if (editor.face(g).isRemoved() || !isSameInterface(editor, f, g, cell)) continue;
            const double angle = editor.face(f).isBoundary() ? 0.0 : interfaceAngle;
            // What f has become now includes g: go on with it.
            if (isCoplanar(editor, f, g, cell, angle)) uniteFaces(editor, f, g, cell);
        }
    }
}

bool isSmall(MeshEditor& editor, Label c, double minVolume) {
    const EditCell& cell = editor.cell(c);
    if (cell.frozen || cell.isRemoved()) return false;
    return editor.cellGeometry(c).volume < minVolume * cell.size * cell.size * cell.size;
}

/// Whether a cell shares more area with a cell that may not be changed than with any other one: at
/// the seam of a slab that is its partner, once the seam is edited.
bool waitsForFrozen(MeshEditor& editor, Label cell) {
    std::map<Label, double> areas;
    for (const Label f : editor.cell(cell).faces) {
        const Label other = editor.otherCell(f, cell);
        if (other >= 0) areas[other] += norm(editor.faceGeometry(f).area);
    }
    const auto most = std::ranges::max_element(areas, {}, &std::pair<const Label, double>::second);
    return most != areas.end() && editor.isFrozen(most->first);
}

bool wouldBeHuge(MeshEditor& editor, Label from, Label into) {
    const double size = editor.cell(into).size;
    return editor.cellGeometry(from).volume + editor.cellGeometry(into).volume >
           largestMerged * size * size * size;
}

/// The two cells and those that have faces with both, ascending: the cells whose shape a merge
/// changes.
std::vector<Label> commonRegion(const MeshEditor& editor, Label a, Label b) {
    std::vector<Label> region{a, b};
    const std::array<Label, 1> one{a};
    const std::array<Label, 1> two{b};
    const std::vector<Label> roundA = withNeighbours(editor, one);
    const std::vector<Label> roundB = withNeighbours(editor, two);
    std::set_intersection(
        roundA.begin(), roundA.end(), roundB.begin(), roundB.end(), std::back_inserter(region));
    sortUnique(region);
    return region;
}

/// Merges a cell into another; true if that makes no cell round them worse. Those beyond the common
/// region have at most lost points in the middle of straight edges.
bool mergesWell(MeshEditor& editor, Label from, Label into) {
    const std::vector<Label> region = commonRegion(editor, from, into);
    const Badness before = badnessOf(editor, region);
    const MeshEditor::Mark mark = editor.mark();
    return mergeCells(editor, from, into) && allBalls(editor, editor.reshapedSince(mark)) &&
           isNoWorse(badnessOf(editor, region), before);
}

/// How far the edges of a cell turn the wrong way, in all [rad].
double concavityOf(MeshEditor& editor, Label cell) {
    constexpr double tolerance = 0.05; // [rad]
    double sum = 0;
    for (const ReflexEdge& edge : reflexEdges(editor, cell, tolerance))
        sum += edge.excess;
    return sum;
}

} // namespace

std::vector<MergePartner> mergePartners(MeshEditor& editor, Label cell) {
    std::vector<MergePartner> partners;
    for (const Label f : editor.cell(cell).faces) {
        const Label other = editor.otherCell(f, cell);
        if (other < 0 || editor.isFrozen(other)) continue;
        auto found = std::find_if(partners.begin(), partners.end(), [&](const MergePartner& p) {
            return p.cell == other;
        });
        if (found == partners.end()) found = partners.insert(found, {other, 0});
        found->area += norm(editor.faceGeometry(f).area);
    }
    std::sort(partners.begin(), partners.end(), [](const MergePartner& a, const MergePartner& b) {
        return a.area != b.area ? a.area > b.area : a.cell < b.cell;
    });
    return partners;
}

bool mergeCells(MeshEditor& editor, Label from, Label into) {
    const auto faces = editor.cell(from).faces; // a copy: the list is emptied
    std::vector<Label> came;
    std::vector<Label> seam;
    for (const Label f : faces) {
        if (editor.otherCell(f, from) == into) {
            const auto& points = editor.face(f).points;
            seam.insert(seam.end(), points.begin(), points.end());
            editor.removeFace(f);
        } else {
            editor.giveFace(f, from, into);
            came.push_back(f);
        }
    }
    if (editor.cell(into).isRemoved() || cellShape(editor.mesh(), into) != CellShape::ball)
        return false;
    sortUnique(seam);
    std::sort(came.begin(), came.end());
    uniteAcrossSeam(editor, into, came, seam);
    for (const Label p : seam)
        dropRedundantPoint(editor, p);
    return cellShape(editor.mesh(), into) == CellShape::ball;
}

Label mergeIntoBestPartner(MeshEditor& editor, Label cell) {
    Label best = -1;
    double least = 0;
    for (const MergePartner& partner : mergePartners(editor, cell)) {
        if (wouldBeHuge(editor, cell, partner.cell)) continue;
        const MeshEditor::Mark mark = editor.mark();
        if (mergesWell(editor, cell, partner.cell)) {
            const double concavity = concavityOf(editor, partner.cell);
            if (concavity <= 0) return partner.cell; // convex: the others can do no better
            if (best < 0 || concavity < least - 1e-6) {
                best = partner.cell;
                least = concavity;
            }
        }
        editor.undoTo(mark);
    }
    if (best >= 0) mergeCells(editor, cell, best);
    return best;
}

Label mergeSmallCells(MeshEditor& editor, double minVolume) {
    if (minVolume <= 0) return 0;
    editor.computeGeometry();
    std::deque<Label> small;
    for (Label c = 0; c < editor.cellCount(); ++c)
        if (isSmall(editor, c, minVolume)) small.push_back(c);
    Label merged = 0;
    while (!small.empty()) {
        const Label c = small.front();
        small.pop_front();
        if (!isSmall(editor, c, minVolume) || waitsForFrozen(editor, c)) continue;
        const Label into = mergeIntoBestPartner(editor, c);
        editor.commit();
        if (into < 0) continue;
        ++merged;
        if (isSmall(editor, into, minVolume)) small.push_back(into);
    }
    return merged;
}

} // namespace polymesh
