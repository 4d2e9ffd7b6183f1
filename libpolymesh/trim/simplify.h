// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/loops.h"
#include "libpolymesh/trim/pieces.h"

#include <cstdint>
#include <span>
#include <vector>

namespace polymesh {

/// How much of the surface a cell keeps.
struct Fidelity {
    bool isExact = false; // keeps all that is not exactly flat
    /// Largest distance between the surface and what is kept of it in each probed cell [m].
    std::span<const double> tolerances;
    /// Per surface edge, see edgeSharpness.
    std::vector<double> sharpness;
    std::vector<char> isCorner; // per surface point; corners are kept, but for blunt cells
    double featureAngle = 0;    // [rad] sharper edges are kept, likewise
    /// One per probed cell, or none: 1 where corners and sharp edges are not kept for their own
    /// sake.
    std::vector<std::uint8_t> isBlunt{};
};

/// The surface in each cell as polygons: the boundary faces to be.
struct BoundaryPolygons {
    Rows<Label> polygons;       // point labels, normals out of the domain
    std::vector<Label> region;  // one per polygon
    std::vector<Label> offsets; // local cell -> its polygons
};

/// Joins the pieces of each cell across edges that need not be kept, drops the points that this
/// leaves between two faces, here and in the polygons of `loops`, and returns the joined faces.
///
/// A decision about a pierce is taken once for the two cells that share it, so that cells stay
/// closed. Where joining would make an invalid cell (a face that is not a disc or has fewer than
/// three points, two faces with the same points, fewer than four faces, no volume) or would miss
/// the surface by more than the deviation, more is kept in that cell, up to everything. Source:
/// paper, section 2.3 (reconstruction from node information); the deviation test is ours.
BoundaryPolygons simplify(const Intersection& cut,
                          const PointPositions& positions,
                          const CellPieces& pieces,
                          const Fidelity& fidelity,
                          FaceLoops& loops);

} // namespace polymesh
