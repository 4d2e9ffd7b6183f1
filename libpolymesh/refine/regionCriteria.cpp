// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/regionCriteria.h"

#include "libpolymesh/geometry/predicates.h"

#include <algorithm>
#include <cmath>

namespace polymesh {
namespace {

/// A region by the distance from its border, negative inside.
Region byDistance(const std::function<double(const Vec3&)>& signedDistance) {
    return {[=](const Vec3& centre, double radius) { return signedDistance(centre) <= radius; },
            [=](const Vec3& centre, double radius) { return signedDistance(centre) >= -radius; }};
}

/// Whether the segment crosses the moved triangle: see predicates.h.
bool crosses(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& triangle) {
    if (sideOfTriangle(triangle, a).sign == sideOfTriangle(triangle, b).sign) return false;
    const int first = passingSide(a, b, triangle[0], triangle[1]).sign;
    return passingSide(a, b, triangle[1], triangle[2]).sign == first &&
           passingSide(a, b, triangle[2], triangle[0]).sign == first;
}

} // namespace

Region boxRegion(const Box& box) {
    return byDistance([box](const Vec3& p) {
        Vec3 beyond;
        double deepest = -Box::inf;
        for (int axis = 0; axis < 3; ++axis) {
            const double d = std::max(box.min[axis] - p[axis], p[axis] - box.max[axis]);
            deepest = std::max(deepest, d);
            beyond[axis] = std::max(d, 0.0);
        }
        return deepest > 0 ? norm(beyond) : deepest;
    });
}

Region sphereRegion(const Vec3& centre, double radius) {
    return byDistance([=](const Vec3& p) { return norm(p - centre) - radius; });
}

Region cylinderRegion(const Vec3& end1, const Vec3& end2, double radius) {
    return byDistance([=](const Vec3& p) {
        const double length = norm(end2 - end1);
        const Vec3 axis = (end2 - end1) / length;
        const double along = dot(p - end1, axis);
        const double beyond = std::max(-along, along - length);
        const double across = norm(p - end1 - along * axis) - radius;
        if (beyond > 0 && across > 0) return std::hypot(beyond, across);
        return std::max(beyond, across);
    });
}

Region surfaceRegion(std::shared_ptr<const NearTriangles> near) {
    const Box bounds = boundingBox(near->surface().points);
    const auto isInside = [near, bounds](const Vec3& p) {
        if (!bounds.contains(p)) return false;
        const Vec3 outside{bounds.max.x + bounds.size().x + 1, p.y, p.z};
        bool inside = false;
        near->forBox({p, outside}, [&](Label t) {
            if (crosses(p, outside, near->cornersOf(t))) inside = !inside;
        });
        return inside;
    };
    return {[=](const Vec3& centre, double radius) {
                return near->closest(centre, radius).has_value() || isInside(centre);
            },
            [=](const Vec3& centre, double radius) {
                return near->closest(centre, radius).has_value() || !isInside(centre);
            }};
}

Criterion regionCriterion(const Region& region, RegionSide side, int level) {
    return [touches = side == RegionSide::inside ? region.touches : region.touchesOutside,
            level](const RefineCell& cell) {
        return cell.level < level && touches(cell.centre, cell.radius);
    };
}

} // namespace polymesh
