// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/collapseEdges.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/collapsePoints.h"
#include "libpolymesh/quality/polygons.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <tuple>

namespace polymesh {

namespace {

/// An edge that may be too short; low < high.
struct ShortEdge {
    double length = 0; // [m]
    Label low = -1;
    Label high = -1;

    bool operator==(const ShortEdge&) const = default;
};

bool isShorter(const ShortEdge& a, const ShortEdge& b) {
    return std::tie(a.length, a.low, a.high) < std::tie(b.length, b.low, b.high);
}

double sizeAt(const MeshEditor& editor, Label f) {
    const EditFace& face = editor.face(f);
    const double size = editor.cell(face.owner).size;
    return face.neighbour < 0 ? size : std::min(size, editor.cell(face.neighbour).size);
}

std::vector<Label> facesOfEdge(const MeshEditor& editor, Label a, Label b) {
    std::vector<Label> faces;
    for (const Label f : editor.facesOfPoint(a))
        if (hasEdge(editor.face(f).points, a, b)) faces.push_back(f);
    return faces;
}

bool isShort(const MeshEditor& editor, Label a, Label b, double minEdge) {
    const double length = norm(editor.point(a) - editor.point(b));
    const std::vector<Label> faces = facesOfEdge(editor, a, b);
    return !faces.empty() && std::all_of(faces.begin(), faces.end(), [&](Label f) {
        return length < minEdge * sizeAt(editor, f);
    });
}

/// The edges of a face that are short by its own cells' sizes.
void addShortEdges(const MeshEditor& editor,
                   Label f,
                   double minEdge,
                   std::vector<ShortEdge>& edges) {
    const EditFace& face = editor.face(f);
    if (face.isRemoved()) return;
    const double limit = minEdge * sizeAt(editor, f);
    Label a = face.points.back();
    for (const Label b : face.points) {
        const double length = norm(editor.point(a) - editor.point(b));
        if (length < limit) edges.push_back({length, std::min(a, b), std::max(a, b)});
        a = b;
    }
}

void sortUnique(std::vector<ShortEdge>& edges) {
    std::sort(edges.begin(), edges.end(), isShorter);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

std::vector<ShortEdge> allShortEdges(const MeshEditor& editor, double minEdge) {
    constexpr Label block = 16384;
    std::vector<std::vector<ShortEdge>> found(index((editor.faceCount() + block - 1) / block));
    parallelBlocks(editor.faceCount(), block, [&](Label b, Label first, Label last) {
        for (Label f = first; f < last; ++f)
            addShortEdges(editor, f, minEdge, found[index(b)]);
    });
    std::vector<ShortEdge> all;
    for (const auto& edges : found)
        all.insert(all.end(), edges.begin(), edges.end());
    sortUnique(all);
    return all;
}

// Cells with more faces are too dear to judge at every step; for them only faces round the edge
// are.
constexpr std::size_t manyFaces = 64;

std::vector<Label> judgedCells(const MeshEditor& editor, const std::vector<Label>& cells) {
    std::vector<Label> judged = cells;
    std::erase_if(judged, [&](Label c) { return editor.cell(c).faces.size() > manyFaces; });
    return judged;
}

/// The corners next to `p` in the faces of a cell, and the faces: what a collapse has to look at.
struct Link {
    std::vector<Label> faces;
    std::vector<Label> points; // ascending, each once

    Link(const MeshEditor& editor, Label cell, Label p) {
        for (const Label f : editor.facesOfPoint(p)) {
            const EditFace& face = editor.face(f);
            if (face.owner != cell && face.neighbour != cell) continue;
            faces.push_back(f);
            points.push_back(cornerBefore(face.points, p));
            points.push_back(cornerAfter(face.points, p));
        }
        std::sort(points.begin(), points.end());
        points.erase(std::unique(points.begin(), points.end()), points.end());
    }
};

/// The link condition: after the collapse the cell is still a ball, or it is flat and vanishes.
bool linkAllows(const MeshEditor& editor, Label cell, Label a, Label b) {
    const Link atB(editor, cell, b);
    if (atB.faces.empty()) return true;
    const Link atA(editor, cell, a);
    std::vector<Label> apexes;
    std::size_t sharing = 0;
    for (const Label f : atA.faces) {
        const Polygon& polygon = editor.face(f).points;
        if (!hasPoint(polygon, b)) continue;
        ++sharing;
        if (polygon.size() == 3)
            for (const Label p : polygon)
                if (p != a && p != b) apexes.push_back(p);
    }
    return sharing == 2 && std::all_of(atA.points.begin(), atA.points.end(), [&](Label p) {
               return !std::binary_search(atB.points.begin(), atB.points.end(), p) ||
                      std::find(apexes.begin(), apexes.end(), p) != apexes.end();
           });
}

/// Removes the cells that the collapse has made flat; false when one is left with too few faces.
bool removeFlatCells(MeshEditor& editor, const std::vector<Label>& cells) {
    for (const Label c : cells) {
        const std::size_t faces = editor.cell(c).faces.size();
        if (editor.isFrozen(c) || faces == 0 || faces > 3) continue;
        if (faces == 3) return false;
        const CollapseCounts counts = tidyCells(editor, {c});
        if (counts.brokenCells > 0 || counts.addedCells > 0) return false;
    }
    return true;
}

using FaceAreas = std::vector<std::pair<Label, Vec3>>;

/// The area vectors of the faces of a point.
FaceAreas areasAt(MeshEditor& editor, Label p) {
    FaceAreas areas;
    for (const Label f : editor.facesOfPoint(p))
        areas.emplace_back(f, editor.faceGeometry(f).area);
    return areas;
}

/// Whether a face has turned round, or has lost its area.
bool anyTurned(MeshEditor& editor, const FaceAreas& before) {
    return std::any_of(before.begin(), before.end(), [&](const auto& entry) {
        return !editor.face(entry.first).isRemoved() &&
               dot(editor.faceGeometry(entry.first).area, entry.second) <=
                   1e-9 * squaredNorm(entry.second);
    });
}

} // namespace

EdgeKind edgeKind(MeshEditor& editor, Label a, Label b) {
    constexpr double featureCosine = 0.996; // of 5 degrees: the exact angle is the trimmer's affair
    std::vector<Label> faces = facesOfEdge(editor, a, b);
    std::erase_if(faces, [&](Label f) { return !editor.face(f).isBoundary(); });
    EdgeKind kind;
    kind.boundary = !faces.empty();
    if (faces.size() != 2) return kind;
    const Vec3 u = editor.faceGeometry(faces[0]).area;
    const Vec3 v = editor.faceGeometry(faces[1]).area;
    kind.feature = editor.face(faces[0]).patch != editor.face(faces[1]).patch ||
                   dot(u, v) < featureCosine * norm(u) * norm(v);
    return kind;
}

bool mayCollapse(MeshEditor& editor, Label from, Label to) {
    const PointRank rank = editor.rank(from);
    if (rank > editor.rank(to) || rank == PointRank::fixed) return false;
    if (rank == PointRank::interior) return true;
    const EdgeKind kind = edgeKind(editor, from, to);
    return rank == PointRank::surface ? kind.boundary : kind.feature;
}

bool collapseEdge(MeshEditor& editor, Label from, Label to) {
    for (const Label f : editor.facesOfPoint(from)) {
        const Polygon& polygon = editor.face(f).points;
        if (hasPoint(polygon, to) && !hasEdge(polygon, from, to)) return false;
    }
    const std::vector<Label> cells = cellsOfPoint(editor, from);
    for (const Label c : cells)
        if (!linkAllows(editor, c, from, to)) return false;
    const std::vector<Label> faces(editor.facesOfPoint(from).begin(),
                                   editor.facesOfPoint(from).end());
    for (const Label f : faces) {
        Polygon walk = editor.face(f).points;
        std::replace(walk.begin(), walk.end(), from, to);
        setFaceWalk(editor, f, walk);
    }
    return removeFlatCells(editor, cells) && allBalls(editor, judgedCells(editor, cells));
}

Label collapseBestWay(MeshEditor& editor, Label a, Label b) {
    Label best = -1;
    Badness bestAfter;
    for (const Label from : {a, b}) {
        const Label to = from == a ? b : a;
        if (!mayCollapse(editor, from, to)) continue;
        const std::vector<Label> cells = cellsOfPoint(editor, from);
        const std::vector<Label> judged = judgedCells(editor, cells);
        const Badness before = badnessOf(editor, judged);
        const auto areas = judged.size() < cells.size() ? areasAt(editor, from) : FaceAreas{};
        const MeshEditor::Mark mark = editor.mark();
        if (collapseEdge(editor, from, to) && !anyTurned(editor, areas)) {
            const Badness after = badnessOf(editor, judged);
            if (isNoWorse(after, before) && (best < 0 || isBetter(after, bestAfter))) {
                best = from;
                bestAfter = after;
            }
        }
        editor.undoTo(mark);
    }
    if (best >= 0) collapseEdge(editor, best, best == a ? b : a);
    return best;
}

Label collapseShortEdges(MeshEditor& editor, double minEdge) {
    if (minEdge <= 0) return 0;
    const std::vector<ShortEdge> all = allShortEdges(editor, minEdge);
    std::deque<ShortEdge> queue(all.begin(), all.end());
    Label collapsed = 0;
    while (!queue.empty()) {
        const ShortEdge edge = queue.front();
        queue.pop_front();
        if (!isShort(editor, edge.low, edge.high, minEdge)) continue;
        const Label gone = collapseBestWay(editor, edge.low, edge.high);
        editor.commit();
        if (gone < 0) continue;
        ++collapsed;
        const Label kept = gone == edge.low ? edge.high : edge.low;
        std::vector<ShortEdge> next; // edges that the kept point has taken over
        for (const Label f : editor.facesOfPoint(kept))
            addShortEdges(editor, f, minEdge, next);
        std::erase_if(next, [&](const ShortEdge& e) { return e.low != kept && e.high != kept; });
        sortUnique(next);
        queue.insert(queue.end(), next.begin(), next.end());
    }
    return collapsed;
}

} // namespace polymesh
