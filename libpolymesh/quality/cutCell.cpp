// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/cutCell.h"

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/metrics.h"
#include "libpolymesh/quality/polygons.h"

#include <algorithm>
#include <span>

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

/// Puts a point that no face uses yet into an edge, for all faces round it. False when the edge
/// cannot take one. Unlike insertPointInEdge nothing can touch itself by this.
bool breakEdge(MeshEditor& editor, Label a, Label b, Label p) {
    if (editor.rank(a) == PointRank::fixed && editor.rank(b) == PointRank::fixed) return false;
    boost::container::small_vector<Label, 8> faces;
    for (const Label f : editor.facesOfPoint(a))
        if (hasEdge(editor.face(f).points, a, b)) faces.push_back(f);
    for (const Label f : faces) {
        if (editor.isFrozenFace(f)) return false;
        Polygon points = editor.face(f).points;
        const auto at = std::find(points.begin(), points.end(), a);
        points.insert(cornerAfter(points, a) == b ? at + 1 : at, p);
        editor.setFacePoints(f, points);
    }
    return !faces.empty();
}

/// Turns the corners on edges into points of the mesh.
bool placeCorners(MeshEditor& editor, CellLoop& loop) {
    for (LoopCorner& corner : loop) {
        if (corner.point >= 0) continue;
        const PointRank rank = rankOnEdge(editor, corner.low, corner.high);
        corner.point = editor.addPoint(corner.position, rank);
        if (!breakEdge(editor, corner.low, corner.high, corner.point)) return false;
    }
    return true;
}

/// Cuts the faces along the chords of the loop. A chord that is an edge of a cell beyond already
/// would pinch that cell.
bool cutFaces(MeshEditor& editor, Label cell, const CellLoop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        if (loop[i].faceToNext < 0) continue;
        const Label a = loop[i].point;
        const Label b = loop[(i + 1) % loop.size()].point;
        if (cellHasEdge(editor, cell, a, b)) return false;
        // The face may have been cut before: then it is one of its parts.
        Label found = -1;
        for (const Label f : editor.facesOfPoint(a)) {
            const EditFace& face = editor.face(f);
            if ((face.owner != cell && face.neighbour != cell) || !hasPoint(face.points, b))
                continue;
            if (f == loop[i].faceToNext || found < 0 || (found != loop[i].faceToNext && f < found))
                found = f;
        }
        if (found < 0) return false;
        const Label other = editor.otherCell(found, cell);
        if (other >= 0 && cellHasEdge(editor, other, a, b)) return false;
        if (!splitFace(editor, found, a, b)) return false;
    }
    return true;
}

