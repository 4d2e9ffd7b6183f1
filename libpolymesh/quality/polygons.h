// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/editMesh.h"

#include <vector>

namespace polymesh {

/// Cuts a closed walk at the points that it visits more than once: the polygons with at least 3
/// corners that are left, each without a repeated point and in the direction of the walk. What runs
/// there and back vanishes. A walk without repeated points comes back as it is.
std::vector<Polygon> simpleLoops(const Polygon& walk);

/// The union of two polygons that run along common edges in opposite directions, or an empty
/// polygon when they have no common edge or when their union is not a disc.
Polygon unitedPolygon(const Polygon& a, const Polygon& b);

/// True when the polygon has the edge a-b, in either direction.
bool hasEdge(const Polygon& polygon, Label a, Label b);

bool hasPoint(const Polygon& polygon, Label p);

/// The corner after / before the corner `p` of the polygon.
Label cornerAfter(const Polygon& polygon, Label p);
Label cornerBefore(const Polygon& polygon, Label p);

/// Distance [m] of p from the line through a and b; from a when they coincide.
double distanceFromLine(const Vec3& p, const Vec3& a, const Vec3& b);

} // namespace polymesh
