// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/surface/triSurface.h"
#include "libpolymesh/trim/nodeFreedom.h"

#include <vector>

namespace polymesh {

/// A point of the mesh near the surface.
struct NearNode {
    Label node = -1;
    double size = 0;     // shortest edge at the node [m]
    NodeFreedom freedom; // what the boundary faces round it leave
};

/// The points within `reach` shortest edges of a bin with triangles, ascending; with `wholeFaces`
/// also all other points of the faces near such bins.
/// Cost: a pass over the points, and one over the faces for `wholeFaces`; in parallel.
std::vector<NearNode>
findNearNodes(const PolyMesh& mesh, const TriSurface& surface, double reach, bool wholeFaces);

} // namespace polymesh
