// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mesh/topology.h"

#include <vector>

namespace polymesh {

/// The edges of a mesh, numbered by their lower and then their higher point.
struct NumberedEdges {
    std::vector<Edge> points;    // lower label first
    std::vector<Label> ofCorner; // beside mesh.faces.values: the edge to the face's next point

    Label size() const { return toLabel(points.size()); }
};

/// Numbers the edges of all faces. Requires: labels in range (validate.h).
/// Cost: O(face corners), parallel but for two passes over them; 12 bytes a corner at most.
NumberedEdges numberEdges(const PolyMesh& mesh);

} // namespace polymesh
