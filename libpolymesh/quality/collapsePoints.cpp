// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/collapsePoints.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/polygons.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace polymesh {

namespace {

/// The faces that have a point with another representative, and those that are none (pieces between
/// a line of the surface and a bent face), ascending.
std::vector<Label> facesToChange(const EditMesh& mesh, std::span<const Label> representative) {
    std::vector<std::uint8_t> change(mesh.faces.size(), 0);
    parallelFor(toLabel(mesh.faces.size()), [&](Label f) {
        const EditFace& face = mesh.faces[index(f)];
        if (face.isRemoved()) return;
        change[index(f)] = face.points.size() < 3 ||
                           std::any_of(face.points.begin(), face.points.end(), [&](Label p) {
                               return representative[index(p)] != p;
                           });
    });
    std::vector<Label> faces;
    for (std::size_t f = 0; f < change.size(); ++f)
        if (change[f]) faces.push_back(toLabel(f));
    return faces;
}

void sortUnique(std::vector<Label>& labels) {
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
}

/// The corners of a face as seen from outside the cell.
Polygon outwardCorners(const EditFace& face, Label cell) {
    Polygon corners = face.points;
    if (face.owner != cell) std::reverse(corners.begin(), corners.end());
    return corners;
}

double distanceFromSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double length2 = squaredNorm(b - a);
    const double t = length2 > 0 ? std::clamp(dot(p - a, b - a) / length2, 0.0, 1.0) : 0.0;
    return norm(p - (a + t * (b - a)));
}

/// Whether a point in the plane of a polygon is in it or within the tolerance of its border.
bool holdsPoint(const MeshEditor& editor,
                const Polygon& polygon,
                const Vec3& area,
                const Vec3& p,
                double tolerance) {
    double winding = 0; // [rad]
    Vec3 a = editor.point(polygon.back());
    for (const Label corner : polygon) {
        const Vec3 b = editor.point(corner);
        if (distanceFromSegment(p, a, b) <= tolerance) return true;
        winding += std::atan2(dot(cross(a - p, b - p), area) / norm(area), dot(a - p, b - p));
        a = b;
    }
    return std::abs(winding) > 1;
}

/// True when the face `part` lies on the face `whole` and all its corners are within it.
bool liesOn(MeshEditor& editor, Label part, Label whole, double tolerance) {
    const Vec3 area = editor.faceGeometry(whole).area;
    const double size = norm(area);
    if (size <= 0 || norm(editor.faceGeometry(part).area) > size) return false;
    const Polygon& polygon = editor.face(whole).points;
    const Vec3 origin = editor.point(polygon[0]);
    const Polygon& corners = editor.face(part).points;
    return std::all_of(corners.begin(), corners.end(), [&](Label corner) {
        const Vec3 p = editor.point(corner);
        return std::abs(dot(p - origin, area)) <= tolerance * size &&
               holdsPoint(editor, polygon, area, p, tolerance);
    });
}

/// Takes the flat part of a cell between the face `whole` and the face `part` that lies on it out
/// of the cell: `part` goes to the cell beyond `whole`, and `whole` becomes the rest. The two have
/// the edge a-b in common, that outward `whole` runs from a to b and `part` from b to a.
/// The sum of the faces of each cell is the same as before, so closed cells stay closed.
void peelOff(MeshEditor& editor, Label cell, Label part, Label whole, const EdgeUse& edge) {
    const Label a = edge.forward ? edge.low : edge.high;
    const Label b = edge.forward ? edge.high : edge.low;
    Polygon walk = outwardCorners(editor.face(whole), cell);
    std::rotate(walk.begin(), std::find(walk.begin(), walk.end(), b), walk.end());
    Polygon round = outwardCorners(editor.face(part), cell);
    std::rotate(round.begin(), std::find(round.begin(), round.end(), a), round.end());
    walk.insert(walk.end(), round.begin() + 1, round.end() - 1); // from a, where it ends, to b
    if (editor.face(whole).owner != cell) std::reverse(walk.begin(), walk.end());

    const Label beyond = editor.otherCell(whole, cell);
    EditFace moved = editor.face(part);
    const Label other = editor.otherCell(part, cell);
    if (beyond == other) {
        editor.removeFace(part);
    } else if (beyond >= 0) {
        editor.giveFace(part, cell, beyond);
    } else {
        if (moved.owner == cell) std::reverse(moved.points.begin(), moved.points.end());
        moved.owner = other;
        moved.neighbour = -1;
        moved.patch = editor.face(whole).patch;
        editor.replaceFace(part, moved);
    }
    setFaceWalk(editor, whole, walk);
}

