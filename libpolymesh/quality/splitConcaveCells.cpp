// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/splitConcaveCells.h"

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/cutCell.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/polygons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <tuple>

namespace polymesh {

namespace {

/// The normal, out of the cell, of the triangle between an edge of a face and the face's centre.
Vec3 normalAt(MeshEditor& editor, Label f, Label cell, Label a, Label b) {
    const Vec3 origin = editor.point(a);
    const FaceGeometry& g = editor.faceGeometry(f);
    const bool forward = cornerAfter(editor.face(f).points, a) == b;
    const Vec3 n = (forward ? 1.0 : -1.0) * cross(editor.point(b) - origin, g.centre - origin);
    // The centre of a face that is not convex may lie on the wrong side of the edge.
    return (editor.face(f).owner == cell ? 1.0 : -1.0) * (dot(n, g.area) > 0 ? n : g.area);
}

/// The planes in which a cell might be cut at a reflex edge: on along either face, and between.
std::vector<EdgePlane> planesAt(MeshEditor& editor, Label cell, const ReflexEdge& edge) {
    const Vec3 axis = editor.point(edge.high) - editor.point(edge.low);
    Vec3 u = normalAt(editor, edge.f, cell, edge.low, edge.high);
    Vec3 v = normalAt(editor, edge.g, cell, edge.low, edge.high);
    u = u / std::max(norm(u), 1e-300);
    v = v / std::max(norm(v), 1e-300);
    // The middle plane holds the edge and the sum of the normals, as these point out of the cell.
    const Vec3 middle = cross(axis, u + v);
    std::vector<EdgePlane> planes;
    for (const Vec3& normal : {u, v, middle}) {
        const double length = norm(normal);
        if (length > 1e-12 * norm(axis)) planes.push_back({edge.low, edge.high, normal / length});
    }
    return planes;
}

/// The edges of the two faces that are not reflex: a loop along them would cut nothing off.
EdgeList forbiddenEdges(const MeshEditor& editor,
                        const ReflexEdge& edge,
                        std::span<const ReflexEdge> reflex) {
    EdgeList edges;
    for (const Label f : {edge.f, edge.g}) {
        const Polygon& polygon = editor.face(f).points;
        Label p = polygon.back();
        for (const Label q : polygon) {
            const std::pair<Label, Label> e{std::min(p, q), std::max(p, q)};
            p = q;
            const bool isReflex =
                std::any_of(reflex.begin(), reflex.end(), [&](const ReflexEdge& r) {
                    return r.low == e.first && r.high == e.second;
                });
            if (!isReflex) edges.push_back(e);
        }
    }
    return edges;
}

struct Cut {
    CellLoop loop;
    Badness after;
};

/// Tries a cut and takes it back; the badness that it would leave, if it can be made.
std::optional<Badness>
tryCut(MeshEditor& editor, Label cell, const CellLoop& loop, std::span<const Label> region) {
    const MeshEditor::Mark mark = editor.mark();
    std::optional<Badness> after;
    const Label added = cutCell(editor, cell, loop);
    if (added >= 0 && allBalls(editor, region)) {
        std::vector<Label> all(region.begin(), region.end());
        all.push_back(added);
        after = badnessOf(editor, all);
    }
    editor.undoTo(mark);
    return after;
}

bool isBad(MeshEditor& editor, Label cell) {
    const std::array<Label, 1> one{cell};
    return badnessOf(editor, one).failures > 0;
}

} // namespace

std::vector<ReflexEdge> reflexEdges(MeshEditor& editor, Label cell, double tolerance) {
    std::vector<EdgeUse> uses;
    collectEdgeUses(editor.mesh(), cell, uses);
    std::vector<ReflexEdge> reflex;
    for (std::size_t i = 0; i + 1 < uses.size(); i += 2) {
        const EdgeUse& first = uses[i].forward ? uses[i] : uses[i + 1];
        const EdgeUse& second = uses[i].forward ? uses[i + 1] : uses[i];
        const Vec3 axis = editor.point(first.high) - editor.point(first.low);
        const Vec3 u = normalAt(editor, first.face, cell, first.low, first.high);
        const Vec3 v = normalAt(editor, second.face, cell, first.low, first.high);
        const double length = norm(axis);
        if (length <= 0) continue;
        const double turn = std::atan2(-dot(cross(u, v), axis) / length, dot(u, v));
        if (turn > tolerance)
            reflex.push_back({first.low, first.high, first.face, second.face, turn});
    }
    std::sort(reflex.begin(), reflex.end(), [](const ReflexEdge& a, const ReflexEdge& b) {
        return a.excess != b.excess ? a.excess > b.excess
                                    : std::tie(a.low, a.high) < std::tie(b.low, b.high);
    });
    return reflex;
}

Label cutAtReflexEdge(MeshEditor& editor, Label cell, double tolerance) {
    constexpr std::size_t maxEdges = 6;
    constexpr std::size_t maxFaces = 64; // beyond, the surface is too fine for the cells: no hope
    if (editor.cell(cell).faces.size() > maxFaces) return -1;
    const std::vector<ReflexEdge> reflex = reflexEdges(editor, cell, tolerance);
    if (reflex.empty()) return -1;
    const std::array<Label, 1> one{cell};
    const std::vector<Label> region = withNeighbours(editor, one);
    const Badness before = badnessOf(editor, region);
    std::optional<Cut> best;
    for (std::size_t i = 0; i < std::min(reflex.size(), maxEdges); ++i)
        for (const EdgePlane& plane : planesAt(editor, cell, reflex[i]))
            for (const double snap : {0.25, 0.05}) {
                const auto loop = findCuttingLoop(
                    editor, cell, plane, snap, forbiddenEdges(editor, reflex[i], reflex));
                if (!loop) continue;
                const auto after = tryCut(editor, cell, *loop, region);
                if (after && isBetter(*after, best ? best->after : before))
                    best = Cut{*loop, *after};
            }
    return best ? cutCell(editor, cell, best->loop) : -1;
}

SplitCounts splitConcaveCells(MeshEditor& editor, double tolerance) {
    editor.computeGeometry();
    SplitCounts counts;
    std::deque<Label> queue;
    for (Label c = 0; c < editor.cellCount(); ++c) {
        if (editor.cell(c).isRemoved() || editor.isFrozen(c) || !isBad(editor, c)) continue;
        if (reflexEdges(editor, c, tolerance).empty()) continue;
        queue.push_back(c);
        ++counts.concave;
    }
    while (!queue.empty()) {
        const Label c = queue.front();
        queue.pop_front();
        if (!isBad(editor, c)) continue;
        const Label added = cutAtReflexEdge(editor, c, tolerance);
        editor.commit();
        if (added < 0) {
            ++counts.left;
            continue;
        }
        ++counts.cuts;
        queue.push_back(c);
        queue.push_back(added);
    }
    return counts;
}

SplitCounts splitConcaveCells(EditMesh& mesh, double tolerance) {
    MeshEditor editor(mesh);
    return splitConcaveCells(editor, tolerance);
}

} // namespace polymesh
