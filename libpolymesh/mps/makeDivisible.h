// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/midPointSubdivision.h"
#include "libpolymesh/mps/remedies.h"

#include <cstdint>

namespace polymesh {

/// What was done to a mesh so that it divides well.
struct DivisibleCounts {
    Label firstInverted = 0; // cells with inverted parts before anything was done
    Label splitFaces = 0;    // faces replaced by pieces
    Label conedCells = 0;    // cells replaced by cones over a new point
    Label cutCells = 0;      // cuts of concave cells
    Label joinedCells = 0;   // cells joined with a neighbour
    Label newCells = 0;      // by which the mesh has grown
    Label movedPoints = 0;   // new and hanging points inside that left their places
};

/// Whether hexahedra that need no division will be left alone (keepHexahedra.h).
enum class Hexahedra : std::uint8_t { divided, kept };

/// A mesh and a plan of its subdivision with as few inverted parts as could be reached.
struct Divisible {
    PolyMesh mesh;
    SubdivisionPlan plan;
    Bends bends; // points that are middles of edges and no nodes (bends.h)
    DivisibleCounts counts;
};

/// Prepares a mesh for mid-point subdivision: plans it, and changes the cells that would have an
/// inverted part: bends become middles of edges, concave cells are cut along loops, faces are split
/// by diagonals, cells replaced by cones, in the end by tetrahedra, and joined with a neighbour
/// where nothing else helps; whichever comes first (docs/mpsSplit.md). What can not be helped is
/// left in plan.inverted. Cells that divide well as they are, are not touched, unless they share a
/// face that had to be split. The points of warped boundary faces are such that the volume stays.
/// Cost: twice planSubdivision, and about 1 ms and core for each cell in need: only they and their
/// neighbours are looked at in between (meshRegion.h). The same for any number of threads.
Divisible makeDivisible(PolyMesh mesh,
                        const RemedyMeans& means = {},
                        Hexahedra hexahedra = Hexahedra::divided);

} // namespace polymesh
