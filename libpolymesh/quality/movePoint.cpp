// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/movePoint.h"

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/collapseEdges.h"
#include "libpolymesh/quality/collapsePoints.h"
#include "libpolymesh/quality/cutCell.h"
#include "libpolymesh/quality/polygons.h"

#include <algorithm>

namespace polymesh {

namespace {

/// Where the foot of the perpendicular from p is on the edge, as a fraction of it.
double footOn(const MeshEditor& editor, Label p, Label a, Label b) {
    const Vec3 edge = editor.point(b) - editor.point(a);
    return dot(editor.point(p) - editor.point(a), edge) / std::max(squaredNorm(edge), 1e-300);
}

PointRank rankOfEdge(MeshEditor& editor, Label a, Label b) {
    const EdgeKind kind = edgeKind(editor, a, b);
    if (kind.feature) return PointRank::feature;
    return kind.boundary ? PointRank::surface : PointRank::interior;
}

/// Where a cell has an edge from p to another corner of one of its faces, the face is cut there: so
/// that parts of it can cancel with the faces that lie on them now.
void splitAtEdgesOf(MeshEditor& editor, Label p) {
    const std::vector<Label> faces(editor.facesOfPoint(p).begin(), editor.facesOfPoint(p).end());
    for (const Label f : faces) {
        const EditFace face = editor.face(f);
        for (const Label corner : face.points) {
            if (corner == p || hasEdge(face.points, p, corner)) continue;
            if (!cellHasEdge(editor, face.owner, p, corner) &&
                (face.neighbour < 0 || !cellHasEdge(editor, face.neighbour, p, corner)))
                continue;
            splitFace(editor, f, p, corner);
            break;
        }
    }
}

} // namespace

Label movePoint(MeshEditor& editor, Label p, const Vec3& position, PointRank rank) {
    const std::vector<Label> faces(editor.facesOfPoint(p).begin(), editor.facesOfPoint(p).end());
    const Label moved = editor.addPoint(position, rank);
    for (const Label f : faces) {
        Polygon corners = editor.face(f).points;
        std::replace(corners.begin(), corners.end(), p, moved);
        editor.setFacePoints(f, corners);
    }
    return moved;
}

bool maySlide(MeshEditor& editor, Label from, Label to) {
    switch (editor.rank(from)) {
    case PointRank::interior:
        return true;
    case PointRank::surface:
        return edgeKind(editor, from, to).boundary;
    case PointRank::feature:
        return edgeKind(editor, from, to).feature;
    default:
        return false;
    }
}

bool mayPinch(MeshEditor& editor, Label p, const PinchEdge& edge) {
    constexpr double nearEnd = 0.02; // there the point is collapsed onto the end
    if (p == edge.a || p == edge.b || editor.rank(p) == PointRank::fixed) return false;
    const double foot = footOn(editor, p, edge.a, edge.b);
    if (foot < nearEnd || foot > 1 - nearEnd) return false;
    if (distanceFromLine(editor.point(p), editor.point(edge.a), editor.point(edge.b)) > edge.reach)
        return false;
    for (const Label f : editor.facesOfPoint(edge.a))
        if (hasEdge(editor.face(f).points, edge.a, edge.b) && editor.isFrozenFace(f)) return false;
    return true;
}

bool pinchIntoEdge(MeshEditor& editor, Label p, Label a, Label b) {
    const PointRank rank = rankOfEdge(editor, a, b);
    const double foot = footOn(editor, p, a, b);
    Label into = p;
    if (editor.rank(p) <= rank)
        into = movePoint(editor, p, (1 - foot) * editor.point(a) + foot * editor.point(b), rank);
    std::vector<Label> cells = cellsOfPoint(editor, into);
    const std::vector<Label> faces(editor.facesOfPoint(a).begin(), editor.facesOfPoint(a).end());
    for (const Label f : faces) {
        if (!hasEdge(editor.face(f).points, a, b)) continue;
        for (const Label c : {editor.face(f).owner, editor.face(f).neighbour})
            if (c >= 0) cells.push_back(c);
        Polygon walk = editor.face(f).points;
        const auto at = std::find(walk.begin(), walk.end(), a);
        walk.insert(cornerAfter(walk, a) == b ? at + 1 : at, into);
        setFaceWalk(editor, f, walk);
    }
    splitAtEdgesOf(editor, into);
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return tidyCells(editor, cells).brokenCells == 0;
}

} // namespace polymesh
