// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/arrangement.h"

#include <cstdint>
#include <vector>

namespace polymesh {

/// The winding number of the moved surface round every cell outside the probe, one per mesh cell;
/// probed cells have 0. `shift` is added to all others: 1 for a surface turned inside out.
///
/// No triangle touches these cells, so that those connected by faces have one number; rays from one
/// point of each such region tell it. Needs the probe's cells only.
/// Cost: O(faces), and O(triangles) for each region.
std::vector<std::int8_t>
windFarCells(const PolyMesh& mesh, const Probe& probe, const CuttingSurface& cutter, int shift);

} // namespace polymesh
