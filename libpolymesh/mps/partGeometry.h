// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/cellCorners.h"

#include <span>
#include <vector>

namespace polymesh {

/// How the points of a divided mesh are numbered: those of the mesh, then one an edge, one a face,
/// one a cell, and the further points of the nodes of other valence than 3, cell by cell.
struct PointLayout {
    Label firstEdge = 0;
    Label firstFace = 0;
    Label firstCell = 0;
    Label firstApex = 0;
};

/// A cell that is loaded, with the points of its parts.
struct PartPoints {
    const CellCorners& cell;
    const PointLayout& layout;
    std::span<const Vec3> points; // of the divided mesh, without further points
    std::span<const Vec3> apices; // of the cell, one a node of other valence than 3
    Label label = -1;             // of the cell

    const Vec3& middle(Label edge) const { return points[index(layout.firstEdge + edge)]; }

    const Vec3& ofFace(Label face) const { return points[index(layout.firstFace + face)]; }

    const Vec3& centre() const { return points[index(layout.firstCell + label)]; }
};

/// A corner of a part is inverted when its Jacobian, the determinant of its three edges, is not
/// more than this times the product of their lengths: a part that is flat there to rounding counts.
inline constexpr double leastJacobian = 1e-9;

/// The least scaled Jacobian (determinant by product of edge lengths, in [-1, 1]) of the parts of a
/// cell: at the 8 corners of each hexahedron, at the 4 corners of each pyramid's base. Those of a
/// base are the volumes of the four tetrahedra that two of its sides and the apex span.
double leastScaledJacobian(const PartPoints& parts);

/// Whether a part of the cell is inverted at a corner. As the above against leastJacobian, faster.
bool hasInvertedPart(const PartPoints& parts);

/// A point from which the faces of the hexahedra of a cell are seen as they must be, so that no
/// corner that it takes part in is inverted; `start` where there is none or when it is one.
Vec3 cellPoint(const PartPoints& parts, const Vec3& start);

/// The further points of the cell's nodes of other valence than 3, added to `apices`: the mean of
/// the corners of the node's 2v-hedron, or, where a pyramid would be inverted, a point from which
/// all are right, if there is one.
void addApices(const PartPoints& parts, std::vector<Vec3>& apices);

} // namespace polymesh
