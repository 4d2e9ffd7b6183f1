// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/possibleCuts.h"

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/cutCell.h"
#include "libpolymesh/quality/greedyLoop.h"
#include "libpolymesh/quality/polygons.h"

#include <algorithm>
#include <array>
#include <cmath>
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

/// The planes in which a cell might be cut at a reflex edge: on along either face, and last
/// half-way between; with `quarters` also between these.
std::vector<EdgePlane>
planesAt(MeshEditor& editor, Label cell, const ReflexEdge& edge, bool quarters = false) {
    const Vec3 axis = editor.point(edge.high) - editor.point(edge.low);
    Vec3 u = normalAt(editor, edge.f, cell, edge.low, edge.high);
    Vec3 v = normalAt(editor, edge.g, cell, edge.low, edge.high);
    u = u / std::max(norm(u), 1e-300);
    v = v / std::max(norm(v), 1e-300);
    // The middle plane holds the edge and the sum of the normals, as these point out of the cell.
    const Vec3 middle = cross(axis, u + v);
    std::vector<Vec3> normals{u, v};
    if (quarters && norm(middle) > 0) {
        const Vec3 towardsU = (dot(middle, u) > 0 ? 1.0 : -1.0) / norm(middle) * middle;
        normals.push_back(u + towardsU);
        normals.push_back(v - towardsU);
    }
    normals.push_back(middle);
    std::vector<EdgePlane> planes;
    for (const Vec3& normal : normals) {
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
            if (e.first == edge.low && e.second == edge.high) continue;
            const bool isReflex =
                std::any_of(reflex.begin(), reflex.end(), [&](const ReflexEdge& r) {
                    return r.low == e.first && r.high == e.second;
                });
            if (!isReflex) edges.push_back(e);
        }
    }
    return edges;
}

/// Tries a cut and takes it back; what it would leave, if it can be made.
std::optional<Cut> tryCut(MeshEditor& editor,
                          Label cell,
                          const CellCut& loops,
                          std::span<const Label> region,
                          const CutAim& aim) {
    const MeshEditor::Mark mark = editor.mark();
    std::optional<Cut> cut;
    const Label added = cutCell(editor, cell, loops);
    if (added >= 0 && editor.cellGeometry(added).volume > 0 &&
        editor.cellGeometry(cell).volume > 0) {
        std::vector<Label> all(region.begin(), region.end());
        all.push_back(added);
        cut = Cut{loops, badnessOf(editor, all), 0};
        if (aim.wantsConvex)
            cut->excess = totalExcess(editor, cell, aim.tolerance) +
                          totalExcess(editor, added, aim.tolerance);
    }
    editor.undoTo(mark);
    return cut;
}

/// What would be left of the badness of a region if a cell in it were faultless.
Badness badnessBeside(MeshEditor& editor, Label cell, std::span<const Label> region) {
    const std::array<Label, 1> one{cell};
    Badness rest = badnessOf(editor, region);
    const Badness own = badnessOf(editor, one);
    rest.invalid -= own.invalid;
    rest.failures -= own.failures;
    rest.severity -= own.severity;
    return rest;
}

/// True when two loops have the same corners, wherever they start and whichever way they run.
bool isSameLoop(const CellLoop& a, const CellLoop& b) {
    const auto isSame = [](const LoopCorner& p, const LoopCorner& q) {
        if (p.point >= 0 || q.point >= 0) return p.point == q.point;
        return p.low == q.low && p.high == q.high && p.position == q.position;
    };
    return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](const LoopCorner& p) {
               return std::any_of(
                   b.begin(), b.end(), [&](const LoopCorner& q) { return isSame(p, q); });
           });
}

/// Gathers the cuts of one cell.
class CutSearch {
public:
    CutSearch(MeshEditor& editor,
              Label cell,
              std::span<const Label> region,
              const CutAim& aim,
              WorkBudget& budget)
        : editor_(editor),
          cell_(cell),
          region_(region),
          aim_(aim),
          budget_(budget),
          finder_(editor, cell) {}

    std::vector<Cut> atReflexEdges() {
        // The sides of a round hole turn little from one to the next.
        const double tolerance = finder_.isBall() ? aim_.tolerance : 0.2 * aim_.tolerance;
        const std::size_t maxEdges = finder_.isBall() ? 6 : 12;
        const Badness rest = badnessBeside(editor_, cell_, region_);
        const std::vector<ReflexEdge> reflex = reflexEdges(editor_, cell_, tolerance);
        for (std::size_t i = 0; i < std::min(reflex.size(), maxEdges); ++i) {
            if (!tryPlanesAt(reflex[i], forbiddenEdges(editor_, reflex[i], reflex), rest))
                return std::move(cuts_);
        }
        if (aim_.wantsConvex && cuts_.empty()) tryGreedyLoops(reflex);
        return std::move(cuts_);
    }

