// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/bends.h"

#include <span>

namespace polymesh {

/// Whether the straight line between two corners of a polygon, places i and j, runs inside it, as
/// seen along the polygon's normal, and both sides of it lie more or less as the polygon does;
/// edges go by way of their bends.
bool isChord(const PolyMesh& mesh,
             const Bends& bends,
             std::span<const Label> polygon,
             std::size_t i,
             std::size_t j);

} // namespace polymesh
