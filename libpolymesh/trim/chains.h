// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/vec3.h"

#include <array>
#include <span>
#include <vector>

namespace polymesh {

/// Marks the points of a closed polygon that must stay so that no dropped point is farther than
/// `tolerance` [m] from the edge that replaces its part, and at least three points stay.
/// isKept(i) tells and keep(i) sets whether the i-th point stays.
/// Source: Douglas and Peucker (1973), on each part between two kept points.
template<class IsKept, class Keep>
void keepWithin(const std::vector<Vec3>& positions,
                std::span<const Label> polygon,
                double tolerance,
                IsKept&& isKept,
                Keep&& keep);

/// Distance from p to the segment a b [m].
double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b);

/// Distance from p to the triangle a b c [m].
double distanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

namespace detail {

/// The point farthest from the segment between the ends of the open chain (first, last), as a place
/// in the polygon; `distance` is set to its distance. Places count modulo the polygon's size.
std::size_t farthest(const std::vector<Vec3>& positions,
                     std::span<const Label> polygon,
                     std::size_t first,
                     std::size_t last,
                     double& distance);

} // namespace detail

template<class IsKept, class Keep>
void keepWithin(const std::vector<Vec3>& positions,
                std::span<const Label> polygon,
                double tolerance,
                IsKept&& isKept,
                Keep&& keep) {
    const std::size_t n = polygon.size();
    std::size_t start = n;
    std::size_t kept = 0;
    for (std::size_t i = n; i-- > 0;)
        if (isKept(i)) {
            start = i;
            ++kept;
        }
    if (start == n) {
        start = 0;
        keep(0);
        kept = 1;
    }
    // One round: parts between kept points, split at the farthest point while it is too far.
    std::vector<std::array<std::size_t, 2>> parts;
    std::size_t from = start;
    for (std::size_t i = start + 1; i <= start + n; ++i)
        if (i == start + n || isKept(i % n)) {
            if (i - from > 1) parts.push_back({from, i});
            from = i;
        }
    while (!parts.empty()) {
        const auto [first, last] = parts.back();
        parts.pop_back();
        double distance = 0;
        const std::size_t far = detail::farthest(positions, polygon, first, last, distance);
        const bool isTooFew = kept < 3;
        if (distance <= tolerance && !isTooFew) continue;
        keep(far % n);
        ++kept;
        if (far - first > 1) parts.push_back({first, far});
        if (last - far > 1) parts.push_back({far, last});
    }
}

} // namespace polymesh
