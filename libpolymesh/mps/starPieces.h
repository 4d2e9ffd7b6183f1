// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/triangulate.h"

#include <optional>
#include <span>
#include <vector>

namespace polymesh {

/// A triangle inside a polyhedron between two of its pieces, seen from outside of `inside`.
struct PieceWall {
    Triangle triangle;
    int inside = -1;
    int outside = -1;
};

/// A polyhedron cut into pieces of which each has a point that sees all its triangles.
struct StarPieces {
    std::vector<int> pieceOf;  // beside the triangles of the polyhedron
    std::vector<Vec3> centres; // [m] one a piece
    std::vector<PieceWall> walls;
};

/// Cuts a polyhedron with triangles for faces along loops of its own edges until every piece has a
/// point that sees all its triangles (paper, section 3.2, with walls of triangles, so that loops
/// need not be flat). An edge with four triangles is a loop too, and needs no wall.
/// The triangles run round as seen from outside; `mayJoin` tells where walls may have new edges.
/// None when that takes more than
/// `mostPieces`. Cost: about 10 us for a star, else some ms.
std::optional<StarPieces> starPieces(std::span<const Vec3> points,
                                     std::span<const Triangle> triangles,
                                     const MayJoin& mayJoin,
                                     int mostPieces = 24);

} // namespace polymesh