    /// More planes at the reflex edges, then one at each edge.
    std::vector<Cut> atAllEdges() {
        for (const ReflexEdge& edge : reflexEdges(editor_, cell_, aim_.tolerance)) {
            for (const EdgePlane& plane : planesAt(editor_, cell_, edge, true))
                for (const double snap : {0.4, 0.15, 0.0})
                    if (!tryPlane(plane, snap, forbiddenEdges(editor_, edge, {})))
                        return std::move(cuts_);
        }
        const double noTolerance = -4; // [rad] no angle is excluded
        for (const ReflexEdge& edge : reflexEdges(editor_, cell_, noTolerance)) {
            const std::vector<EdgePlane> planes = planesAt(editor_, cell_, edge);
            if (planes.empty()) continue; // neither face has an area
            if (!tryPlane(planes.back(), 0.25, forbiddenEdges(editor_, edge, {}))) break;
        }
        return std::move(cuts_);
    }

private:
    bool isNew(const CellLoop& loop) {
        const bool known = std::any_of(tried_.begin(), tried_.end(), [&](const CellLoop& other) {
            return isSameLoop(loop, other);
        });
        if (!known) tried_.push_back(loop);
        return !known;
    }

    /// True when one of the cuts leaves no more than that.
    bool foundBadnessOf(const Badness& rest) const {
        return std::any_of(
            cuts_.begin(), cuts_.end(), [&](const Cut& cut) { return isNoWorse(cut.after, rest); });
    }

    /// False when the budget does not allow more, or a cut is found that leaves `rest` only and no
    /// more is asked for.
    bool tryPlanesAt(const ReflexEdge& edge, const EdgeList& forbidden, const Badness& rest) {
        for (const EdgePlane& plane : planesAt(editor_, cell_, edge))
            for (const double snap : {0.25, 0.05, 0.0}) {
                if (snap == 0 && !aim_.wantsConvex) continue;
                if (!tryPlane(plane, snap, forbidden)) return false;
                if (!aim_.wantsConvex && foundBadnessOf(rest)) return false;
            }
        return true;
    }

    /// False when the budget does not allow it.
    bool tryPlane(const EdgePlane& plane, double snap, const EdgeList& forbidden) {
        const std::size_t faces = editor_.cell(cell_).faces.size();
        if (!budget_.spend(faces)) return false;
        const auto loop = finder_.find(plane, snap, forbidden);
        if (!loop || !isNew(*loop)) return true;
        const std::vector<CellLoop> beside =
            finder_.isBall() ? std::vector<CellLoop>{} : finder_.loopsBeside(*loop);
        tryLoops({*loop});
        for (const CellLoop& other : beside) {
            if (!budget_.spend(faces)) return false;
            tryLoops({*loop, other});
        }
        return true;
    }

    /// Loops that need not lie in a plane, where no plane closes one; not in cells with so many
    /// faces that they would be dear.
    void tryGreedyLoops(const std::vector<ReflexEdge>& reflex) {
        constexpr std::size_t maxFaces = 40;
        const std::size_t faces = editor_.cell(cell_).faces.size();
        for (const ReflexEdge& edge : reflex) {
            if (faces > maxFaces || !budget_.spend(faces)) return;
            const EdgeList forbidden = forbiddenEdges(editor_, edge, reflex);
            const auto loop = greedyLoop(editor_, cell_, {edge.low, edge.high}, forbidden);
            if (loop && isNew(*loop)) tryLoops({*loop});
        }
    }

    void tryLoops(const CellCut& loops) {
        auto cut = tryCut(editor_, cell_, loops, region_, aim_);
        if (cut) cuts_.push_back(std::move(*cut));
    }

    MeshEditor& editor_;
    Label cell_;
    std::span<const Label> region_;
    const CutAim& aim_;
    WorkBudget& budget_;
    LoopFinder finder_;
    std::vector<CellLoop> tried_; // several planes may give one loop
    std::vector<Cut> cuts_;
};

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

double totalExcess(MeshEditor& editor, Label cell, double tolerance) {
    double sum = 0;
    for (const ReflexEdge& edge : reflexEdges(editor, cell, tolerance))
        sum += edge.excess;
    return sum;
}

std::vector<Cut> possibleCuts(MeshEditor& editor,
                              Label cell,
                              std::span<const Label> region,
                              const CutAim& aim,
                              WorkBudget& budget) {
    return CutSearch(editor, cell, region, aim, budget).atReflexEdges();
}

std::vector<Cut>
halvingCuts(MeshEditor& editor, Label cell, std::span<const Label> region, WorkBudget& budget) {
    constexpr std::size_t maxFaces = 40; // the number of edges to try grows with the faces
    constexpr double tolerance = 0.05;   // [rad]
    if (editor.cell(cell).faces.size() > maxFaces) return {};
    return CutSearch(editor, cell, region, {tolerance, false}, budget).atAllEdges();
}

} // namespace polymesh
