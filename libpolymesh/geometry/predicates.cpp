// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/geometry/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <cmath>
#include <limits>

namespace polymesh {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Interval = CGAL::Interval_nt<true>;
using Exact = CGAL::Gmpq;

Kernel::Point_3 point(const Vec3& p) {
    return {p.x, p.y, p.z};
}

int toInt(CGAL::Sign sign) {
    return static_cast<int>(sign);
}

Kernel::Point_2 projected(const Vec3& p, int axis) {
    return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

template<class Number>
struct Vector {
    Number x, y, z;
};

template<class Number>
Vector<Number> difference(const Vec3& a, const Vec3& b) {
    return {Number(a.x) - Number(b.x), Number(a.y) - Number(b.y), Number(a.z) - Number(b.z)};
}

template<class Number>
Vector<Number> crossProduct(const Vector<Number>& a, const Vector<Number>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template<class Number>
Number dotProduct(const Vector<Number>& a, const Vector<Number>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template<class Number>
Vector<Number> normal(const std::array<Vec3, 3>& t) {
    return crossProduct(difference<Number>(t[1], t[0]), difference<Number>(t[2], t[0]));
}

/// Parameter of the plane through t along a + s (b - a) as numerator and denominator.
template<class Number>
std::array<Number, 2> parameter(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& t) {
    const Vector<Number> n = normal<Number>(t);
    return {dotProduct(n, difference<Number>(t[0], a)), dotProduct(n, difference<Number>(b, a))};
}

int firstNonZero(const Vector<Exact>& n, const Exact& d, const Vector<Exact>& m, const Exact& e) {
    const std::array<Exact, 3> u{n.x / d, n.y / d, n.z / d};
    const std::array<Exact, 3> v{m.x / e, m.y / e, m.z / e};
    for (std::size_t i = 0; i < 3; ++i)
        if (u[i] != v[i]) return u[i] < v[i] ? -1 : 1;
    return 0;
}

/// Compares where the planes s and t cut the line a b; ties by the coefficients of the move, which
/// adds +move to the planes when `planesMove`, else to the line.
int comparePlanes(const Vec3& a,
                  const Vec3& b,
                  const std::array<Vec3, 3>& s,
                  const std::array<Vec3, 3>& t,
                  bool planesMove) {
    {
        const CGAL::Protect_FPU_rounding<true> rounding;
        using Unprotected = CGAL::Interval_nt<false>;
        const auto u = parameter<Unprotected>(a, b, s);
        const auto v = parameter<Unprotected>(a, b, t);
        if (!u[1].do_overlap(0) && !v[1].do_overlap(0)) {
            const Unprotected first = u[0] / u[1];
            const Unprotected second = v[0] / v[1];
            if (first.sup() < second.inf()) return -1;
            if (second.sup() < first.inf()) return 1;
        }
    }
    const auto u = parameter<Exact>(a, b, s);
    const auto v = parameter<Exact>(a, b, t);
    const Exact first = u[0] / u[1];
    const Exact second = v[0] / v[1];
    if (first != second) return first < second ? -1 : 1;
    const int order = firstNonZero(normal<Exact>(s), u[1], normal<Exact>(t), v[1]);
    return planesMove ? order : -order;
}

} // namespace

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return toInt(CGAL::orientation(point(a), point(b), point(c), point(d)));
}

int normalSign(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
    return toInt(CGAL::orientation(projected(a, axis), projected(b, axis), projected(c, axis)));
}

int crossSign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, int axis) {
    const int i = (axis + 1) % 3;
    const int j = (axis + 2) % 3;
    const double left = (b[i] - a[i]) * (d[j] - c[j]);
    const double right = (b[j] - a[j]) * (d[i] - c[i]);
    const double value = left - right;
    // Three roundings in each product and one in the difference; 8 ulps leave room, and the
    // smallest normal number covers underflow.
    const double bound =
        8 * std::numeric_limits<double>::epsilon() * (std::abs(left) + std::abs(right)) +
        std::numeric_limits<double>::min();
    if (std::abs(value) > bound) return value > 0 ? 1 : -1;
    const Exact exact = (Exact(b[i]) - Exact(a[i])) * (Exact(d[j]) - Exact(c[j])) -
                        (Exact(b[j]) - Exact(a[j])) * (Exact(d[i]) - Exact(c[i]));
    return toInt(CGAL::sign(exact));
}

MovedSign sideOfTriangle(const std::array<Vec3, 3>& t, const Vec3& meshPoint) {
    if (const int sign = orient3d(t[0], t[1], t[2], meshPoint); sign != 0)
        return {static_cast<std::int8_t>(sign), false};
    for (int axis = 0; axis < 3; ++axis)
        if (const int sign = normalSign(t[0], t[1], t[2], axis); sign != 0)
            return {static_cast<std::int8_t>(-sign), true};
    return {1, true};
}

MovedSign sideOfMeshPlane(const std::array<Vec3, 3>& f, const Vec3& surfacePoint) {
    if (const int sign = orient3d(f[0], f[1], f[2], surfacePoint); sign != 0)
        return {static_cast<std::int8_t>(sign), false};
    for (int axis = 0; axis < 3; ++axis)
        if (const int sign = normalSign(f[0], f[1], f[2], axis); sign != 0)
            return {static_cast<std::int8_t>(sign), true};
    return {1, true};
}

MovedSign passingSide(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q) {
    if (const int sign = orient3d(a, b, p, q); sign != 0)
        return {static_cast<std::int8_t>(sign), false};
    for (int axis = 0; axis < 3; ++axis)
        if (const int sign = crossSign(p, q, a, b, axis); sign != 0)
            return {static_cast<std::int8_t>(sign), true};
    return {0, true};
}

bool isPlanarConvex(std::span<const Vec3> polygon) {
    const std::size_t n = polygon.size();
    std::size_t third = 2;
    int axis = 3;
    for (; third < n && axis == 3; ++third)
        for (axis = 0; axis < 3; ++axis)
            if (normalSign(polygon[0], polygon[1], polygon[third], axis) != 0) break;
    if (axis == 3) return false;
    --third;
    for (std::size_t i = 2; i < n; ++i)
        if (orient3d(polygon[0], polygon[1], polygon[third], polygon[i]) != 0) return false;
    const int turn = normalSign(polygon[0], polygon[1], polygon[third], axis);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 2; j < n; ++j)
            if (normalSign(polygon[i], polygon[(i + 1) % n], polygon[(i + j) % n], axis) == -turn)
                return false;
    return true;
}

int compareAlongMeshEdge(const Vec3& a,
                         const Vec3& b,
                         const std::array<Vec3, 3>& s,
                         const std::array<Vec3, 3>& t) {
    return comparePlanes(a, b, s, t, true);
}

int compareAlongSurfaceEdge(const Vec3& p,
                            const Vec3& q,
                            const std::array<Vec3, 3>& f,
                            const std::array<Vec3, 3>& g) {
    return comparePlanes(p, q, f, g, false);
}

} // namespace polymesh
