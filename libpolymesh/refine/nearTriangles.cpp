// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/nearTriangles.h"

#include "libpolymesh/surface/triangleBoxes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace polymesh {
namespace {

std::vector<Label> allTriangles(const TriSurface& surface) {
    std::vector<Label> all(surface.triangles.size());
    std::iota(all.begin(), all.end(), Label{0});
    return all;
}

std::vector<Box> boxesOf(const TriSurface& surface, std::span<const Label> triangles) {
    std::vector<Box> boxes(triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        boxes[i] = triangleBox(surface, triangles[i]);
    return boxes;
}

/// Where the line a + s (b - a) meets a triangle; empty when it misses or is parallel.
std::optional<double> meets(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& triangle) {
    const auto& [p, q, r] = triangle;
    const Vec3 way = b - a;
    const Vec3 across = cross(way, r - p);
    const double determinant = dot(q - p, across);
    if (determinant == 0) return std::nullopt;
    const double u = dot(a - p, across) / determinant;
    const Vec3 other = cross(a - p, q - p);
    const double v = dot(way, other) / determinant;
    const double s = dot(r - p, other) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1)) return std::nullopt;
    return s;
}

} // namespace

NearTriangles::NearTriangles(std::shared_ptr<const TriSurface> surface,
                             std::vector<Label> triangles)
    : surface_(std::move(surface)),
      triangles_(std::move(triangles)),
      tree_(boxesOf(*surface_, triangles_)) {}

NearTriangles::NearTriangles(const std::shared_ptr<const TriSurface>& surface)
    : NearTriangles(surface, allTriangles(*surface)) {}

std::optional<ClosestPoint> NearTriangles::closest(const Vec3& p, double atMost) const {
    ClosestPoint best;
    double best2 = atMost * atMost;
    tree_.searchNearest(
        p,
        [&](Label item) {
            const Label t = triangles_[index(item)];
            const Vec3 q = closestPoint(cornersOf(t), p);
            const double d2 = squaredNorm(q - p);
            if (d2 < best2 || (d2 == best2 && (best.triangle < 0 || t < best.triangle))) {
                best2 = d2;
                best = {q, 0, t};
            }
            return d2;
        },
        std::nextafter(best2, Box::inf));
    if (best.triangle < 0) return std::nullopt;
    best.distance = std::sqrt(best2);
    return best;
}

std::optional<double> NearTriangles::firstHit(const Vec3& a,
                                              const Vec3& b,
                                              const std::function<bool(Label)>& counts) const {
    Box box{a, a};
    box.add(b);
    std::optional<double> first;
    tree_.forEachNear(box, [&](Label item) {
        const Label t = triangles_[index(item)];
        const std::optional<double> s = meets(a, b, cornersOf(t));
        if (s && *s > 0 && *s <= 1 && (!first || *s < *first) && counts(t)) first = s;
    });
    return first;
}

Vec3 unitNormal(const std::array<Vec3, 3>& triangle) {
    const Vec3 normal = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double length = norm(normal);
    return length > 0 ? normal / length : Vec3{};
}

} // namespace polymesh
