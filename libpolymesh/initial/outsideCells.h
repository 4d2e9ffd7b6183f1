// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/surface/triSurface.h"

#include <cstdint>
#include <vector>

namespace polymesh {

/// Which cells of a box are outside a surface and away from it, one byte each: those that are
/// reached from the sides of the box over faces, without coming within a cell of any triangle. It
/// does not matter how the triangles are turned. Through a hole as wide as three cells the inside
/// is reached as well. Cavities that the surface encloses do not count as outside.
/// Requires: the surface lies within the box.
/// Cost: some 10 ns a cell, and the time to sort the triangles into bins.
std::vector<std::uint8_t> outsideCells(const CartesianBox& box, const TriSurface& surface);

/// The cells of a box that are not flagged, in their order. Faces to those that are flagged form
/// the last patch, `outside`; sides of the box on which nothing is left are no patches.
/// Throws InputError when all are flagged. Cost: linear, in parallel.
PolyMesh cartesianMeshWithout(const CartesianBox& box, const std::vector<std::uint8_t>& flags);

} // namespace polymesh
