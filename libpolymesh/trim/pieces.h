// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/arrangement.h"

#include <vector>

namespace polymesh {

/// The parts of surface triangles inside each probed cell, as polygons of points of the
/// arrangement, in the direction of their triangle.
/// Laws: (1) pieces of a cell are in ascending order of their triangles; (2) an interval of a
/// surface edge that bounds a piece bounds just one other piece, in the same cell.
struct CellPieces {
    Rows<Label> polygons; // point labels
    /// Beside polygons.values: the interval of a surface edge on which the polygon goes on to its
    /// next point, or -1 where it runs on a facet of the cell.
    std::vector<Label> intervals;
    std::vector<Label> triangle; // one per piece
    std::vector<Label> offsets;  // local cell -> its pieces: [offsets[c], offsets[c + 1])
};

/// Interval k of a surface edge (between its k-th and (k+1)-th item: start, pierces, end) has the
/// label offset + edge + k, with the edge's offset in Arrangement::surfacePierces.
inline Label intervalLabel(const Arrangement& arrangement, Label edge, Label k) {
    return arrangement.surfacePierces.offsets[index(edge)] + edge + k;
}

/// For each interval label, the surface edge that it belongs to.
std::vector<Label> edgeOfIntervals(const Arrangement& arrangement);

/// 3D: walks each triangle's part in each cell, from facet to facet and along the triangle's edges.
/// Throws WorkError where a walk does not close (a bug, never the input). Cost: O(segments).
CellPieces
cutTriangles(const Probe& probe, const CuttingSurface& cutter, const Arrangement& arrangement);

} // namespace polymesh
