// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/keptZones.h"
#include "libpolymesh/mps/midPointSubdivision.h"
#include "libpolymesh/mps/splitFaces.h"

#include <span>
#include <utility>
#include <vector>

namespace polymesh {

/// What helps cells that nothing better helps, step by step until all of their parts are
/// tetrahedra, which always divide well.
struct Remedies {
    std::vector<FacePieces> faces;               // to split into triangles, ascending
    std::vector<Vec3> points;                    // [m] their new points, from mesh.pointCount() on
    std::vector<CellCones> cells;                // to cut, ascending; all their faces are triangles
    std::vector<std::pair<Label, Label>> joined; // cells to join, in no order

    bool empty() const { return faces.empty() && cells.empty() && joined.empty(); }
};

/// Finds the next step for each of `cells` (ascending), whose edges do not bend:
/// (1) where a point sees all triangles of the faces, these are split, by diagonals or, if that
/// does not do, from their middles; (2) a cell with triangles only becomes tetrahedra over such a
/// point, or is cut into pieces that have one (starPieces.h); (3) a cell that can not be cut so is
/// joined with a neighbour when both together can: flaps without thickness go, and tips that turn
/// inside out. Steps of one call do not disturb each other.
/// Cost: about 20 us a cell, some ms where it must be cut or joined; parallel.
Remedies remediesOf(const PolyMesh& mesh,
                    const SubdivisionPlan& plan,
                    std::span<const Label> cells,
                    const KeptZones& zones = {});

/// Those of `cells` (ascending) that are stars once their faces are triangles. Cost: some 20 us a
/// cell.
std::vector<Label>
starCells(const PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> cells);

/// Neighbours to join these cells (ascending) with, the best for each as in (3); no cell is in two
/// pairs. Cost: some ms a cell.
std::vector<std::pair<Label, Label>> partnersOf(const PolyMesh& mesh,
                                                const SubdivisionPlan& plan,
                                                std::span<const Label> cells,
                                                const KeptZones& zones = {});

/// The mesh with these steps taken. Cost: linear.
PolyMesh withRemedies(PolyMesh mesh, const Remedies& remedies);

} // namespace polymesh
