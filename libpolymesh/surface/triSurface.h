// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/vec3.h"

#include <array>
#include <string>
#include <vector>

namespace polymesh {

/// A triangulated surface with named regions.
/// Laws: (1) no two points are equal bit for bit and every point is used (readers merge them);
/// (2) the three points of a triangle are distinct labels; (3) coordinates are finite;
/// (4) region[t] indexes regionNames, which are distinct and valid OpenFOAM words.
/// A triangle's normal is given by the right-hand rule.
struct TriSurface {
    std::vector<Vec3> points;                    // [m]
    std::vector<std::array<Label, 3>> triangles; // point labels
    std::vector<Label> region;                   // one per triangle
    std::vector<std::string> regionNames;

    Label pointCount() const { return toLabel(points.size()); }

    Label triangleCount() const { return toLabel(triangles.size()); }

    const Vec3& corner(Label triangle, int i) const {
        return points[index(triangles[index(triangle)][static_cast<std::size_t>(i)])];
    }

    bool operator==(const TriSurface&) const = default;
};

} // namespace polymesh
