// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"

#include <array>

namespace polymesh {

/// Questions about points in one plane, answered exactly.

/// True when a, b and c lie on one line (or coincide).
bool areCollinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// For coplanar points, a, b and c not collinear: +1 when c and d are on the same side of the line
/// ab, -1 when on opposite sides, 0 when d is on the line.
int sideOfLine(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// True when p lies on the triangle, border included. False for triangles without area.
bool isOnTriangle(const std::array<Vec3, 3>& triangle, const Vec3& p);

} // namespace polymesh
