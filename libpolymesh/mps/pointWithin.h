// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"

#include <optional>
#include <span>
#include <vector>

namespace polymesh {

/// The side of a plane on which a point must be: dot(normal, x - at) > 0; the normal is a unit, or
/// zero, and then there is no such point.
struct HalfSpace {
    Vec3 normal;
    Vec3 at;
};

/// Adds the half-space of the x with det(a, b, x - at) > 0; none when a and b are parallel.
void addHalfSpace(const Vec3& a, const Vec3& b, const Vec3& at, std::vector<HalfSpace>& list);

/// What a point must have.
struct Search {
    double least = 1e-6; // distance from all planes, as a fraction of `reach`
};

/// A point within all half-spaces and not more than some `reach` [m] from `start`, deep inside:
/// `start` itself where it is deep, else one that is at least half as deep as any; none when no
/// point is as deep as `search` asks for. Cost: O(half-spaces) a pivot; some 5 pivots, 60 at most.
/// The linear program of the deepest point (Chebyshev's centre) by the dual simplex method, from a
/// tetrahedron round `start`: the depth falls from pivot to pivot, so failures end early.
std::optional<Vec3> pointWithin(std::span<const HalfSpace> halfSpaces,
                                const Vec3& start,
                                double reach,
                                const Search& search = {});

} // namespace polymesh
