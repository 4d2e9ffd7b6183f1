// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/bends.h"
#include "libpolymesh/mps/numberedEdges.h"
#include "libpolymesh/mps/partGeometry.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace polymesh {

// Generalised mid-point subdivision (paper, section 3.2): every cell is divided with the middles of
// its edges, a point a face and a point a cell; each node of valence 3 becomes a hexahedron, each
// of another valence v becomes 2v pyramids. Faces are divided in the same way for both their cells,
// so the result is conformal.

/// How a mesh is to be divided: where the new points are, and how the parts are numbered.
/// Laws: (1) the parts of cell c are [firstPart[c], firstPart[c + 1]), its further points
/// [firstApex[c], firstApex[c + 1]) counted from layout.firstApex, in the order of CellCorners;
/// (2) partAcross[i], beside mesh.faces.values, is the part of the face's neighbour, or of its
/// owner for a boundary face, at that corner, counted from the cell's first.
struct SubdivisionPlan {
    NumberedEdges edges;
    Rows<Label> cellFaces;
    PointLayout layout;
    std::vector<Vec3> points; // [m] of the divided mesh
    std::vector<Label> firstPart;
    std::vector<Label> firstApex;
    std::vector<std::int32_t> partAcross;
    std::int64_t hexahedra = 0;
    std::int64_t pyramids = 0;
    std::vector<Label> inverted; // cells with an inverted part (partGeometry.h), ascending

    PartPoints parts(const CellCorners& corners, Label cell) const;
};

/// Numbers the parts and places the new points: the middles of the edges, OpenFOAM's centres of
/// faces, and of cells where no part is inverted by it, else another point (partGeometry.h). Edges
/// that bend have their bend as middle, and are so seen by the centres of faces.
/// Requires a valid mesh (validate.h). Throws InputError when the labels of the divided mesh do
/// not fit. Cost: O(face corners), about 0.5 us a part and core.
SubdivisionPlan planSubdivision(const PolyMesh& mesh, const Bends& bends = {});

/// The cells that the plan as it is divides into parts of which one is inverted, among `cells`.
std::vector<Label>
invertedCells(const PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> cells);

/// Divides a mesh as planned; takes the plan's points. The parts of a cell follow each other, as do
/// those of a boundary face. Patches keep their places; a part is in the zones of its cell or face,
/// a new point in those of all the points that it is made of.
/// The same bytes for any number of threads. Cost: as for planning.
PolyMesh divide(const PolyMesh& mesh, SubdivisionPlan&& plan);

/// What theory demands of the division of a mesh, from counting corners at points.
struct SubdivisionCounts {
    std::int64_t hexahedra = 0; // nodes of valence 3
    std::int64_t pyramids = 0;  // 2v for each node of another valence v (paper, equation 10)
};

SubdivisionCounts demandedCounts(const PolyMesh& mesh);

/// The same for the cells for which `isDivided` says so.
SubdivisionCounts demandedCounts(const PolyMesh& mesh, const std::function<bool(Label)>& isDivided);

} // namespace polymesh
