// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/box.h"
#include "libpolymesh/refine/criterion.h"
#include "libpolymesh/refine/nearTriangles.h"

#include <functional>
#include <memory>

namespace polymesh {

/// A part of space.
struct Region {
    /// Whether the ball has a point inside the region.
    std::function<bool(const Vec3& centre, double radius)> touches;
    /// The same for the space outside it.
    std::function<bool(const Vec3& centre, double radius)> touchesOutside;
};

Region boxRegion(const Box& box);
Region sphereRegion(const Vec3& centre, double radius);

/// Requires: different ends.
Region cylinderRegion(const Vec3& end1, const Vec3& end2, double radius);

/// What a closed surface holds. Points that an odd number of triangles lie beyond are inside.
Region surfaceRegion(std::shared_ptr<const NearTriangles> near);

enum class RegionSide { inside, outside };

/// Cells that touch a region, or the space outside it, are to have a level.
Criterion regionCriterion(const Region& region, RegionSide side, int level);

} // namespace polymesh
