// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/exactSigns.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace polymesh {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 toCgal(const Vec3& p) {
    return {p.x, p.y, p.z};
}

} // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return CGAL::orientation(toCgal(a), toCgal(b), toCgal(c), toCgal(d));
}

bool areCollinear(const Vec3& a, const Vec3& b, const Vec3& c) {
    return CGAL::collinear(toCgal(a), toCgal(b), toCgal(c));
}

int sideOfLine(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return CGAL::coplanar_orientation(toCgal(a), toCgal(b), toCgal(c), toCgal(d));
}

} // namespace polymesh
