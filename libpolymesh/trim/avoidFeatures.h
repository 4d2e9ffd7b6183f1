// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/trim/nearNodes.h"
#include "libpolymesh/trim/nodeMove.h"
#include "libpolymesh/trim/surfaceTargets.h"

#include <vector>

namespace polymesh {

/// Changes moves away from the surface (findMoves) such that also edges of the mesh keep away from
/// the feature edges of the surface, and faces of the mesh from its corners: by 0.4 times
/// `options.distance` of the shortest edge there. Moves that are in each other's way are made in
/// turn, some rounds of all, so that not all get what they want. No node goes farther than 1.4
/// times the distance from where it is. Returned by ascending node.
/// `near` must hold all nodes of faces near the surface. The same with any number of threads.
/// Cost: a pass over the faces, then some microseconds for an edge near a feature edge.
std::vector<NodeMove> avoidFeatures(const PolyMesh& mesh,
                                    const SurfaceTargets& targets,
                                    const std::vector<NearNode>& near,
                                    const AdjustOptions& options,
                                    const std::vector<NodeMove>& moves);

/// How many edges and faces of the mesh are nearer than that.
CloseCounts countClose(const PolyMesh& mesh,
                       const SurfaceTargets& targets,
                       const std::vector<NearNode>& near,
                       const AdjustOptions& options);

} // namespace polymesh
