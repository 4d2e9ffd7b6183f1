// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/cellTopology.h"

#include "libpolymesh/base/disjointSets.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace polymesh {

namespace {

bool isSameEdge(const EdgeUse& a, const EdgeUse& b) {
    return a.low == b.low && a.high == b.high;
}

/// Calls body(first, last) for the uses of each edge.
template<class Body>
void forEachEdge(const std::vector<EdgeUse>& uses, Body&& body) {
    for (std::size_t first = 0; first < uses.size();) {
        std::size_t last = first + 1;
        while (last < uses.size() && isSameEdge(uses[first], uses[last]))
            ++last;
        body(first, last);
        first = last;
    }
}

Label positionOf(const EditCell& cell, Label face) {
    return static_cast<Label>(std::find(cell.faces.begin(), cell.faces.end(), face) -
                              cell.faces.begin());
}

bool isOppositePair(const EditFace& a, const EditFace& b, Label cell) {
    const std::size_t n = a.points.size();
    if (n != b.points.size()) return false;
    const auto found = std::find(b.points.begin(), b.points.end(), a.points[0]);
    if (found == b.points.end()) return false;
    const std::size_t at = static_cast<std::size_t>(found - b.points.begin());
    const bool opposite = (a.owner == cell) == (b.owner == cell);
    for (std::size_t i = 1; i < n; ++i)
        if (a.points[i] != b.points[(opposite ? at + n - i : at + i) % n]) return false;
    return true;
}

/// Joins what lies beyond the two faces of a flat pair.
void joinAcross(MeshEditor& editor, Label c, Label keep, Label drop) {
    if (editor.isFrozen(editor.otherCell(drop, c))) std::swap(keep, drop);
    EditFace value = editor.face(keep);
    const Label here = editor.otherCell(keep, c);
    const Label there = editor.otherCell(drop, c);
    const Label patch = std::max(editor.face(keep).patch, editor.face(drop).patch);
    editor.removeFace(drop);
    if (here == there) { // both outside, or both the same cell
        editor.removeFace(keep);
        return;
    }
    // Seen from c, `keep` and `drop` are the two sides of the same sheet. Where `keep` left c, its
    // normal entered `here` and left `there`.
    const bool leftCell = value.owner == c;
    const bool ownerIsHere = here >= 0;
    if (ownerIsHere == leftCell) std::reverse(value.points.begin() + 1, value.points.end());
    value.owner = ownerIsHere ? here : there;
    value.neighbour = ownerIsHere ? there : -1;
    value.patch = value.neighbour < 0 ? patch : -1;
    editor.replaceFace(keep, value);
}

} // namespace

void collectEdgeUses(const EditMesh& mesh, Label cell, std::vector<EdgeUse>& uses) {
    uses.clear();
    for (const Label f : mesh.cells[index(cell)].faces) {
        const EditFace& face = mesh.faces[index(f)];
        const bool outward = face.owner == cell;
        Label a = face.points.back();
        for (const Label b : face.points) {
            uses.push_back({std::min(a, b), std::max(a, b), f, (a < b) == outward});
            a = b;
        }
    }
    std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
        return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
    });
}

std::vector<Label> cellsOfPoint(const MeshEditor& editor, Label p) {
    std::vector<Label> cells;
    for (const Label f : editor.facesOfPoint(p)) {
        cells.push_back(editor.face(f).owner);
        if (editor.face(f).neighbour >= 0) cells.push_back(editor.face(f).neighbour);
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

CellShape cellShape(const EditMesh& mesh, Label cell) {
    thread_local std::vector<EdgeUse> uses;
    thread_local std::vector<Label> points;
    collectEdgeUses(mesh, cell, uses);
    const auto& faces = mesh.cells[index(cell)].faces;
    bool closed = true;
    std::size_t edges = 0;
    points.clear();
    forEachEdge(uses, [&](std::size_t first, std::size_t last) {
        ++edges;
        closed = closed && last - first == 2 && uses[first].forward != uses[first + 1].forward;
        points.push_back(uses[first].low);
        points.push_back(uses[first].high);
    });
    if (!closed) return CellShape::broken;
    std::sort(points.begin(), points.end());
    const auto count = std::unique(points.begin(), points.end()) - points.begin();
    const bool sphere = static_cast<std::size_t>(count) + faces.size() == edges + 2;
    return sphere && faces.size() >= 4 ? CellShape::ball : CellShape::closed;
}

bool allBalls(const MeshEditor& editor, std::span<const Label> cells) {
    return std::all_of(cells.begin(), cells.end(), [&](Label c) {
        return editor.isFrozen(c) || editor.cell(c).isRemoved() ||
               cellShape(editor.mesh(), c) == CellShape::ball;
    });
}

Wedges wedgesRound(MeshEditor& editor, Label c, std::span<const EdgeUse> uses) {
    struct Spoke {
        double angle;
        bool forward;
        Label face;
    };

    const Vec3 axis = editor.point(uses[0].high) - editor.point(uses[0].low);
    const double length = norm(axis);
    std::vector<Spoke> spokes;
    Vec3 zero;
    for (const EdgeUse& use : uses) {
        const double sign = editor.face(use.face).owner == c ? 1.0 : -1.0;
        const Vec3 normal = sign * editor.faceGeometry(use.face).area;
        const Vec3 inFace = (use.forward ? 1.0 : -1.0) * cross(normal, axis);
        if (spokes.empty()) zero = inFace;
        const double angle = std::atan2(dot(cross(zero, inFace), axis),
                                        dot(zero, inFace) * (length > 0 ? length : 1.0));
        spokes.push_back({angle, use.forward, use.face});
    }
    std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
        return std::tie(a.angle, a.forward, a.face) < std::tie(b.angle, b.forward, b.face);
    });
    Wedges wedges;
    for (std::size_t i = 0; i < spokes.size(); ++i) {
        const Spoke& next = spokes[(i + 1) % spokes.size()];
        if (!spokes[i].forward && next.forward) wedges.push_back({spokes[i].face, next.face});
    }
    return wedges;
}

