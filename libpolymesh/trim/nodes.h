// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/arrangement.h"

#include <cstdint>
#include <vector>

namespace polymesh {

/// 0D: the winding number of the moved surface round every local node, into arrangement.winding.
/// `shift` is added to all: 1 for a surface turned inside out.
///
/// Numbers are carried over edges by the crossings found; one node of each connected piece of the
/// probe gets its number from rays in the three coordinate directions by majority (paper, 2.1), so
/// that rays cost next to nothing.
/// Throws WorkError where two ways to a node disagree, which a closed surface rules out.
void windNodes(const Probe& probe,
               const CuttingSurface& cutter,
               int shift,
               Arrangement& arrangement);

/// Compares the numbers of nodes with those of the cells next to the probe (windFarCells), which
/// nothing parts from them. Throws WorkError where they disagree.
void checkFarCells(const PolyMesh& mesh,
                   const Probe& probe,
                   const std::vector<std::int8_t>& cellWinding,
                   const Arrangement& arrangement);

/// The winding number of the moved surface round a mesh point, by majority of three rays.
/// Cost: O(triangles).
int windingNumber(const CuttingSurface& cutter, const Vec3& meshPoint);

} // namespace polymesh
