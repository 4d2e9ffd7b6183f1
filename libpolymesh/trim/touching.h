// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/trim/loops.h"

#include <vector>

namespace polymesh {

/// Whether a node lies exactly on the surface as given, or a point of the surface on a face of the
/// mesh: no more than that is needed to tell that nothing without thickness can have come about.
/// May be true for no good reason. Cost: O(points of the surface), in parallel.
bool mayTouch(const Probe& probe, const CuttingSurface& cutter, const Arrangement& arrangement);

/// For each polygon that is left of a mesh face the region of the surface that lies on it, or -1.
/// Only faces of the mesh's own boundary are asked, and triangles exactly in their plane that look
/// the same way: the moved surface is outside the mesh there. A polygon on which several regions
/// lie gets one of them. Cost: O(pairs of boundary faces and triangles that may touch), in
/// parallel.
std::vector<Label> touchedRegions(const PolyMesh& mesh,
                                  const Probe& probe,
                                  const CuttingSurface& cutter,
                                  const PointPositions& positions,
                                  const FaceLoops& loops);

} // namespace polymesh
