// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"

#include <optional>

namespace polymesh {

/// What joinCracks did.
struct JoinedCracks {
    Label openEdges = 0;    // before; afterwards there are none
    Label points = 0;       // that became one with another
    double largestMove = 0; // [m]
    double limit = 0;       // [m] what the coordinates' precision explains
};

/// Closes an open surface by joining points of its open edges whose coordinates differ by rounding
/// only: by no more than two units in the last place that the file's numbers have at the size of
/// the largest coordinate (two: each of the two points is rounded, and so is what they came from).
/// Single precision (2^-23) is taken for numbers that have more digits, because that is what most
/// programs compute surfaces in; six digits for numbers that have less.
///
/// Nothing, and the surface as it was, when that does not close all of it. Cost: O(n log n).
std::optional<JoinedCracks> joinCracks(TriSurface& surface);

} // namespace polymesh