/// True when no point comes twice.
bool isSimple(const Polygon& loop) {
    Polygon sorted = loop;
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

using FacePairs = std::vector<std::pair<Label, Label>>;

/// Moves what can be reached from `start` over pairs of faces out of `rest`, which is sorted.
void takeReached(Label start, const FacePairs& joined, std::vector<Label>& rest) {
    std::vector<Label> reached{start};
    std::erase(rest, start);
    for (std::size_t next = 0; next < reached.size(); ++next)
        for (auto at = std::lower_bound(
                 joined.begin(), joined.end(), std::pair{reached[next], Label{-1}});
             at != joined.end() && at->first == reached[next];
             ++at)
            if (std::erase(rest, at->second) > 0) reached.push_back(at->second);
}

/// The faces of the cell on the side of the loops where its first face is not. Empty unless each
/// edge has two faces, the loops run along edges of the cell and part its faces in two.
std::vector<Label>
facesBeyond(const MeshEditor& editor, Label cell, std::span<const Polygon> loops) {
    thread_local std::vector<EdgeUse> uses;
    thread_local FacePairs joined; // faces with a common edge, both ways
    thread_local FacePairs parted; // faces on the two sides of a loop
    thread_local std::vector<std::pair<Label, Label>> loopEdges;
    collectEdgeUses(editor.mesh(), cell, uses);
    loopEdges.clear();
    for (const Polygon& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
            loopEdges.push_back(std::minmax({loop[i], loop[(i + 1) % loop.size()]}));
    std::sort(loopEdges.begin(), loopEdges.end());
    joined.clear();
    parted.clear();
    for (std::size_t i = 0; i + 1 < uses.size(); i += 2) {
        const std::pair<Label, Label> edge{uses[i].low, uses[i].high};
        if (edge != std::pair{uses[i + 1].low, uses[i + 1].high}) return {};
        if (std::binary_search(loopEdges.begin(), loopEdges.end(), edge)) {
            parted.emplace_back(uses[i].face, uses[i + 1].face);
            continue;
        }
        joined.emplace_back(uses[i].face, uses[i + 1].face);
        joined.emplace_back(uses[i + 1].face, uses[i].face);
    }
    if (parted.size() != loopEdges.size()) return {};
    std::sort(joined.begin(), joined.end());
    std::vector<Label> beyond(editor.cell(cell).faces.begin(), editor.cell(cell).faces.end());
    const Label first = beyond.front();
    std::sort(beyond.begin(), beyond.end());
    takeReached(first, joined, beyond);
    if (beyond.empty()) return {};
    std::vector<Label> third = beyond;
    takeReached(beyond.front(), joined, third);
    const auto isBeyond = [&](Label f) {
        return std::binary_search(beyond.begin(), beyond.end(), f);
    };
    const bool inTwo = third.empty() && std::all_of(parted.begin(), parted.end(), [&](auto pair) {
                           return isBeyond(pair.first) != isBeyond(pair.second);
                       });
    return inTwo ? beyond : std::vector<Label>{};
}

/// True when the outward face `f` of the cell runs along the edge from a to b.
bool runsForward(const EditFace& face, Label cell, Label a, Label b) {
    return (cornerAfter(face.points, a) == b) == (face.owner == cell);
}

} // namespace

bool cellHasEdge(const MeshEditor& editor, Label cell, Label a, Label b) {
    const auto faces = editor.facesOfPoint(a);
    return std::any_of(faces.begin(), faces.end(), [&](Label f) {
        const EditFace& face = editor.face(f);
        return (face.owner == cell || face.neighbour == cell) && hasEdge(face.points, a, b);
    });
}

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

Label cutCell(MeshEditor& editor, Label cell, const CellCut& wanted) {
    constexpr double leastFlatness = 0.5;
    std::vector<Polygon> loops;
    Polygon all;
    for (CellLoop loop : wanted) {
        if (loop.size() < 3 || !placeCorners(editor, loop) || !cutFaces(editor, cell, loop))
            return -1;
        loops.emplace_back();
        for (const LoopCorner& corner : loop)
            loops.back().push_back(corner.point);
        all.insert(all.end(), loops.back().begin(), loops.back().end());
    }
    if (!isSimple(all)) return -1;
    // A closed curve without repeated points cuts the surface of a ball into two discs, so that
    // with it as a face both sides are balls again.
    const std::vector<Label> beyond = facesBeyond(editor, cell, loops);
    if (beyond.size() < 3 || beyond.size() + 3 > editor.cell(cell).faces.size()) return -1;
    const Label added = editor.addPartOf(cell);
    for (const Label f : beyond)
        editor.giveFace(f, cell, added);
    Vec3 sum;
    for (Polygon& loop : loops) {
        // The cut runs along its edges against the faces beyond.
        for (const Label f : beyond)
            if (hasEdge(editor.face(f).points, loop[0], loop[1])) {
                if (runsForward(editor.face(f), added, loop[0], loop[1]))
                    std::reverse(loop.begin(), loop.end());
                break;
            }
        const Label f = editor.addFace({loop, added, cell, -1});
        // Faces that look opposite ways would be the outer and the inner edge of a ring.
        const FaceGeometry& geometry = editor.faceGeometry(f);
        if (dot(geometry.area, sum) < 0) return -1;
        sum += geometry.area;
        const std::span<const Label> corners(loop.data(), loop.size());
        if (faceFlatness(editor.mesh().points, corners, geometry) < leastFlatness) return -1;
    }
    return added;
}

Label cutCell(MeshEditor& editor, Label cell, const CellLoop& loop) {
    return cutCell(editor, cell, CellCut{loop});
}

} // namespace polymesh
