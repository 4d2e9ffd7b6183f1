// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"

namespace polymesh {

/// Exact signs that surfaces need (CGAL's filtered predicates; thread-safe).

/// Sign of ((b - a) x (c - a)) . (d - a): +1 when d is on the side the normal of abc points to.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// True when a, b and c lie on one line (or coincide).
bool areCollinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// For coplanar points, a, b and c not collinear: +1 when c and d are on the same side of the line
/// ab, -1 when on opposite sides, 0 when d is on the line.
int sideOfLine(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

} // namespace polymesh
