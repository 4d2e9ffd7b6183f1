// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/loops.h"
#include "libpolymesh/trim/simplify.h"

#include <array>
#include <vector>

namespace polymesh {

/// The probed cells as they will be: connected pieces of the cell inside the surface.
struct TrimmedCells {
    std::vector<Label> localCell; // new cell -> local cell, ascending
    std::vector<std::array<Label, 2>>
        polygonCells;                 // polygon of a mesh face -> new owner, neighbour
    std::vector<Label> boundaryCells; // boundary polygon -> new cell

    Label cellCount() const { return toLabel(localCell.size()); }
};

/// 3D: divides what is left of each probed cell into its connected pieces, which become cells of
/// their own; a void inside a piece stays part of it. Checks that every edge of a cell is used
/// twice, in opposite directions; throws WorkError where not (a bug, never the input).
/// Cost: O(n log n) in the edges of each cell.
TrimmedCells divideCells(const Probe& probe,
                         const PointPositions& positions,
                         const FaceLoops& loops,
                         const BoundaryPolygons& boundary);

} // namespace polymesh
