// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trimCell/cellGraph.h"

#include <cstdint>
#include <vector>

namespace polymesh {

/// One step of a loop: along an edge of the graph from one of its points to the other.
struct LoopStep {
    Label edge = -1;
    std::uint8_t side = 0; // which of the edge's carriers the loop lies on
    std::uint8_t from = 0; // which of the edge's points the step begins at
};

/// An outline of a face of the trimmed cell.
struct GraphLoop {
    Label carrier = -1;
    std::vector<LoopStep> steps;
};

/// The other way round.
void turn(GraphLoop& loop);

/// Finds the faces of a trimmed cell from its nodes and edges, as closed loops, and turns them so
/// that they run counter-clockwise seen from outside (holes clockwise).
///
/// Every edge is known to lie on two faces, and with exact arithmetic every node has just two edges
/// of a face. So the shortest loop through an edge on a carrier is the only one, and the weights by
/// which the paper's search tells faces from other loops (equations 6 and 7) are not needed.
/// Outlines and surface edges tell the direction of their loops; it is carried over segments to the
/// others, since two faces run along their edge in opposite directions.
/// Throws InputError where a node has other than two edges of a face, or directions contradict each
/// other: the surface intersects itself there. Cost: O(n log n) in the edges of the cell.
std::vector<GraphLoop> findLoops(const CellInputs& inputs, const CellGraph& graph);

} // namespace polymesh
