// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// LoopFinder: the corners that the plane makes on the cell, the steps between them, and the
// shortest walk round.
#include "libpolymesh/quality/cuttingLoop.h"

#include "libpolymesh/quality/polygons.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polymesh {

namespace {

bool onOneEdge(const Polygon& polygon, const LoopCorner& a, const LoopCorner& b) {
    if (a.point >= 0 && b.point >= 0) return hasEdge(polygon, a.point, b.point);
    if (a.point >= 0) return a.point == b.low || a.point == b.high;
    if (b.point >= 0) return b.point == a.low || b.point == a.high;
    return false;
}

} // namespace

bool isInsidePolygon(const MeshEditor& editor,
                     const Polygon& polygon,
                     const Vec3& normal,
                     const Vec3& p) {
    int drop = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(normal[axis]) > std::abs(normal[drop])) drop = axis;
    const int u = (drop + 1) % 3;
    const int v = (drop + 2) % 3;
    bool inside = false;
    Vec3 a = editor.point(polygon.back());
    for (const Label corner : polygon) {
        const Vec3 b = editor.point(corner);
        if ((a[v] > p[v]) != (b[v] > p[v]) &&
            p[u] < a[u] + (b[u] - a[u]) * (p[v] - a[v]) / (b[v] - a[v]))
            inside = !inside;
        a = b;
    }
    return inside;
}

LoopFinder::LoopFinder(MeshEditor& editor, Label cell)
    : editor_(editor), cell_(cell), size_(editor.cell(cell).size) {
    thread_local std::vector<std::pair<Label, Label>> edges;
    thread_local std::vector<Label> points;
    edges.clear();
    points.clear();
    for (const Label f : editor.cell(cell).faces) {
        Label a = editor.face(f).points.back();
        for (const Label b : editor.face(f).points) {
            points.push_back(b);
            edges.push_back(std::minmax({a, b}));
            a = b;
        }
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const Label p : points)
        points_.push_back({p, 0, false, 0});
    for (const auto& [low, high] : edges)
        edges_.push_back({placeOf(low), placeOf(high), false, 0});
    isBall_ = points_.size() + editor.cell(cell).faces.size() == edges_.size() + 2;
}

std::optional<CellLoop>
LoopFinder::find(const EdgePlane& plane, double snap, const EdgeList& forbidden) {
    plane_ = plane;
    corners_.clear();
    steps_.clear();
    placePlane(snap);
    addCorners();
    addEdgeSteps(forbidden);
    for (const Label f : editor_.cell(cell_).faces)
        addFaceSteps(f);
    const std::size_t start = points_[placeOf(plane_.b)].corner;
    const std::size_t goal = points_[placeOf(plane_.a)].corner;
    return shortestWay(start, goal, std::vector<bool>(corners_.size(), false));
}

std::vector<CellLoop> LoopFinder::loopsBeside(const CellLoop& found) const {
    std::vector<bool> taken(corners_.size(), false);
    const auto take = [&](const CellLoop& loop) {
        for (const LoopCorner& corner : loop)
            for (std::size_t i = 0; i < corners_.size(); ++i)
                if (corners_[i].point == corner.point && corners_[i].low == corner.low &&
                    corners_[i].high == corner.high)
                    taken[i] = true;
    };
    take(found);
    constexpr std::size_t maxLoops = 8;
    std::vector<CellLoop> loops;
    for (const Step& step : steps_) {
        if (loops.size() == maxLoops) break;
        if (step.face < 0 || taken[step.from] || taken[step.to]) continue;
        auto loop = shortestWay(step.from, step.to, taken);
        if (!loop || loop->size() < 3) continue;
        loop->back().faceToNext = step.face;
        take(*loop);
        loops.push_back(std::move(*loop));
    }
    return loops;
}

std::size_t LoopFinder::placeOf(Label p) const {
    const auto found = std::lower_bound(
        points_.begin(), points_.end(), p, [](const CellPoint& a, Label b) { return a.point < b; });
    return static_cast<std::size_t>(found - points_.begin());
}

const LoopFinder::CellEdge& LoopFinder::edgeOf(Label p, Label q) const {
    const std::pair<std::size_t, std::size_t> ends{placeOf(std::min(p, q)),
                                                   placeOf(std::max(p, q))};
    return *std::lower_bound(edges_.begin(), edges_.end(), ends, [](const CellEdge& a, auto b) {
        return std::pair{a.low, a.high} < b;
    });
}

double LoopFinder::crossingWeight(const CellEdge& edge) const {
    const double a = points_[edge.low].offPlane;
    return a / (a - points_[edge.high].offPlane);
}

/// Which points are on the plane and which edges it crosses.
void LoopFinder::placePlane(double snap) {
    const Vec3 origin = editor_.point(plane_.a);
    for (CellPoint& p : points_) {
        p.offPlane = dot(plane_.normal, editor_.point(p.point) - origin);
        p.onPlane =
            p.point == plane_.a || p.point == plane_.b || std::abs(p.offPlane) < 1e-6 * size_;
    }
    const auto isFixed = [&](std::size_t p) {
        return editor_.rank(points_[p].point) == PointRank::fixed;
    };
    const auto isCrossed = [&](const CellEdge& edge) {
        const CellPoint& a = points_[edge.low];
        const CellPoint& b = points_[edge.high];
        return !a.onPlane && !b.onPlane && (a.offPlane > 0) != (b.offPlane > 0);
    };
    for (CellEdge& edge : edges_)
        edge.isCrossed = isCrossed(edge);
    for (const CellEdge& edge : edges_) {
        if (!edge.isCrossed) continue;
        const double weight = crossingWeight(edge);
        const double limit = isFixed(edge.low) && isFixed(edge.high) ? 0.5 : snap;
        if (weight <= limit) points_[edge.low].onPlane = true;
        if (weight >= 1 - limit) points_[edge.high].onPlane = true;
    }
    for (CellEdge& edge : edges_)
        edge.isCrossed = isCrossed(edge);
}

