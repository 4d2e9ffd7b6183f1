// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/trim/nearNodes.h"
#include "libpolymesh/trim/nodeMove.h"
#include "libpolymesh/trim/surfaceTargets.h"

#include <vector>

namespace polymesh {

/// How near, in shortest edges, a node must be to a triangle to be moved.
double farthestReach(const AdjustOptions& options);

/// The moves that bring the near nodes onto the surface (project), or away from it (repel, avoid),
/// by ascending node. Nodes that are exactly where they should be have none.
/// Cost: see adjustNodes.
std::vector<NodeMove> findMoves(const PolyMesh& mesh,
                                const SurfaceTargets& targets,
                                const std::vector<NearNode>& near,
                                const AdjustOptions& options);

} // namespace polymesh
