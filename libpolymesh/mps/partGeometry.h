// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/cellCorners.h"

#include <array>
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
    std::span<const Vec3> points; // of the divided mesh, at least those below firstApex
    std::span<const Vec3> apices; // of the cell, one a node of other valence than 3
    Label firstApex = 0;          // label of the first of them
    Label label = -1;             // of the cell

    Label middle(Label edge) const { return layout.firstEdge + edge; }

    Label ofFace(Label face) const { return layout.firstFace + face; }

    Label centre() const { return layout.firstCell + label; }

    const Vec3& at(Label point) const {
        return point < layout.firstApex ? points[index(point)] : apices[index(point - firstApex)];
    }
};

/// A corner of a part and its three neighbours in the part: a tetrahedron with det(b - a, c - a,
/// d - a) > 0 unless the part is inverted there.
using PartCorner = std::array<Label, 4>;

/// The corners of all parts of a cell: the 8 of each hexahedron, the 4 of each pyramid's base,
/// which are the four tetrahedra that two sides of the base and the apex span.
void addPartCorners(const PartPoints& parts, std::vector<PartCorner>& corners);

/// A corner of a part is inverted when its Jacobian, the determinant of its three edges, is not
/// more than this times the product of their lengths: a part that is flat there to rounding counts.
inline constexpr double leastJacobian = 1e-9;

/// The least scaled Jacobian (determinant by product of edge lengths, in [-1, 1]) at the corners of
/// the parts of a cell.
double leastScaledJacobian(const PartPoints& parts);

/// Whether three edges from a corner of a part have a Jacobian of leastJacobian or less.
bool isInverted(const Vec3& a, const Vec3& b, const Vec3& c);

/// Whether a part of the cell is inverted at a corner.
bool hasInvertedPart(const PartPoints& parts);

/// Whether the cell has an inverted part wherever its point and the further ones are: a node of two
/// edges, or an inverted corner at its surface.
bool isNeverRight(const PartPoints& parts);

/// Whether a part of a cell that is not never right is inverted at a corner.
bool hasInvertedInside(const PartPoints& parts);

/// A point from which the faces of the hexahedra of a cell are seen as they must be, so that no
/// corner that it takes part in is inverted; `start` where there is none or when it is one.
Vec3 cellPoint(const PartPoints& parts, const Vec3& start);

enum class Apices { means, best };

/// The further points of the cell's nodes of other valence than 3, added to `apices`: the mean of
/// the corners of the node's 2v-hedron, or the best: where a pyramid would be inverted with that, a
/// point from which all are right, if there is one.
void addApices(const PartPoints& parts, Apices which, std::vector<Vec3>& apices);

} // namespace polymesh
