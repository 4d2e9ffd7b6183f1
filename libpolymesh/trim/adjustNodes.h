// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/surface/features.h"
#include "libpolymesh/trim/adjustOptions.h"
#include "libpolymesh/trim/arrangement.h"

#include <vector>

namespace polymesh {

/// A node that was put onto the surface. In the mesh it stands a little inside of it while that is
/// trimmed, so that edges and faces between such nodes are inside as a whole, wherever rounding,
/// the facets of the surface, and its bend would have them cross it. settleNodes.h then puts it
/// where it belongs.
struct SettledNode {
    Label node = -1;  // of the mesh
    Vec3 place;       // on the surface [m]
    double depth = 0; // how far inside it stands [m]
    AdjustTarget target = AdjustTarget::face;
};

/// A node that was moved, and where to [m].
struct MovedNode {
    Label node = -1;
    Vec3 place;
};

struct AdjustedNodes {
    std::vector<MovedNode> moved;     // by ascending node
    std::vector<SettledNode> settled; // those of them that are on the surface
    AdjustCounts counts;
};

/// Moves the nodes that are nearer to the surface than a fraction of the shortest edge at them:
/// onto it (project: onto its corners, one node each; else its feature edges; else its triangles),
/// or to that distance from it (repel; avoid, which is also for edges and faces: avoidFeatures.h).
///
/// Nodes of the mesh's own boundary stay in the planes of the boundary faces round them. Nodes that
/// hang on an edge or a face of a larger cell are not moved but keep their place on it. A move is
/// taken back, the least important first, as long as a cell has a part that is too small: see
/// smallestPart in adjustGuard.h.
/// Equal for any number of threads. Cost: a few passes over the mesh, as findProbe, and about a
/// microsecond for a node near the surface. Source: the paper, section 2; docs/adjust.md.
AdjustedNodes adjustNodes(PolyMesh& mesh,
                          const CuttingSurface& surface,
                          const SurfaceFeatures& features,
                          const AdjustOptions& options);

} // namespace polymesh
