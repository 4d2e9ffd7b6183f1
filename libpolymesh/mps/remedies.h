// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/keptZones.h"
#include "libpolymesh/mps/midPointSubdivision.h"
#include "libpolymesh/mps/splitFaces.h"
#include "libpolymesh/surface/tetMesh.h"

#include <span>
#include <utility>
#include <vector>

namespace polymesh {

/// What may be used and has to be minded.
struct RemedyMeans {
    KeptZones zones;
    Tetrahedraliser tetrahedralise; // of cells of which no point sees all faces; may be empty
};

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
/// point, else those that `tetrahedralise` fills it with (triangleHull.h); (3) a cell whose
/// triangles cross, or that is flat, is joined with a neighbour or two where that leaves less of
/// it: flaps without thickness go, and tips that turn inside out. Steps of one call do not disturb
/// each other. Cost: about 20 us a cell, some ms where it must be filled or joined; parallel but
/// for the filling.
Remedies remediesOf(const PolyMesh& mesh,
                    const SubdivisionPlan& plan,
                    std::span<const Label> cells,
                    const RemedyMeans& means = {});

/// Those of `cells` (ascending) that are stars once their faces are triangles. Cost: some 20 us a
/// cell.
std::vector<Label>
starCells(const PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> cells);

/// Those of `cells` (ascending) that neither are stars nor have triangles that do not cross.
/// Cost: some 100 us a cell.
std::vector<Label>
crossedCells(const PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> cells);

/// Which neighbour a cell is joined with.
enum class Partner {
    closest,  // that it shares most area with
    uncrossed // one or two with which fewest triangles cross
};

/// Neighbours to join these cells (ascending) with; no cell is in two groups, of which the first is
/// in a pair with each other one (joinCells.h). Cost: some ms a cell.
std::vector<std::pair<Label, Label>> partnersOf(const PolyMesh& mesh,
                                                const SubdivisionPlan& plan,
                                                std::span<const Label> cells,
                                                const KeptZones& zones = {},
                                                Partner which = Partner::closest);

} // namespace polymesh
