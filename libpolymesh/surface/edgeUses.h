// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/rows.h"
#include "libpolymesh/surface/triSurface.h"

#include <cstdint>
#include <span>

namespace polymesh {

/// One side of a triangle, filed under its lower point.
struct SurfaceEdgeUse {
    Label upper;        // the higher of the side's two points
    Label triangle;     //
    std::int8_t corner; // the side runs from this corner to the next
    bool ascending;     // the side runs from the lower to the higher point
};

/// All sides of a surface's triangles, one row for each point: the sides of which it is the lower
/// point, sorted by (upper, triangle).
Rows<SurfaceEdgeUse> collectEdgeUses(const TriSurface& surface);

/// Calls body(uses) for the uses of each undirected edge in a row of collectEdgeUses.
template<class Body>
void forEachEdge(std::span<const SurfaceEdgeUse> row, Body&& body) {
    for (std::size_t first = 0; first < row.size();) {
        std::size_t last = first + 1;
        while (last < row.size() && row[last].upper == row[first].upper)
            ++last;
        body(row.subspan(first, last - first));
        first = last;
    }
}

} // namespace polymesh
