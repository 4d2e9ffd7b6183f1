// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/bends.h"
#include "libpolymesh/mps/midPointSubdivision.h"

#include <span>
#include <vector>

namespace polymesh {

/// A face and the polygons that take its place, which run the same way round.
struct FacePieces {
    Label face = -1;
    std::vector<std::vector<Label>> pieces;
};

/// The mesh with these faces, ascending, replaced by their pieces, which stay in the patches and
/// zones of the face and between its cells. Cost: linear.
PolyMesh withPieces(PolyMesh mesh, std::span<const FacePieces> faces);

/// The faces of cells, ascending.
std::vector<Label> facesOf(const SubdivisionPlan& plan, std::span<const Label> cells);

/// How faces of cells with inverted parts may be split by diagonals, for both their cells.
///
/// A corner of a face is judged by the scaled volume that its two edges span with the direction
/// into the cell: the inward normal of an internal face, the cell's point for a boundary face,
/// which may be warped. Below zero it is concave: the pyramid or hexahedron on it would be
/// inverted.
/// A point of valence 2 is concave in one of its two faces unless it is straight, so that this is
/// where the bend goes on: an edge across the face.
struct FaceSplitRule {
    double least = 1e-3; // corners with a smaller value are split
    /// Judges internal faces against the points of those of their cells that are to be helped, as
    /// warped ones need.
    bool isStrict = false;
};

/// Finds the pieces of faces of `cells` (ascending) with corners to split: diagonals that leave the
/// fewest of them, the best corners among equals. Diagonals run inside the face and
/// join no points that are joined already.
std::vector<FacePieces> piecesOfFaces(const PolyMesh& mesh,
                                      const Bends& bends,
                                      const SubdivisionPlan& plan,
                                      std::span<const Label> cells,
                                      const FaceSplitRule& rule);

/// The triangles from OpenFOAM's centres of some faces (ascending), which take part as points from
/// mesh.pointCount() on: together they hold the volume that the face holds to OpenFOAM.
std::vector<FacePieces> fansOf(const PolyMesh& mesh, std::span<const Label> faces);

} // namespace polymesh
