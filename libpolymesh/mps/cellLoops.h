// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/bends.h"

#include <span>
#include <vector>

namespace polymesh {

using Polygon = std::vector<Label>;

/// An edge of a cell, and its faces (places in the list of loops) on either side: `left` runs from
/// a to b in its outward loop.
struct CellEdge {
    Label a;
    Label b;
    int left;
    int right;
};

/// The faces of a cell as they run round seen from outside.
std::vector<Polygon> outwardLoops(const PolyMesh& mesh, const Rows<Label>& faces, Label cell);

/// The edges of a closed set of loops, by their lower and then higher point.
std::vector<CellEdge> edgesOf(std::span<const Polygon> loops);

/// Whether every edge is there once in either sense.
bool isClosed(std::span<const Polygon> loops);

/// A polyhedron as a mesh of one cell, and those of its edges that bend.
struct LoneCell {
    PolyMesh mesh;
    Bends bends;
};

/// The polyhedron that these outward loops enclose; a label of -1 stands for `further`.
LoneCell loneCell(const PolyMesh& mesh,
                  const Bends& bends,
                  std::span<const Polygon> loops,
                  const Vec3& further);

} // namespace polymesh
