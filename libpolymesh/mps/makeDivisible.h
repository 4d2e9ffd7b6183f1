// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/midPointSubdivision.h"

namespace polymesh {

/// A mesh and a plan of its subdivision with as few inverted parts as could be reached.
struct Divisible {
    PolyMesh mesh;
    SubdivisionPlan plan;
    Bends bends;             // points that are middles of edges and no nodes (bends.h)
    Label firstInverted = 0; // cells with inverted parts before anything was done
    Label splitFaces = 0;    // faces replaced by pieces
    Label conedCells = 0;    // cells replaced by cones over a new point
    Label cutCells = 0;      // cuts of concave cells (quality/convexDecomposition.h)
    Label newCells = 0;      // by which the mesh has grown
    Label movedPoints = 0;   // new and hanging points inside that left their places
};

/// Prepares a mesh for mid-point subdivision: plans it, and where a cell would have an inverted
/// part splits its bent faces by diagonals, moves hanging points, splits its straight faces, and
/// replaces the cell by cones, whichever comes first to help. What can not be helped is left in
/// plan.inverted. Cells that divide well as they are, are not touched, unless they share a face
/// that had to be split.
/// Cost: as planSubdivision, and about 1 ms for each cell in need.
Divisible makeDivisible(PolyMesh mesh);

} // namespace polymesh
