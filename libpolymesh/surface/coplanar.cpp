// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/coplanar.h"

#include "libpolymesh/geometry/predicates.h"

namespace polymesh {

bool areCollinear(const Vec3& a, const Vec3& b, const Vec3& c) {
    for (int axis = 0; axis < 3; ++axis)
        if (normalSign(a, b, c, axis) != 0) return false;
    return true;
}

int sideOfLine(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    // Seen along any axis that is not in the plane.
    for (int axis = 0; axis < 3; ++axis)
        if (const int sign = normalSign(a, b, c, axis); sign != 0)
            return sign * normalSign(a, b, d, axis);
    return 0;
}

bool isOnTriangle(const std::array<Vec3, 3>& triangle, const Vec3& p) {
    const auto& [a, b, c] = triangle;
    return orient3d(a, b, c, p) == 0 && !areCollinear(a, b, c) && sideOfLine(a, b, c, p) >= 0 &&
           sideOfLine(b, c, a, p) >= 0 && sideOfLine(c, a, b, p) >= 0;
}

} // namespace polymesh
