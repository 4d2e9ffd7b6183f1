// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/cutCell.h"

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/polygons.h"
#include "libpolymesh/quality/removeZeroSize.h"

#include <algorithm>
#include <array>

namespace polymesh {

namespace {

/// The rank of a new point on an edge: as free as its less bound end, but not freer than the faces
/// at the edge are.
PointRank rankOnEdge(const MeshEditor& editor, Label a, Label b) {
    std::vector<Label> boundary;
    for (const Label f : editor.facesOfPoint(a))
        if (editor.face(f).isBoundary() && hasEdge(editor.face(f).points, a, b))
            boundary.push_back(f);
    if (boundary.empty()) return PointRank::interior;
    const bool bound = editor.rank(a) >= PointRank::feature && editor.rank(b) >= PointRank::feature;
    const bool border =
        boundary.size() != 2 || editor.face(boundary[0]).patch != editor.face(boundary[1]).patch;
    return bound || border ? PointRank::feature : PointRank::surface;
}

/// Turns the corners on edges into points of the mesh.
bool placeCorners(MeshEditor& editor, CellLoop& loop) {
    for (LoopCorner& corner : loop) {
        if (corner.point >= 0) continue;
        const PointRank rank = rankOnEdge(editor, corner.low, corner.high);
        corner.point = editor.addPoint(corner.position, rank);
        if (!insertPointInEdge(editor, corner.low, corner.high, corner.point)) return false;
    }
    return true;
}

bool cutFaces(MeshEditor& editor, Label cell, const CellLoop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        if (loop[i].faceToNext < 0) continue;
        const Label a = loop[i].point;
        const Label b = loop[(i + 1) % loop.size()].point;
        const auto faces = editor.cell(cell).faces; // a copy: splitFace changes the list
        // The face may have been cut before: then it is one of its parts.
        Label found = -1;
        for (const Label f : faces) {
            const Polygon& polygon = editor.face(f).points;
            if (!hasPoint(polygon, a) || !hasPoint(polygon, b)) continue;
            if (hasEdge(polygon, a, b)) return false;
            if (found < 0 || f == loop[i].faceToNext) found = f;
        }
        if (found < 0 || !splitFace(editor, found, a, b)) return false;
    }
    return true;
}

bool isLoopEdge(const Polygon& loop, const EdgeUse& use) {
    return hasEdge(loop, use.low, use.high);
}

/// The faces of the cell on the side of the loop where its first face is not.
std::vector<Label> facesBeyond(const MeshEditor& editor, Label cell, const Polygon& loop) {
    std::vector<EdgeUse> uses;
    collectEdgeUses(editor.mesh(), cell, uses);
    std::vector<Label> reached{editor.cell(cell).faces[0]};
    for (std::size_t next = 0; next < reached.size(); ++next)
        for (std::size_t i = 0; i + 1 < uses.size(); i += 2) {
            if (isLoopEdge(loop, uses[i])) continue;
            for (const auto& [from, to] : {std::pair{i, i + 1}, std::pair{i + 1, i}})
                if (uses[from].face == reached[next] &&
                    std::find(reached.begin(), reached.end(), uses[to].face) == reached.end())
                    reached.push_back(uses[to].face);
        }
    std::vector<Label> beyond;
    for (const Label f : editor.cell(cell).faces)
        if (std::find(reached.begin(), reached.end(), f) == reached.end()) beyond.push_back(f);
    return beyond;
}

/// True when the outward face `f` of the cell runs along the edge from a to b.
bool runsForward(const EditFace& face, Label cell, Label a, Label b) {
    return (cornerAfter(face.points, a) == b) == (face.owner == cell);
}

} // namespace

bool splitFace(MeshEditor& editor, Label f, Label a, Label b) {
    if (editor.isFrozenFace(f)) return false;
    EditFace part = editor.face(f);
    Polygon points = part.points;
    std::rotate(points.begin(), std::find(points.begin(), points.end(), a), points.end());
    const auto middle = std::find(points.begin(), points.end(), b);
    const Polygon first(points.begin(), middle + 1);
    part.points.assign(middle, points.end());
    part.points.push_back(a);
    if (first.size() < 3 || part.points.size() < 3) return false;
    editor.setFacePoints(f, first);
    editor.addFace(part);
    return true;
}

Label cutCell(MeshEditor& editor, Label cell, const CellLoop& wanted) {
    CellLoop loop = wanted;
    if (loop.size() < 3 || !placeCorners(editor, loop) || !cutFaces(editor, cell, loop)) return -1;
    EditFace cut;
    for (const LoopCorner& corner : loop)
        cut.points.push_back(corner.point);
    if (cellShape(editor.mesh(), cell) != CellShape::ball) return -1;
    const std::vector<Label> beyond = facesBeyond(editor, cell, cut.points);
    if (beyond.size() < 3 || beyond.size() + 3 > editor.cell(cell).faces.size()) return -1;
    const Label added = editor.addPartOf(cell);
    cut.owner = added;
    cut.neighbour = cell;
    for (const Label f : beyond)
        editor.giveFace(f, cell, added);
    // The cut runs along its edges against the faces beyond.
    for (const Label f : beyond)
        if (hasEdge(editor.face(f).points, cut.points[0], cut.points[1])) {
            if (runsForward(editor.face(f), added, cut.points[0], cut.points[1]))
                std::reverse(cut.points.begin(), cut.points.end());
            break;
        }
    editor.addFace(cut);
    const std::array<Label, 2> parts{cell, added};
    return allBalls(editor, parts) ? added : -1;
}

} // namespace polymesh
