// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/vec3.h"

#include <boost/container/small_vector.hpp>

#include <vector>

namespace polymesh {

/// Point labels round a polygon.
using LoopPolygon = boost::container::small_vector<Label, 12>;

/// The loops found on a plane face.
struct CurvesOnFace {
    std::vector<LoopPolygon> polygons; // through the outline
    std::vector<LoopPolygon> closed;   // that do not touch it
    bool isPlainOutline = false;       // `polygons` is the outline with no crossing
};

/// Brings the closed loops of a plane face into its polygons: an island (it turns as the face does)
/// becomes a polygon of its own, a hole is cut open by two bridges to the polygon that holds it,
/// which makes two polygons of one. Never a keyhole, whose points would be repeated.
///
/// A single closed loop in a plain outline is a hole without asking for its area, however small it
/// is. Otherwise areas and distances in double precision decide, which can make an ugly polygon
/// where a loop has no size, but never an open cell: every directed edge stays as it was.
/// Appends to `needed` the points at the ends of bridges and three that hold each loop open.
/// Returns the number of holes.
Label openHoles(const std::vector<Vec3>& positions,
                const Vec3& normal,
                CurvesOnFace& curves,
                std::vector<Label>& needed);

} // namespace polymesh
