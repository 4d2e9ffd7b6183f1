// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the tests of the ways to adjust nodes share.

#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/surface/triangleBoxes.h"
#include "libpolymesh/trim/adjustGuard.h"
#include "libpolymesh/trim/adjustNodes.h"

#include <algorithm>

namespace polymesh::test {

inline AdjustedNodes
adjust(PolyMesh& mesh, const TriSurface& surface, const AdjustOptions& options) {
    const CuttingSurface cutter{&surface, pairEdges(surface), triangleBoxes(surface)};
    return adjustNodes(mesh, cutter, findFeatures(surface, cutter.edges, 0.5236), options);
}

/// The smallest part of any cell, of what is a part of a cube.
inline double worstCell(const PolyMesh& mesh) {
    const Rows<Label> faces = cellFaces(mesh);
    double worst = 1;
    for (Label c = 0; c < mesh.cellCount; ++c)
        worst = std::min(worst, smallestPart(mesh, c, faces[c], 0).smallest);
    return worst;
}

} // namespace polymesh::test
