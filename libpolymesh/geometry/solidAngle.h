// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"

#include <cmath>

namespace polymesh {

/// The solid angle [sr] that the triangle a b c fills as seen from p, in [-2 pi, 2 pi]: positive
/// where its normal points away from p. Over a closed surface with normals outward they add up to
/// 4 pi for a point inside, 0 for one outside.
/// Source: van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125-126.
inline double solidAngle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 u = a - p;
    const Vec3 v = b - p;
    const Vec3 w = c - p;
    const double nu = norm(u);
    const double nv = norm(v);
    const double nw = norm(w);
    return 2 * std::atan2(dot(u, cross(v, w)),
                          nu * nv * nw + dot(u, v) * nw + dot(v, w) * nu + dot(w, u) * nv);
}

} // namespace polymesh
