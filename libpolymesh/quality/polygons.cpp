// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/polygons.h"

#include <algorithm>

namespace polymesh {

namespace {

std::size_t positionOf(const Polygon& polygon, Label p) {
    return static_cast<std::size_t>(std::find(polygon.begin(), polygon.end(), p) - polygon.begin());
}

} // namespace

std::vector<Polygon> simpleLoops(const Polygon& walk) {
    std::vector<Polygon> loops;
    Polygon open;
    for (const Label p : walk) {
        const std::size_t at = positionOf(open, p);
        if (at < open.size()) {
            if (open.size() - at >= 3)
                loops.emplace_back(open.begin() + static_cast<std::ptrdiff_t>(at), open.end());
            open.resize(at);
        }
        open.push_back(p);
    }
    if (open.size() >= 3) loops.push_back(open);
    return loops;
}

bool hasPoint(const Polygon& polygon, Label p) {
    return std::find(polygon.begin(), polygon.end(), p) != polygon.end();
}

Label cornerAfter(const Polygon& polygon, Label p) {
    return polygon[(positionOf(polygon, p) + 1) % polygon.size()];
}

Label cornerBefore(const Polygon& polygon, Label p) {
    return polygon[(positionOf(polygon, p) + polygon.size() - 1) % polygon.size()];
}

bool hasEdge(const Polygon& polygon, Label a, Label b) {
    return hasPoint(polygon, a) && (cornerAfter(polygon, a) == b || cornerBefore(polygon, a) == b);
}

Polygon unitedPolygon(const Polygon& a, const Polygon& b) {
    const std::size_t n = a.size();
    // shared[i]: the edge from corner i of a is run backward by b
    const auto isShared = [&](std::size_t i) {
        const Label from = a[i % n];
        const Label to = a[(i + 1) % n];
        return hasPoint(b, to) && cornerAfter(b, to) == from;
    };
    std::size_t first = 0;
    while (first < n && !(isShared(first) && !isShared(first + n - 1)))
        ++first;
    if (first == n) return {}; // none shared, or all
    std::size_t last = first + 1;
    while (isShared(last))
        ++last;
    Polygon united;
    for (std::size_t i = last; i <= first + n; ++i) // from the end of the path round to its start
        united.push_back(a[i % n]);
    const std::size_t start = positionOf(b, a[first]);
    for (std::size_t i = 1; b[(start + i) % b.size()] != a[last % n]; ++i)
        united.push_back(b[(start + i) % b.size()]);
    Polygon sorted = united;
    std::sort(sorted.begin(), sorted.end());
    const bool simple = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
    return simple && united.size() >= 3 ? united : Polygon{};
}

double distanceFromLine(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double length = norm(b - a);
    return length > 0 ? norm(cross(b - a, p - a)) / length : norm(p - a);
}

} // namespace polymesh
