// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"

#include <algorithm>
#include <limits>
#include <span>

namespace polymesh {

/// An axis-aligned closed box [m]; empty until a point is added.
struct Box {
    static constexpr double inf = std::numeric_limits<double>::infinity();
    Vec3 min{inf, inf, inf};
    Vec3 max{-inf, -inf, -inf};

    bool isEmpty() const { return !(min.x <= max.x); }

    Vec3 size() const { return max - min; }

    Vec3 centre() const { return 0.5 * (min + max); }

    void add(const Vec3& p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
    }

    void add(const Box& b) {
        min = {std::min(min.x, b.min.x), std::min(min.y, b.min.y), std::min(min.z, b.min.z)};
        max = {std::max(max.x, b.max.x), std::max(max.y, b.max.y), std::max(max.z, b.max.z)};
    }

    bool contains(const Vec3& p) const {
        return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y && min.z <= p.z &&
               p.z <= max.z;
    }

    bool operator==(const Box&) const = default;
};

inline bool overlaps(const Box& a, const Box& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
           a.min.z <= b.max.z && b.min.z <= a.max.z;
}

inline Box boundingBox(std::span<const Vec3> points) {
    Box box;
    for (const Vec3& p : points)
        box.add(p);
    return box;
}

} // namespace polymesh
