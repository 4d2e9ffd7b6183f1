// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mesh/topology.h"

#include <span>
#include <vector>

namespace polymesh {

/// An edge that goes from one of its ends to the other by way of a point.
struct Bend {
    Edge ends; // lower label first
    Vec3 at;   // [m]
};

/// Bends by their ends, ascending; no two have the same.
using Bends = std::vector<Bend>;

/// Takes points that only two edges meet at out of a mesh: where the line in which a face meets
/// the surface bends, for one. They are no nodes of any polyhedron, so that mid-point subdivision
/// has no use for them as nodes, but they do as the middles of the edges between their neighbours.
/// Points stay where an edge between their neighbours exists, where a face would have less than
/// three corners left, and next to one that is taken. Other points keep their order; zones of
/// points lose those taken. Cost: linear.
Bends takeBends(PolyMesh& mesh);

/// The opposite: the bends become points again, after the others. Cost: linear.
PolyMesh withBendsAsPoints(PolyMesh mesh, const Bends& bends);

/// The bend between two points; null where the edge is straight. Cost: O(log bends).
const Bend* findBend(const Bends& bends, Label a, Label b);

} // namespace polymesh
