// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/chains.h"

#include <algorithm>
#include <cmath>

namespace polymesh {

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 d = b - a;
    const double length2 = squaredNorm(d);
    const double t = length2 > 0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
    return norm(p - (a + t * d));
}

double distanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = cross(b - a, c - a);
    const double area2 = squaredNorm(n);
    if (area2 > 0) {
        const double u = dot(cross(c - b, p - b), n);
        const double v = dot(cross(a - c, p - c), n);
        const double w = dot(cross(b - a, p - a), n);
        if (u >= 0 && v >= 0 && w >= 0) return std::abs(dot(p - a, n)) / std::sqrt(area2);
    }
    return std::min(
        {distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
}

namespace detail {

std::size_t farthest(const std::vector<Vec3>& positions,
                     std::span<const Label> polygon,
                     std::size_t first,
                     std::size_t last,
                     double& distance) {
    const std::size_t n = polygon.size();
    const Vec3& a = positions[index(polygon[first % n])];
    const Vec3& b = positions[index(polygon[last % n])];
    std::size_t best = first + 1;
    distance = -1;
    for (std::size_t i = first + 1; i < last; ++i) {
        const double d = distanceToSegment(positions[index(polygon[i % n])], a, b);
        if (d > distance) {
            distance = d;
            best = i;
        }
    }
    return best;
}

} // namespace detail

} // namespace polymesh
