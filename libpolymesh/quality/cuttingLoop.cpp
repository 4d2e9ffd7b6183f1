// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// findCuttingLoop: the corners that the plane makes on the cell, the steps between them, and the
// shortest walk round.
#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/cutCell.h"
#include "libpolymesh/quality/polygons.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polymesh {

namespace {

/// A step between two corners, by position in the list of corners.
struct Step {
    std::size_t from = 0;
    std::size_t to = 0;
    Label face = -1; // to be cut; -1: along an edge
};

class LoopFinder {
public:
    LoopFinder(MeshEditor& editor, Label cell, const EdgePlane& plane)
        : editor_(editor), cell_(cell), plane_(plane), size_(editor.cell(cell).size) {
        collectEdgeUses(editor.mesh(), cell, uses_);
        for (const EdgeUse& use : uses_) {
            addPoint(use.low);
            addPoint(use.high);
        }
    }

    std::optional<CellLoop> find(double snap, const EdgeList& forbidden) {
        snapPoints(snap);
        addCrossings();
        addEdgeSteps(forbidden);
        for (const Label f : editor_.cell(cell_).faces)
            addFaceSteps(f);
        return shortestLoop();
    }

private:
    struct CellPoint {
        Label point = -1;
        double offPlane = 0;
        bool onPlane = false;
    };

    void addPoint(Label p) {
        if (find(p)) return;
        const double d = dot(plane_.normal, editor_.point(p) - editor_.point(plane_.a));
        const bool on = p == plane_.a || p == plane_.b || std::abs(d) < 1e-6 * size_;
        points_.push_back({p, d, on});
    }

    CellPoint* find(Label p) {
        for (CellPoint& candidate : points_)
            if (candidate.point == p) return &candidate;
        return nullptr;
    }

    /// Calls body for the first use of each edge.
    template<class Body>
    void forEachEdge(Body&& body) {
        for (std::size_t i = 0; i + 1 < uses_.size(); i += 2)
            body(uses_[i].low, uses_[i].high);
    }

    bool isCrossed(Label low, Label high) {
        const CellPoint* a = find(low);
        const CellPoint* b = find(high);
        return !a->onPlane && !b->onPlane && (a->offPlane > 0) != (b->offPlane > 0);
    }

    double crossingWeight(Label low, Label high) {
        const double a = find(low)->offPlane;
        return a / (a - find(high)->offPlane);
    }

    bool isFixedEdge(Label low, Label high) const {
        return editor_.rank(low) == PointRank::fixed && editor_.rank(high) == PointRank::fixed;
    }

    void snapPoints(double snap) {
        std::vector<Label> near;
        forEachEdge([&](Label low, Label high) {
            if (!isCrossed(low, high)) return;
            const double weight = crossingWeight(low, high);
            const double limit = isFixedEdge(low, high) ? 0.5 : snap;
            if (weight <= limit) near.push_back(low);
            if (weight >= 1 - limit) near.push_back(high);
        });
        for (const Label p : near)
            find(p)->onPlane = true;
    }

    void addCrossings() {
        for (const CellPoint& point : points_)
            if (point.onPlane)
                corners_.push_back(
                    {point.point, -1, -1, editor_.point(point.point), point.offPlane, -1});
        forEachEdge([&](Label low, Label high) {
            if (!isCrossed(low, high)) return;
            const double w = crossingWeight(low, high);
            const Vec3 position = (1 - w) * editor_.point(low) + w * editor_.point(high);
            corners_.push_back({-1, low, high, position, 0, -1});
        });
    }

    std::size_t cornerAt(Label p) const {
        std::size_t i = 0;
        while (i < corners_.size() && corners_[i].point != p)
            ++i;
        return i;
    }

    std::size_t cornerOn(Label p, Label q) const {
        std::size_t i = 0;
        while (i < corners_.size() &&
               (corners_[i].low != std::min(p, q) || corners_[i].high != std::max(p, q)))
            ++i;
        return i;
    }

    void addEdgeSteps(const EdgeList& forbidden) {
        forEachEdge([&](Label low, Label high) {
            if (!find(low)->onPlane || !find(high)->onPlane) return;
            const std::pair<Label, Label> edge{low, high};
            if (std::find(forbidden.begin(), forbidden.end(), edge) != forbidden.end()) return;
            const bool start =
                std::min(plane_.a, plane_.b) == low && std::max(plane_.a, plane_.b) == high;
            if (!start) steps_.push_back({cornerAt(low), cornerAt(high), -1});
        });
    }

