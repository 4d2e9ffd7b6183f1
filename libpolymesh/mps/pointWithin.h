// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"

#include <optional>
#include <span>
#include <vector>

namespace polymesh {

/// The side of a plane on which a point must be: dot(normal, x - at) > 0; the normal is a unit.
struct HalfSpace {
    Vec3 normal;
    Vec3 at;
};

/// Adds the half-space of the x with det(a, b, x - at) > 0; none when a and b are parallel.
void addHalfSpace(const Vec3& a, const Vec3& b, const Vec3& at, std::vector<HalfSpace>& list);

/// How long to search.
struct Search {
    int moves = 60;   // for one margin
    int margins = 10; // each a third of the one before
};

/// A point within all half-spaces, by a margin that is a fraction of `reach` [m], if the search
/// finds one. From `start` it moves over the plane that it misses most, to a margin beyond it, for
/// less and less margin. Cost: O(half-spaces), some hundred times when there is no such point.
/// Source: the relaxation method of Agmon and of Motzkin and Schoenberg (1954).
std::optional<Vec3> pointWithin(std::span<const HalfSpace> halfSpaces,
                                const Vec3& start,
                                double reach,
                                const Search& search = {});

} // namespace polymesh
