// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/surface/features.h"
#include "libpolymesh/trim/adjustOptions.h"
#include "libpolymesh/trim/arrangement.h"

#include <vector>

namespace polymesh {

/// Where a node of the mesh should go.
struct NodeMove {
    Label node = -1;
    AdjustTarget target = AdjustTarget::face;
    Vec3 place;      // [m]
    Vec3 inward;     // unit vector into the domain; zero where there is none, or no way to go
    double size = 0; // shortest edge at the node [m]
    double way = 0;  // how far it moves, fraction of size
};

/// The moves that bring the near nodes onto the surface or away from it, by ascending node. Nodes
/// that are exactly where they should be have none.
/// Cost: see adjustNodes.
std::vector<NodeMove> findMoves(const PolyMesh& mesh,
                                const CuttingSurface& surface,
                                const SurfaceFeatures& features,
                                const AdjustOptions& options);

} // namespace polymesh