    /// Steps across a face: between corners that follow each other along the line in which the
    /// plane cuts the face, where the face is between them.
    void addFaceSteps(Label f) {
        if (editor_.isFrozenFace(f)) return;
        const Polygon polygon = editor_.face(f).points;
        const Vec3 normal = editor_.faceGeometry(f).area;
        const Vec3 line = cross(plane_.normal, normal);
        std::vector<std::pair<double, std::size_t>> onFace;
        std::size_t pointCount = 0;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Label p = polygon[i];
            for (const std::size_t corner :
                 {cornerAt(p), cornerOn(p, polygon[(i + 1) % polygon.size()])})
                if (corner < corners_.size())
                    onFace.emplace_back(dot(line, corners_[corner].position), corner);
            pointCount += find(p)->onPlane;
        }
        if (pointCount == polygon.size()) return;
        std::sort(onFace.begin(), onFace.end());
        for (std::size_t i = 0; i + 1 < onFace.size(); ++i) {
            const LoopCorner& a = corners_[onFace[i].second];
            const LoopCorner& b = corners_[onFace[i + 1].second];
            if (onOneEdge(polygon, a, b)) continue;
            if (isInside(polygon, normal, 0.5 * (a.position + b.position)))
                steps_.push_back({onFace[i].second, onFace[i + 1].second, f});
        }
    }

    static bool onOneEdge(const Polygon& polygon, const LoopCorner& a, const LoopCorner& b) {
        if (a.point >= 0 && b.point >= 0) return hasEdge(polygon, a.point, b.point);
        if (a.point >= 0) return a.point == b.low || a.point == b.high;
        if (b.point >= 0) return b.point == a.low || b.point == a.high;
        return false;
    }

    bool isInside(const Polygon& polygon, const Vec3& normal, const Vec3& p) const {
        int drop = 0;
        for (int axis = 1; axis < 3; ++axis)
            if (std::abs(normal[axis]) > std::abs(normal[drop])) drop = axis;
        const int u = (drop + 1) % 3;
        const int v = (drop + 2) % 3;
        bool inside = false;
        Vec3 a = editor_.point(polygon.back());
        for (const Label corner : polygon) {
            const Vec3 b = editor_.point(corner);
            if ((a[v] > p[v]) != (b[v] > p[v]) &&
                p[u] < a[u] + (b[u] - a[u]) * (p[v] - a[v]) / (b[v] - a[v]))
                inside = !inside;
            a = b;
        }
        return inside;
    }

    double weightOf(std::size_t corner) const {
        constexpr double outOfPlane = 10;
        return 1 + outOfPlane * std::abs(corners_[corner].offPlane) / size_;
    }

    /// Dijkstra's search from b back to a over the steps; few corners, so no queue is needed.
    std::optional<CellLoop> shortestLoop() const {
        constexpr double far = std::numeric_limits<double>::infinity();
        const std::size_t start = cornerAt(plane_.b);
        const std::size_t goal = cornerAt(plane_.a);
        std::vector<double> distance(corners_.size(), far);
        std::vector<std::size_t> stepTo(corners_.size(), 0);
        std::vector<bool> done(corners_.size(), false);
        distance[start] = 0;
        while (true) {
            std::size_t at = corners_.size();
            for (std::size_t i = 0; i < corners_.size(); ++i)
                if (!done[i] && distance[i] < far &&
                    (at == corners_.size() || distance[i] < distance[at]))
                    at = i;
            if (at == corners_.size() || at == goal) break;
            done[at] = true;
            for (std::size_t s = 0; s < steps_.size(); ++s) {
                if (steps_[s].from != at && steps_[s].to != at) continue;
                const std::size_t other = steps_[s].from == at ? steps_[s].to : steps_[s].from;
                if (distance[at] + weightOf(other) >= distance[other]) continue;
                distance[other] = distance[at] + weightOf(other);
                stepTo[other] = s;
            }
        }
        if (!(distance[goal] < far)) return std::nullopt;
        return walkBack(start, goal, stepTo);
    }

    /// The loop from a, against the search to b, and back along the edge.
    CellLoop
    walkBack(std::size_t start, std::size_t goal, const std::vector<std::size_t>& stepTo) const {
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

    MeshEditor& editor_;
    Label cell_;
    EdgePlane plane_;
    double size_;
    std::vector<EdgeUse> uses_;
    std::vector<CellPoint> points_;
    std::vector<LoopCorner> corners_;
    std::vector<Step> steps_;
};

} // namespace

std::optional<CellLoop> findCuttingLoop(MeshEditor& editor,
                                        Label cell,
                                        const EdgePlane& plane,
                                        double snap,
                                        const EdgeList& forbidden) {
    return LoopFinder(editor, cell, plane).find(snap, forbidden);
}

} // namespace polymesh
