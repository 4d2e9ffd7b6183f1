// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/box.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace polymesh {

/// A box divided evenly into cells[0] x cells[1] x cells[2] hexahedra.
struct CartesianBox {
    Box box; // [m]
    std::array<Label, 3> cells{};

    bool operator==(const CartesianBox&) const = default;
};

/// The least margin that keeps the extremes of a surface off the grid planes: a quarter of a cell.
/// The box that boxAround makes with it has its outermost plane 1/4 to 3/4 of a cell outside, so
/// every other plane is at least 1/4 of a cell away as well.
constexpr double defaultMargin(double cellSize) {
    return 0.25 * cellSize;
}

/// The smallest box of cubes of `cellSize` [m] that leaves at least `margin` [m] round
/// `surfaceBox`, with the same centre. A surface flat in a direction gets cells there too.
/// Throws InputError when the box is empty or not finite, cellSize is not positive, margin is
/// negative, or the mesh would be too large for the labels.
CartesianBox boxAround(const Box& surfaceBox, double cellSize, double margin);

/// The mesh of a CartesianBox, every entity by formula, so that it can be written in pieces
/// without being held in memory.
/// Laws: (1) cell (i, j, k) has the label i + nx (j + ny k), point (i, j, k) likewise with one
/// more in each direction; (2) the points of a grid plane have bit for bit the same coordinate,
/// min + (max - min) i / n, and the outermost planes are those of the box; (3) the faces are in
/// upper-triangular order, then the patches xMin, xMax, yMin, yMax, zMin, zMax.
class CartesianMesh {
public:
    struct Face {
        std::array<Label, 4> points{};
        Label owner = -1;
        Label neighbour = -1; // -1: boundary
    };

    /// Throws InputError when the box is empty or not finite, a number of cells is not positive,
    /// neighbouring planes coincide in floating point, or labels would overflow.
    explicit CartesianMesh(const CartesianBox& box);

    Label cellCount() const { return nx_ * ny_ * nz_; }

    Label pointCount() const { return (nx_ + 1) * (ny_ + 1) * (nz_ + 1); }

    Label internalFaceCount() const { return internalBefore(ny_ * nz_); }

    Label faceCount() const {
        return internalFaceCount() + 2 * (nx_ * ny_ + ny_ * nz_ + nx_ * nz_);
    }

    Vec3 point(Label label) const;

    std::vector<Patch> patches() const;

    /// Calls visit(label, face) for the faces [first, last) in order. Cost: constant a face.
    template<class Visit>
    void visitFaces(Label first, Label last, Visit&& visit) const;

private:
    Label nx_;
    Label ny_;
    Label nz_;
    std::array<std::vector<double>, 3> planes_; // coordinates of the grid planes, by direction

    Label pointLabel(Label i, Label j, Label k) const {
        return i + (nx_ + 1) * (j + (ny_ + 1) * k);
    }

    Label internalBefore(Label row) const;
    Label rowOfInternal(Label face) const;
    template<class Visit>
    void visitRow(Label row, Label offset, Label first, Label last, Visit&& visit) const;
    Face boundaryFace(int side, Label local) const;
    Label sideSize(int side) const;
    std::array<Label, 4> facePoints(int axis, const std::array<Label, 3>& ijk, bool upper) const;
};

/// The whole mesh in memory. Cost: linear, in parallel; 110 bytes a cell.
PolyMesh cartesianMesh(const CartesianBox& box);

/// The faces [first, last) of a row of cells, of which the first one is the row's face number
/// `offset`: cell by cell those across x, y and z. Only additions: this is where blockInit's time
/// goes.
template<class Visit>
void CartesianMesh::visitRow(
    Label row, Label offset, Label first, Label last, Visit&& visit) const {
    const Label j = row % ny_;
    const Label k = row / ny_;
    const bool hasY = j + 1 < ny_;
    const bool hasZ = k + 1 < nz_;
    const Label toY = nx_ + 1;
    const Label toZ = toY * (ny_ + 1);
    const Label perCell = 1 + Label{hasY} + Label{hasZ};
    Label i = offset / perCell;
    const Label turn = offset % perCell + Label{i + 1 == nx_}; // the last cell has none across x
    int axis = turn == 0 ? 0 : turn == 1 && hasY ? 1 : 2;
    for (Label f = first; f < last; ++i, axis = 0) {
        const Label c = i + nx_ * row;
        const Label p = pointLabel(i, j, k);
        if (axis == 0 && i + 1 < nx_)
            visit(f++, Face{{p + 1, p + 1 + toY, p + 1 + toY + toZ, p + 1 + toZ}, c, c + 1});
        if (axis <= 1 && hasY && f < last)
            visit(f++, Face{{p + toY, p + toY + toZ, p + toY + toZ + 1, p + toY + 1}, c, c + nx_});
        if (hasZ && f < last)
            visit(f++,
                  Face{{p + toZ, p + toZ + 1, p + toZ + 1 + toY, p + toZ + toY}, c, c + nx_ * ny_});
    }
}

template<class Visit>
void CartesianMesh::visitFaces(Label first, Label last, Visit&& visit) const {
    Label face = first;
    const Label internal = internalFaceCount();
    if (face < std::min(last, internal)) {
        for (Label row = rowOfInternal(face); face < std::min(last, internal); ++row) {
            const Label begin = internalBefore(row);
            const Label end = std::min({last, internal, internalBefore(row + 1)});
            visitRow(row, face - begin, face, end, visit);
            face = end;
        }
    }
    Label begin = internal;
    for (int side = 0; side < 6; ++side) {
        const Label end = begin + sideSize(side);
        for (; face < std::min(last, end); ++face)
            visit(face, boundaryFace(side, face - begin));
        begin = end;
    }
}

} // namespace polymesh
