// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/surface/triSurface.h"

#include <array>
#include <vector>

namespace polymesh {

/// The coordinates [m] across each axis at which a surface has flat sides: triangles in a plane
/// across the axis (up to a thousandth of `cellSize`) with an area of at least half a cell's face
/// in all. Ascending. Cost: O(triangles).
std::array<std::vector<double>, 3> flatSides(const TriSurface& surface, double cellSize);

/// Shifts a box of cubes, by less than a cell in each direction, so that its grid planes keep a
/// fifth of a cell away from the flat sides, or as far as they can; cells are added where the box
/// would leave less than `margin` round `surfaceBox`. A direction without a flat side that near to
/// a plane stays as it is, and of all shifts that will do the smallest is taken. With `levels` the
/// planes of cells halved so often keep away as well, in proportion to their distance. Why: a plane
/// a hair beside a flat side cuts off cells a hair thick.
CartesianBox clearOfFlatSides(const CartesianBox& box,
                              const Box& surfaceBox,
                              double margin,
                              const std::array<std::vector<double>, 3>& flats,
                              int levels = 0);

} // namespace polymesh
