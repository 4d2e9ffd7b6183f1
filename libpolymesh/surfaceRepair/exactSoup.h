// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/surface/triSurface.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <array>
#include <vector>

namespace polymesh {

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = ExactKernel::Point_3;

/// Triangles with exact corners, none without area.
/// Laws: (1) no two points are equal; (2) source[t] is a triangle of the surface that the soup was
/// made of, which t is a part of and has the orientation of.
struct ExactSoup {
    std::vector<ExactPoint> points;
    std::vector<std::array<Label, 3>> triangles; // point labels
    std::vector<Label> source;                   // one per triangle

    const ExactPoint& corner(Label triangle, std::size_t i) const {
        return points[index(triangles[index(triangle)][i])];
    }
};

inline ExactPoint toExact(const Vec3& p) {
    return {p.x, p.y, p.z};
}

inline ExactKernel::Triangle_3 exactTriangle(const TriSurface& surface, Label t) {
    return {toExact(surface.corner(t, 0)),
            toExact(surface.corner(t, 1)),
            toExact(surface.corner(t, 2))};
}

} // namespace polymesh
