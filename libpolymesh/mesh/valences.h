// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"

#include <cstddef>

namespace polymesh {

/// Nodes of cells by the number of edges of the cell that meet there. A point counts once for each
/// cell that has it as a node.
struct ValenceCounts {
    std::size_t bends = 0;     // two edges: no node of a polyhedron, but a bend of its edge
    std::size_t trivalent = 0; // three
    std::size_t more = 0;

    /// Of the nodes, bends left out; 1 when there are none.
    double trivalentShare() const {
        const auto nodes = static_cast<double>(trivalent + more);
        return nodes > 0 ? static_cast<double>(trivalent) / nodes : 1;
    }
};

/// Counts the nodes of the cells that have a face on the boundary from face `first` on.
/// Requires: a valid mesh. Cost: a pass over the faces, and O(corners) of those cells.
ValenceCounts countValences(const PolyMesh& mesh, Label first);

} // namespace polymesh
