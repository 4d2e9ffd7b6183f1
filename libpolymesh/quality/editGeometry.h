// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/editMesh.h"

#include <vector>

namespace polymesh {

/// Area vector [m^2] and centre [m] of a polygon, by OpenFOAM's definition (a fan of triangles
/// about the mean of the corners, centres weighted with the triangles' areas).
struct FaceGeometry {
    Vec3 area;
    Vec3 centre;
};

/// Centre [m] and volume [m^3] of a cell, by OpenFOAM's definition (pyramids over the faces).
struct CellGeometry {
    Vec3 centre;
    double volume = 0;
};

/// The geometry of the polygon with these corners; at least 3.
FaceGeometry polygonGeometry(const std::vector<Vec3>& points, const Polygon& corners);

/// Distance [m] of p from the line through a and b; from a when they coincide.
double distanceFromLine(const Vec3& p, const Vec3& a, const Vec3& b);

} // namespace polymesh
