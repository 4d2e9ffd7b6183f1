// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/measure.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/box.h"
#include "libpolymesh/surface/regions.h"

#include <array>
#include <cmath>

namespace polymesh {

namespace {

using Real = long double; // 64 bits of mantissa on x86, more than enough above 1e-15
using Vector = std::array<Real, 3>;

Vector difference(const Vec3& a, const Vec3& b) {
    return {Real(a.x) - Real(b.x), Real(a.y) - Real(b.y), Real(a.z) - Real(b.z)};
}

Vector crossProduct(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Real dotProduct(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Twice the area vector.
Vector doubleArea(const TriSurface& surface, Label t) {
    const Vec3& a = surface.corner(t, 0);
    return crossProduct(difference(surface.corner(t, 1), a), difference(surface.corner(t, 2), a));
}

} // namespace

SurfaceMeasure measure(const TriSurface& surface) {
    SurfaceMeasure result;
    // Seen from the middle the terms are small, and little is lost when they cancel.
    const Vec3 middle = boundingBox(surface.points).centre();
    result.volume = static_cast<double>(
        parallelSum(surface.triangleCount(),
                    Real(0),
                    [&](Label t) {
                        return dotProduct(difference(surface.corner(t, 0), middle),
                                          doubleArea(surface, t));
                    }) /
        6);
    Real area = 0;
    const Rows<Label> triangles = trianglesOfRegions(surface);
    for (Label region = 0; region < triangles.size(); ++region) {
        const auto row = triangles[region];
        const Real regionArea = parallelSum(toLabel(row.size()), Real(0), [&](Label i) {
            const Vector normal = doubleArea(surface, row[index(i)]);
            return std::sqrt(dotProduct(normal, normal)) / 2;
        });
        result.regionArea.push_back(static_cast<double>(regionArea));
        area += regionArea;
    }
    result.area = static_cast<double>(area);
    return result;
}

} // namespace polymesh
