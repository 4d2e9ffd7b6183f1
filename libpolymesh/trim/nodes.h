// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/arrangement.h"

#include <cstdint>
#include <vector>

namespace polymesh {

/// 0D: the winding number of the moved surface round every local node (into
/// arrangement.winding) and round every cell outside the probe (returned, one per mesh cell; probed
/// cells have 0). `shift` is added to all: 1 for a surface turned inside out.
///
/// Numbers are carried over edges by the crossings found and through cells that nothing touches;
/// one node of each connected piece of the mesh gets its number from rays in the three coordinate
/// directions by majority (paper, 2.1), so that rays cost next to nothing.
/// Throws WorkError where two ways to a node disagree, which a closed surface rules out.
std::vector<std::int8_t> windNodes(const PolyMesh& mesh,
                                   const Probe& probe,
                                   const CuttingSurface& cutter,
                                   int shift,
                                   Arrangement& arrangement);

/// The winding number of the moved surface round a mesh point, by majority of three rays.
/// Cost: O(triangles).
int windingNumber(const CuttingSurface& cutter, const Vec3& meshPoint);

} // namespace polymesh
