// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"

#include <vector>

namespace polymesh {

struct SurfaceMeasure {
    double volume = 0;              // [m^3], positive when normals point outward
    double area = 0;                // [m^2]
    std::vector<double> regionArea; // [m^2], one per region
};

/// Volume and area of a surface. The volume means something for closed surfaces only. Summed in
/// extended precision: exact to about 1e-15 of area times size, whatever the number of triangles.
SurfaceMeasure measure(const TriSurface& surface);

} // namespace polymesh
