// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/distance.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/surface/boxTree.h"
#include "libpolymesh/surface/triangleBoxes.h"

#include <algorithm>
#include <cmath>

namespace polymesh {

namespace {

Vec3 closestOnSegment(const Vec3& a, const Vec3& b, const Vec3& p) {
    const Vec3 ab = b - a;
    const double length2 = squaredNorm(ab);
    if (!(length2 > 0)) return a;
    const double s = dot(p - a, ab) / length2;
    if (s <= 0) return a;
    return s >= 1 ? b : a + s * ab;
}

} // namespace

Vec3 closestPoint(const std::array<Vec3, 3>& triangle, const Vec3& p) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = cross(b - a, c - a);
    const bool isAbove = dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
                         dot(cross(a - c, p - c), n) >= 0;
    if (squaredNorm(n) > 0 && isAbove) return p - (dot(p - a, n) / squaredNorm(n)) * n;
    const std::array<Vec3, 3> candidates{
        closestOnSegment(a, b, p), closestOnSegment(b, c, p), closestOnSegment(c, a, p)};
    return *std::ranges::min_element(
        candidates, {}, [&](const Vec3& q) { return squaredNorm(q - p); });
}

struct SurfaceTree::Data {
    const TriSurface* surface;
    BoxTree tree;
};

SurfaceTree::SurfaceTree(const TriSurface& surface) {
    require(!surface.triangles.empty(), "the surface has no triangles");
    data_ = std::make_unique<Data>(Data{&surface, BoxTree(triangleBoxes(surface))});
}

SurfaceTree::~SurfaceTree() = default;
SurfaceTree::SurfaceTree(SurfaceTree&&) noexcept = default;
SurfaceTree& SurfaceTree::operator=(SurfaceTree&&) noexcept = default;

ClosestPoint SurfaceTree::closest(const Vec3& p) const {
    const TriSurface& surface = *data_->surface;
    ClosestPoint best;
    double best2 = Box::inf;
    data_->tree.searchNearest(p, [&](Label t) {
        const Vec3 q =
            closestPoint({surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)}, p);
        const double d2 = squaredNorm(q - p);
        if (d2 < best2 || (d2 == best2 && t < best.triangle)) {
            best2 = d2;
            best = {q, 0, t};
        }
        return d2;
    });
    best.distance = std::sqrt(best2);
    return best;
}

} // namespace polymesh
