// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/adjustMesh.h"

#include "libpolymesh/surface/edges.h"
#include "libpolymesh/surface/features.h"
#include "libpolymesh/surface/orient.h"
#include "libpolymesh/surface/triangleBoxes.h"
#include "libpolymesh/trim/adjustNodes.h"

#include <utility>

namespace polymesh {

AdjustCounts adjustMesh(PolyMesh& mesh, TriSurface surface, const TrimOptions& options) {
    // Nodes on the surface are repelled out of the domain.
    if (options.keep == Keep::outside)
        for (auto& triangle : surface.triangles)
            std::swap(triangle[1], triangle[2]);
    const CuttingSurface cutter{&surface, pairEdges(surface), triangleBoxes(surface)};
    const SurfaceFeatures features = findFeatures(surface, cutter.edges, options.featureAngle);
    AdjustOptions adjust = options.adjust;
    adjust.isForTrim = false;
    return adjustNodes(mesh, cutter, features, adjust).counts;
}

} // namespace polymesh
