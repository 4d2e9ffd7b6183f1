// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/projectBoundary.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/surface/boxTree.h"
#include "libpolymesh/surface/distance.h"
#include "libpolymesh/surface/features.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace polymesh {

namespace {

struct Segment {
    Vec3 a;
    Vec3 b;
};

Vec3 closestOn(const Segment& s, const Vec3& p) {
    const Vec3 along = s.b - s.a;
    const double length2 = squaredNorm(along);
    if (length2 == 0) return s.a;
    return s.a + std::clamp(dot(p - s.a, along) / length2, 0.0, 1.0) * along;
}

std::vector<Segment> featureSegments(const TriSurface& surface, double featureAngle) {
    const SurfaceEdges edges = pairEdges(surface);
    const SurfaceFeatures features = findFeatures(surface, edges, featureAngle);
    std::vector<Segment> segments;
    for (std::size_t e = 0; e < edges.edges.size(); ++e)
        if (features.isFeature[e] != 0)
            segments.push_back({surface.points[index(edges.edges[e].start)],
                                surface.points[index(edges.edges[e].end)]});
    return segments;
}

std::vector<Box> boxesOf(std::span<const Segment> segments) {
    std::vector<Box> boxes(segments.size());
    for (std::size_t s = 0; s < segments.size(); ++s) {
        boxes[s].add(segments[s].a);
        boxes[s].add(segments[s].b);
    }
    return boxes;
}

/// A new point on the boundary: where it belongs and how far it may go.
struct Target {
    Label point = -1;
    double reach = 0; // [m]
    bool isFeature = false;
    Vec3 before;
    bool isMoved = false;
};

/// One use of a boundary edge by a face.
struct EdgeUse {
    Label edge;
    Label face;
    Label patch;
};

std::vector<EdgeUse> boundaryEdgeUses(const PolyMesh& mesh, const SubdivisionPlan& plan) {
    std::vector<EdgeUse> uses;
    for (std::size_t p = 0; p < mesh.patches.size(); ++p)
        for (Label f = mesh.patches[p].start; f < mesh.patches[p].start + mesh.patches[p].size; ++f)
            for (Label i = mesh.faces.offsets[index(f)]; i < mesh.faces.offsets[index(f) + 1]; ++i)
                uses.push_back({plan.edges.ofCorner[index(i)], f, toLabel(p)});
    std::ranges::sort(uses, [](const EdgeUse& a, const EdgeUse& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.face < b.face;
    });
    return uses;
}

std::vector<Target>
targetsOf(const PolyMesh& mesh, const SubdivisionPlan& plan, double featureAngle) {
    std::vector<Target> targets;
    const std::vector<EdgeUse> uses = boundaryEdgeUses(mesh, plan);
    const auto normal = [&](Label face) {
        return faceGeometry(mesh.points, mesh.faces[face]).area;
    };
    for (std::size_t i = 0; i < uses.size();) {
        std::size_t end = i;
        while (end < uses.size() && uses[end].edge == uses[i].edge)
            ++end;
        const auto [a, b] = plan.edges.points[index(uses[i].edge)];
        bool isFeature = end - i != 2 || uses[i].patch != uses[i + 1].patch;
        if (!isFeature) {
            const Vec3 n = normal(uses[i].face);
            const Vec3 m = normal(uses[i + 1].face);
            isFeature = dot(n, m) < std::cos(featureAngle) * norm(n) * norm(m);
        }
        targets.push_back({plan.layout.firstEdge + uses[i].edge,
                           0.25 * norm(mesh.points[index(a)] - mesh.points[index(b)]),
                           isFeature,
                           {},
                           false});
        i = end;
    }
    for (Label face = mesh.internalFaceCount(); face < mesh.faceCount(); ++face)
        targets.push_back(
            {plan.layout.firstFace + face, 0.5 * std::sqrt(norm(normal(face))), false, {}, false});
    return targets;
}

/// Cells that have a point which is marked.
std::vector<Label>
cellsWith(const PolyMesh& mesh, const SubdivisionPlan& plan, const std::vector<char>& isMarked) {
    std::vector<char> isIn(index(mesh.cellCount), 0);
    parallelFor(mesh.cellCount, [&](Label cell) {
        for (const Label face : plan.cellFaces[cell]) {
            bool hasMark = isMarked[index(plan.layout.firstFace + face)] != 0;
            for (Label i = mesh.faces.offsets[index(face)]; i < mesh.faces.offsets[index(face) + 1];
                 ++i)
                hasMark =
                    hasMark ||
                    isMarked[index(plan.layout.firstEdge + plan.edges.ofCorner[index(i)])] != 0;
            if (hasMark) isIn[index(cell)] = 1;
        }
    });
    std::vector<Label> cells;
    for (Label cell = 0; cell < mesh.cellCount; ++cell)
        if (isIn[index(cell)] != 0 && !std::ranges::binary_search(plan.inverted, cell))
            cells.push_back(cell);
    return cells;
}

void moveAll(SubdivisionPlan& plan,
             const TriSurface& surface,
             double featureAngle,
             std::vector<Target>& targets) {
    const SurfaceTree tree(surface);
    const std::vector<Segment> segments = featureSegments(surface, featureAngle);
    const BoxTree segmentTree(boxesOf(segments));
    parallelFor(toLabel(targets.size()), [&](Label i) {
        Target& target = targets[index(i)];
        target.before = plan.points[index(target.point)];
        std::optional<Vec3> place;
        if (target.isFeature) {
            double best = Box::inf;
            segmentTree.searchNearest(target.before, [&](Label s) {
                const Vec3 on = closestOn(segments[index(s)], target.before);
                const double d = squaredNorm(on - target.before);
                if (d < best) place = on;
                best = std::min(best, d);
                return d;
            });
        }
        const bool isNear = place && norm(*place - target.before) <= target.reach;
        if (!isNear) {
            target.isFeature = false;
            place = tree.closest(target.before).point;
        }
        if (norm(*place - target.before) > target.reach || *place == target.before) return;
        plan.points[index(target.point)] = *place;
        target.isMoved = true;
    });
}

/// Takes points of cells with inverted parts back until there are none.
void takeBack(const PolyMesh& mesh, SubdivisionPlan& plan, std::vector<Target>& targets) {
    std::vector<char> isMarked(plan.points.size(), 0);
    for (const Target& target : targets)
        isMarked[index(target.point)] = target.isMoved ? 1 : 0;
    std::vector<Label> cells = cellsWith(mesh, plan, isMarked);
    for (;;) {
        const std::vector<Label> bad = invertedCells(mesh, plan, cells);
        if (bad.empty()) return;
        std::vector<char> isBad(plan.points.size(), 0);
        for (const Label cell : bad)
            for (const Label face : plan.cellFaces[cell]) {
                isBad[index(plan.layout.firstFace + face)] = 1;
                for (Label i = mesh.faces.offsets[index(face)];
                     i < mesh.faces.offsets[index(face) + 1];
                     ++i)
                    isBad[index(plan.layout.firstEdge + plan.edges.ofCorner[index(i)])] = 1;
            }
        bool isChanged = false;
        for (Target& target : targets) {
            if (!target.isMoved || isBad[index(target.point)] == 0) continue;
            plan.points[index(target.point)] = target.before;
            target.isMoved = false;
            isChanged = true;
        }
        if (!isChanged) return;
    }
}

} // namespace

ProjectionCounts projectBoundary(const PolyMesh& mesh,
                                 SubdivisionPlan& plan,
                                 const TriSurface& surface,
                                 double featureAngle) {
    std::vector<Target> targets = targetsOf(mesh, plan, featureAngle);
    moveAll(plan, surface, featureAngle, targets);
    std::vector<char> wasMoved;
    wasMoved.reserve(targets.size());
    for (const Target& target : targets)
        wasMoved.push_back(target.isMoved ? 1 : 0);
    takeBack(mesh, plan, targets);
    ProjectionCounts counts;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const Target& target = targets[i];
        counts.moved += target.isMoved ? 1 : 0;
        counts.onFeatures += target.isMoved && target.isFeature ? 1 : 0;
        counts.refused += wasMoved[i] != 0 && !target.isMoved ? 1 : 0;
        if (target.isMoved)
            counts.largestMove = std::max(counts.largestMove,
                                          norm(plan.points[index(target.point)] - target.before));
    }
    return counts;
}

} // namespace polymesh
