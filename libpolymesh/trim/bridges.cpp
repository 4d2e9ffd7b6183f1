// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/bridges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace polymesh {

namespace {

struct Point2 {
    double x;
    double y;
};

/// Projection along the largest component of the normal, keeping the turning sense.
class Plane {
public:
    Plane(const std::vector<Vec3>& positions, const Vec3& normal) : positions_(positions) {
        const std::array<double, 3> n{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
        axis_ = static_cast<int>(std::ranges::max_element(n) - n.begin());
        turn_ = normal[axis_] < 0 ? -1 : 1;
    }

    Point2 operator()(Label point) const {
        const Vec3& p = positions_[index(point)];
        return {turn_ * p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]};
    }

private:
    const std::vector<Vec3>& positions_;
    int axis_ = 0;
    double turn_ = 1;
};

double turn(const Point2& a, const Point2& b, const Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double area(const Plane& plane, const LoopPolygon& loop) {
    const Point2 a = plane(loop[0]);
    double sum = 0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        sum += turn(a, plane(loop[i]), plane(loop[i + 1]));
    return 0.5 * sum;
}

bool contains(const Plane& plane, const LoopPolygon& loop, const Point2& p) {
    bool isInside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point2 a = plane(loop[i]);
        const Point2 b = plane(loop[(i + 1) % loop.size()]);
        if ((a.y > p.y) != (b.y > p.y) && (turn(a, b, p) > 0) == (b.y > a.y)) isInside = !isInside;
    }
    return isInside;
}

bool doCross(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

bool crossesLoop(const Plane& plane, const LoopPolygon& loop, Label from, Label to) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Label a = loop[i];
        const Label b = loop[(i + 1) % loop.size()];
        if (a == from || a == to || b == from || b == to) continue;
        if (doCross(plane(from), plane(to), plane(a), plane(b))) return true;
    }
    return false;
}

struct Bridge {
    std::size_t outer = 0;
    std::size_t hole = 0;
    double length = std::numeric_limits<double>::infinity();
};

/// The shortest bridge that crosses neither loop nor `first`, with ends other than those of
/// `first`; the shortest of all where none is free.
Bridge findBridge(const Plane& plane,
                  const LoopPolygon& outer,
                  const LoopPolygon& hole,
                  const Bridge* first) {
    Bridge best;
    Bridge fallback;
    for (std::size_t i = 0; i < outer.size(); ++i)
        for (std::size_t j = 0; j < hole.size(); ++j) {
            if (first != nullptr && (first->outer == i || first->hole == j)) continue;
            const Point2 a = plane(outer[i]);
            const Point2 b = plane(hole[j]);
            const double length = std::hypot(a.x - b.x, a.y - b.y);
            if (length < fallback.length) fallback = {i, j, length};
            if (length >= best.length) continue;
            if (crossesLoop(plane, outer, outer[i], hole[j]) ||
                crossesLoop(plane, hole, outer[i], hole[j]))
                continue;
            if (first != nullptr &&
                doCross(a, b, plane(outer[first->outer]), plane(hole[first->hole])))
                continue;
            best = {i, j, length};
        }
    return std::isfinite(best.length) ? best : fallback;
}

void addPart(const LoopPolygon& loop, std::size_t first, std::size_t last, LoopPolygon& polygon) {
    for (std::size_t i = first;; i = (i + 1) % loop.size()) {
        polygon.push_back(loop[i]);
        if (i == last) return;
    }
}

/// Cuts the polygon with a hole into two along two bridges.
std::array<LoopPolygon, 2> cutOpen(const Plane& plane,
                                   const LoopPolygon& outer,
                                   const LoopPolygon& hole,
                                   std::vector<Label>& needed) {
    const Bridge a = findBridge(plane, outer, hole, nullptr);
    const Bridge b = findBridge(plane, outer, hole, &a);
    std::array<LoopPolygon, 2> parts;
    addPart(outer, a.outer, b.outer, parts[0]);
    addPart(hole, b.hole, a.hole, parts[0]);
    addPart(outer, b.outer, a.outer, parts[1]);
    addPart(hole, a.hole, b.hole, parts[1]);
    for (const Bridge& bridge : {a, b}) {
        needed.push_back(outer[bridge.outer]);
        needed.push_back(hole[bridge.hole]);
    }
    return parts;
}

/// The polygon that holds the hole: the smallest of those round its first point.
std::size_t
holderOf(const Plane& plane, const std::vector<LoopPolygon>& polygons, const LoopPolygon& hole) {
    std::size_t best = 0;
    double bestArea = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const double size = area(plane, polygons[i]);
        if (size < bestArea && contains(plane, polygons[i], plane(hole[0]))) {
            best = i;
            bestArea = size;
        }
    }
    return best;
}

/// Three points of a closed loop that hold it open: two far from each other and the one farthest
/// from the line between them. Without them a narrow loop could be simplified to a line.
void keepOpen(const std::vector<Vec3>& positions,
              const LoopPolygon& loop,
              std::vector<Label>& needed) {
    const auto farthest = [&](auto&& distance) {
        return *std::max_element(loop.begin(), loop.end(), [&](Label p, Label q) {
            return distance(positions[index(p)]) < distance(positions[index(q)]);
        });
    };
    const Vec3& start = positions[index(loop[0])];
    const Label a = farthest([&](const Vec3& p) { return squaredNorm(p - start); });
    const Vec3& atA = positions[index(a)];
    const Label b = farthest([&](const Vec3& p) { return squaredNorm(p - atA); });
    const Vec3& atB = positions[index(b)];
    const Label c = farthest([&](const Vec3& p) { return squaredNorm(cross(p - atA, p - atB)); });
    needed.insert(needed.end(), {a, b, c});
}

} // namespace

Label openHoles(const std::vector<Vec3>& positions,
                const Vec3& normal,
                CurvesOnFace& curves,
                std::vector<Label>& needed) {
    auto& [polygons, closed, isPlainOutline] = curves;
    if (closed.empty()) return 0;
    const Plane plane(positions, normal);
    const bool isSurelyHole = isPlainOutline && closed.size() == 1;
    const bool isSurelyIsland = polygons.empty() && closed.size() == 1;
    std::vector<LoopPolygon> holes;
    for (LoopPolygon& loop : closed) {
        keepOpen(positions, loop, needed);
        const bool isHole = isSurelyHole || (!isSurelyIsland && area(plane, loop) < 0);
        (isHole ? holes : polygons).push_back(std::move(loop));
    }
    for (const LoopPolygon& hole : holes) {
        if (polygons.empty() || hole.size() < 3) { // without size: keep its edges as they are
            polygons.push_back(hole);
            continue;
        }
        const std::size_t holder = holderOf(plane, polygons, hole);
        auto parts = cutOpen(plane, polygons[holder], hole, needed);
        polygons[holder] = std::move(parts[0]);
        polygons.push_back(std::move(parts[1]));
    }
    return toLabel(holes.size());
}

} // namespace polymesh