/// Whether the face of `v`, turned against that of `u` at their edge, lies flat on it and may go.
bool liesFlatOn(MeshEditor& editor, const EdgeUse& v, const EdgeUse& u, double size) {
    constexpr double roundOff = 1e-10; // of the cell's size
    if (v.forward == u.forward) return false;
    if (editor.isFrozenFace(u.face) || editor.isFrozenFace(v.face)) return false;
    if (norm(editor.faceGeometry(v.face).area) <= roundOff * size * size) return false;
    return liesOn(editor, v.face, u.face, roundOff * size);
}

/// Peels one flat part off a cell at an edge that it uses more than twice; the cells whose faces
/// change are added to `touched`.
bool peelOnce(MeshEditor& editor, Label cell, std::vector<Label>& touched) {
    const double size = editor.cell(cell).size;
    std::vector<EdgeUse> uses;
    collectEdgeUses(editor.mesh(), cell, uses);
    const auto isSameEdge = [](const EdgeUse& u, const EdgeUse& v) {
        return u.low == v.low && u.high == v.high;
    };
    for (const EdgeUse& u : uses) {
        const auto isHere = [&](const EdgeUse& v) { return isSameEdge(u, v); };
        if (std::count_if(uses.begin(), uses.end(), isHere) <= 2) continue;
        for (const EdgeUse& v : uses) {
            if (!isHere(v) || !liesFlatOn(editor, v, u, size)) continue;
            for (const Label c :
                 {cell, editor.otherCell(u.face, cell), editor.otherCell(v.face, cell)})
                if (c >= 0) touched.push_back(c);
            peelOff(editor, cell, v.face, u.face, u);
            return true;
        }
    }
    return false;
}

/// A cell that touches itself along an edge has no thickness there, where the surface lies on a
/// part of one of its faces: takes these flat parts out of it.
void peelFlatParts(MeshEditor& editor, Label cell, std::vector<Label>& touched) {
    // Each step takes area away from the faces of the mesh; the bound is for coordinates that make
    // no sense.
    for (std::size_t left = editor.cell(cell).faces.size(); left > 0; --left)
        if (editor.cell(cell).isRemoved() || cellShape(editor.mesh(), cell) != CellShape::broken ||
            !peelOnce(editor, cell, touched))
            return;
}

} // namespace

void setFaceWalk(MeshEditor& editor, Label f, const Polygon& walk) {
    const EditFace before = editor.face(f);
    const std::vector<Polygon> loops = simpleLoops(walk);
    if (loops.empty()) return editor.removeFace(f);
    editor.setFacePoints(f, loops[0]);
    for (std::size_t i = 1; i < loops.size(); ++i) {
        EditFace part = before;
        part.points = loops[i];
        editor.addFace(part);
    }
}

CollapseCounts tidyCells(MeshEditor& editor, std::vector<Label> cells) {
    // Flat parts may pass from cell to cell and, where cells overlap, come back: what is not
    // settled by then counts as broken below.
    constexpr int mostRounds = 50;
    CollapseCounts counts;
    std::vector<Label> all;
    for (int round = 0; round < mostRounds && !cells.empty(); ++round) {
        sortUnique(cells);
        all.insert(all.end(), cells.begin(), cells.end());
        std::vector<Label> touched;
        for (const Label c : cells) {
            if (editor.isFrozen(c)) continue;
            counts.removedFaces += 2 * cancelFlatPairs(editor, c, touched);
            peelFlatParts(editor, c, touched);
        }
        cells = touched;
    }
    sortUnique(all);
    for (const Label c : all) {
        if (editor.isFrozen(c)) continue;
        if (editor.cell(c).isRemoved()) {
            ++counts.removedCells;
            continue;
        }
        if (cellShape(editor.mesh(), c) == CellShape::ball) continue;
        const Label added = separateParts(editor, c);
        counts.addedCells += added;
        for (Label part = editor.cellCount() - added; part < editor.cellCount(); ++part)
            counts.brokenCells += cellShape(editor.mesh(), part) == CellShape::broken;
        counts.brokenCells += cellShape(editor.mesh(), c) == CellShape::broken;
    }
    return counts;
}

CollapseCounts collapsePoints(MeshEditor& editor, std::span<const Label> representative) {
    assert(representative.size() == editor.mesh().points.size());
    CollapseCounts counts;
    std::vector<Label> cells;
    for (const Label f : facesToChange(editor.mesh(), representative)) {
        const EditFace& face = editor.face(f);
        cells.push_back(face.owner);
        if (face.neighbour >= 0) cells.push_back(face.neighbour);
        Polygon walk = face.points;
        for (Label& p : walk)
            p = representative[index(p)];
        setFaceWalk(editor, f, walk);
        counts.removedFaces += editor.face(f).isRemoved();
    }
    const CollapseCounts tidied = tidyCells(editor, std::move(cells));
    counts.removedFaces += tidied.removedFaces;
    counts.removedCells = tidied.removedCells;
    counts.addedCells = tidied.addedCells;
    counts.brokenCells = tidied.brokenCells;
    editor.commit();
    return counts;
}

} // namespace polymesh
