// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes of projection.h.

#include "libpolymesh/geometry/box.h"
#include "libpolymesh/initial/projection.h"
#include "libpolymesh/surface/distance.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace polymesh {
namespace {

/// The nearer to p of two points.
Vec3 nearer(const Vec3& p, const Vec3& a, const Vec3& b) {
    return squaredNorm(b - p) < squaredNorm(a - p) ? b : a;
}

/// A unit vector across `direction`.
Vec3 across(const Vec3& direction) {
    const bool alongX = std::abs(direction.x) > 0.5 * norm(direction);
    const Vec3 n = cross(direction, alongX ? Vec3{0, 1, 0} : Vec3{1, 0, 0});
    return n / norm(n);
}

Vec3 clamped(const Vec3& p, const Box& box) {
    Vec3 result;
    for (int axis = 0; axis < 3; ++axis)
        result[axis] = std::clamp(p[axis], box.min[axis], box.max[axis]);
    return result;
}

} // namespace

Shape sphereShape(const Vec3& centre, double radius) {
    const auto nearest = [centre, radius](const Vec3& p) {
        const Vec3 d = p - centre;
        const double distance = norm(d);
        return centre + (distance > 0 ? (radius / distance) * d : Vec3{radius, 0, 0});
    };
    const Vec3 r{radius, radius, radius};
    return {nearest, {centre - r, centre + r}};
}

Shape cylinderShape(const Vec3& end1, const Vec3& end2, double radius) {
    const double length = norm(end2 - end1);
    const Vec3 axis = (end2 - end1) / length;
    const auto nearest = [=](const Vec3& p) {
        const double along = dot(p - end1, axis);
        const Vec3 out = p - end1 - along * axis;
        const double distance = norm(out);
        const Vec3 outward = distance > 0 ? out / distance : across(axis);
        const double onAxis = std::clamp(along, 0.0, length);
        const Vec3 onWall = end1 + onAxis * axis + radius * outward;
        const Vec3 inDisc = std::min(distance, radius) * outward;
        return nearer(p, nearer(p, onWall, end1 + inDisc), end2 + inDisc);
    };
    Box bounds{end1, end1};
    for (int i = 0; i < 3; ++i) {
        const double r = radius * std::sqrt(std::max(0.0, 1 - axis[i] * axis[i]));
        bounds.min[i] = std::min(end1[i], end2[i]) - r;
        bounds.max[i] = std::max(end1[i], end2[i]) + r;
    }
    return {nearest, bounds};
}

Shape boxShape(const Box& box) {
    const auto nearest = [box](const Vec3& p) {
        const Vec3 inside = clamped(p, box);
        if (inside != p) return inside;
        Vec3 best = p;
        double least = Box::inf;
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {box.min[axis], box.max[axis]})
                if (std::abs(side - p[axis]) < least) {
                    least = std::abs(side - p[axis]);
                    best = p;
                    best[axis] = side;
                }
        return best;
    };
    return {nearest, box};
}

Shape plateShape(const Vec3& corner, const Vec3& span) {
    Box box;
    box.add(corner);
    box.add(corner + span);
    return {[box](const Vec3& p) { return clamped(p, box); }, box};
}

Shape surfaceShape(TriSurface surface) {
    struct Kept {
        explicit Kept(TriSurface s) : surface(std::move(s)), tree(surface) {}

        TriSurface surface;
        SurfaceTree tree;
    };

    const auto kept = std::make_shared<const Kept>(std::move(surface));
    return {[kept](const Vec3& p) { return kept->tree.closest(p).point; },
            boundingBox(kept->surface.points)};
}

} // namespace polymesh