void LoopFinder::addCorners() {
    for (CellPoint& p : points_) {
        if (!p.onPlane) continue;
        p.corner = corners_.size();
        corners_.push_back({p.point, -1, -1, editor_.point(p.point), p.offPlane, -1});
    }
    for (CellEdge& edge : edges_) {
        if (!edge.isCrossed) continue;
        edge.corner = corners_.size();
        const Label low = points_[edge.low].point;
        const Label high = points_[edge.high].point;
        const double w = crossingWeight(edge);
        const Vec3 position = (1 - w) * editor_.point(low) + w * editor_.point(high);
        corners_.push_back({-1, low, high, position, 0, -1});
    }
}

void LoopFinder::addEdgeSteps(const EdgeList& forbidden) {
    for (const CellEdge& e : edges_) {
        const CellPoint& low = points_[e.low];
        const CellPoint& high = points_[e.high];
        if (!low.onPlane || !high.onPlane) continue;
        const std::pair<Label, Label> edge{low.point, high.point};
        if (edge == std::pair<Label, Label>(std::minmax({plane_.a, plane_.b}))) continue;
        if (std::find(forbidden.begin(), forbidden.end(), edge) != forbidden.end()) continue;
        steps_.push_back({low.corner, high.corner, -1});
    }
}

/// Steps across a face: between corners that follow each other along the line in which the plane
/// cuts the face, where the face is between them.
void LoopFinder::addFaceSteps(Label f) {
    if (editor_.isFrozenFace(f)) return;
    const Polygon& polygon = editor_.face(f).points;
    const Vec3 normal = editor_.faceGeometry(f).area;
    const Vec3 line = cross(plane_.normal, normal);
    boost::container::small_vector<std::pair<double, std::size_t>, 8> onFace;
    std::size_t pointCount = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Label next = polygon[(i + 1) % polygon.size()];
        const CellPoint& p = points_[placeOf(polygon[i])];
        const CellEdge& edge = edgeOf(polygon[i], next);
        if (p.onPlane) onFace.emplace_back(dot(line, corners_[p.corner].position), p.corner);
        if (edge.isCrossed)
            onFace.emplace_back(dot(line, corners_[edge.corner].position), edge.corner);
        pointCount += p.onPlane;
    }
    if (pointCount == polygon.size()) return;
    std::sort(onFace.begin(), onFace.end());
    for (std::size_t i = 0; i + 1 < onFace.size(); ++i) {
        const LoopCorner& a = corners_[onFace[i].second];
        const LoopCorner& b = corners_[onFace[i + 1].second];
        if (onOneEdge(polygon, a, b)) continue;
        if (isInsidePolygon(editor_, polygon, normal, 0.5 * (a.position + b.position)))
            steps_.push_back({onFace[i].second, onFace[i + 1].second, f});
    }
}

double LoopFinder::weightOf(std::size_t corner) const {
    constexpr double outOfPlane = 10;
    return 1 + outOfPlane * std::abs(corners_[corner].offPlane) / size_;
}

namespace {

/// The place of the least distance that is not done; the number of places when there is none.
std::size_t nearestOf(const std::vector<double>& distance, const std::vector<bool>& done) {
    std::size_t nearest = distance.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < distance.size(); ++i)
        if (!done[i] && distance[i] < least) {
            nearest = i;
            least = distance[i];
        }
    return nearest;
}

} // namespace

/// Dijkstra's search from `start` back to `goal` over the steps, without the step that joins them
/// and corners that are taken; few corners, so no queue is needed.
std::optional<CellLoop>
LoopFinder::shortestWay(std::size_t start, std::size_t goal, const std::vector<bool>& taken) const {
    constexpr double far = std::numeric_limits<double>::infinity();
    std::vector<double> distance(corners_.size(), far);
    std::vector<std::size_t> stepTo(corners_.size(), 0);
    std::vector<bool> done = taken;
    distance[start] = 0;
    while (true) {
        const std::size_t at = nearestOf(distance, done);
        if (at == corners_.size() || at == goal) break;
        done[at] = true;
        for (std::size_t s = 0; s < steps_.size(); ++s) {
            if (steps_[s].from != at && steps_[s].to != at) continue;
            const std::size_t other = steps_[s].from == at ? steps_[s].to : steps_[s].from;
            if (taken[other] || (at == start && other == goal)) continue;
            if (distance[at] + weightOf(other) >= distance[other]) continue;
            distance[other] = distance[at] + weightOf(other);
            stepTo[other] = s;
        }
    }
    if (!(distance[goal] < far)) return std::nullopt;
    return walkBack(start, goal, stepTo);
}

/// The loop from a, against the search to b, and back along the edge.
CellLoop LoopFinder::walkBack(std::size_t start,
                              std::size_t goal,
                              const std::vector<std::size_t>& stepTo) const {
    CellLoop loop;
    for (std::size_t at = goal; at != start;) {
        const Step& step = steps_[stepTo[at]];
        loop.push_back(corners_[at]);
        loop.back().faceToNext = step.face;
        at = step.from == at ? step.to : step.from;
    }
    loop.push_back(corners_[start]);
    return loop;
}

std::optional<CellLoop> findCuttingLoop(MeshEditor& editor,
                                        Label cell,
                                        const EdgePlane& plane,
                                        double snap,
                                        const EdgeList& forbidden) {
    return LoopFinder(editor, cell).find(plane, snap, forbidden);
}

} // namespace polymesh
