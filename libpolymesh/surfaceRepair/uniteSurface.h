// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"

#include <optional>

namespace polymesh {

/// What uniteSurface did.
struct UnitedSurface {
    TriSurface surface;     // its regions are those of before
    Label divided = 0;      // triangles that met others
    Label pairsLeft = 0;    // of triangles that still intersect, by rounding
    Label rounds = 0;       // how often coordinates were rounded
    double largestMove = 0; // [m] no point is farther from its exact place than this
};

/// Divides the triangles that intersect along the lines where they meet, and keeps what parts
/// inside (winding number 1 or more) from outside: overlapping parts are united, folds cut off,
/// triangles without area dropped. Lines and points are exact; their coordinates are then rounded,
/// and what intersects by rounding is treated the same way again, on a grid that coarsens from
/// round to round, at most to 2^-23 of the surface's largest coordinate, which is single precision.
/// Ends when nothing intersects, or when rounding makes more pairs than it takes away: then the
/// round that left the fewest is taken. Nothing when there are more than a million pairs, or no
/// triangle is left.
///
/// Requires: closed, consistently oriented. Cost: some 50 us for each pair of triangles that
/// intersect, and a round's O(n log n).
std::optional<UnitedSurface> uniteSurface(const TriSurface& surface);

} // namespace polymesh
