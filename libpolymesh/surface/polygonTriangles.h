// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace polymesh {

/// Divides a polygon into triangles, given by places in it: the fan from its first corner, unless
/// that folds back on itself; then ears are cut off, the one with the shortest cut first. Seen
/// along the axis that is nearest to its normal, exactly. A polygon that crosses itself gives the
/// fan. Requires: three points or more. Cost: O(n); where the fan folds O(n^3).
std::vector<std::array<std::size_t, 3>> polygonTriangles(std::span<const Vec3> polygon);

} // namespace polymesh