Label cancelFlatPairs(MeshEditor& editor, Label cell, std::vector<Label>& touched) {
    Label pairs = 0;
    for (std::size_t i = 0; i < editor.cell(cell).faces.size();) {
        const auto& faces = editor.cell(cell).faces;
        std::size_t j = i + 1;
        while (j < faces.size() &&
               !isOppositePair(editor.face(faces[i]), editor.face(faces[j]), cell))
            ++j;
        if (j == faces.size()) {
            ++i;
            continue;
        }
        const Label keep = faces[i];
        const Label drop = faces[j];
        for (const Label other : {editor.otherCell(keep, cell), editor.otherCell(drop, cell)})
            if (other >= 0 && !editor.isFrozen(other)) touched.push_back(other);
        joinAcross(editor, cell, keep, drop);
        ++pairs;
        i = 0;
    }
    return pairs;
}

namespace {

/// Joins parts that enclose a negative volume, which are voids, to the part with the largest
/// volume; returns the lowest face of that.
Label keepVoids(MeshEditor& editor, Label c, DisjointSets& sets) {
    const auto& faces = editor.cell(c).faces;
    const Vec3 apex = editor.faceGeometry(faces[0]).centre;
    std::vector<double> volumes(faces.size(), 0); // three times, at the lowest face of each part
    for (Label i = 0; i < sets.count(); ++i) {
        const FaceGeometry& face = editor.faceGeometry(faces[index(i)]);
        const double pyramid = dot(face.area, face.centre - apex);
        volumes[index(sets.lowest(i))] +=
            editor.face(faces[index(i)]).owner == c ? pyramid : -pyramid;
    }
    const auto main = static_cast<Label>(std::ranges::max_element(volumes) - volumes.begin());
    const double size = editor.cell(c).size;
    const double roundOff = 1e-12 * size * size * size; // parts without size stay parts
    for (Label i = 0; i < sets.count(); ++i)
        if (volumes[index(i)] < -roundOff) sets.join(i, main);
    return sets.lowest(main);
}

} // namespace

Label separateParts(MeshEditor& editor, Label c) {
    std::vector<EdgeUse> uses;
    collectEdgeUses(editor.mesh(), c, uses);
    const auto faces = editor.cell(c).faces;  // a copy: giveFace changes the list
    DisjointSets sets(toLabel(faces.size())); // of places in that list
    forEachEdge(uses, [&](std::size_t first, std::size_t last) {
        if (last - first == 2)
            sets.join(positionOf(editor.cell(c), uses[first].face),
                      positionOf(editor.cell(c), uses[first + 1].face));
        else
            for (const auto& [from, to] :
                 wedgesRound(editor, c, {uses.data() + first, last - first}))
                sets.join(positionOf(editor.cell(c), from), positionOf(editor.cell(c), to));
    });
    const Label main = keepVoids(editor, c, sets);
    std::vector<Label> cellOf(faces.size(), -1);
    cellOf[index(main)] = c;
    Label added = 0;
    for (Label i = 0; i < sets.count(); ++i) {
        const Label lowest = sets.lowest(i);
        if (lowest == i && i != main) {
            cellOf[index(i)] = editor.addPartOf(c);
            ++added;
        }
        const Label cell = cellOf[index(lowest)];
        if (cell != c) editor.giveFace(faces[index(i)], c, cell);
    }
    return added;
}

} // namespace polymesh
