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
    Face internalFace(Label row, Label offset) const;
    Face boundaryFace(int side, Label local) const;
    Label sideSize(int side) const;
    std::array<Label, 4> facePoints(int axis, const std::array<Label, 3>& ijk, bool upper) const;
};

/// The whole mesh in memory. Cost: linear, in parallel; 110 bytes a cell.
PolyMesh cartesianMesh(const CartesianBox& box);

template<class Visit>
void CartesianMesh::visitFaces(Label first, Label last, Visit&& visit) const {
    Label face = first;
    const Label internal = internalFaceCount();
    if (face < std::min(last, internal)) {
        for (Label row = rowOfInternal(face); face < std::min(last, internal); ++row) {
            const Label begin = internalBefore(row);
            const Label end = std::min({last, internal, internalBefore(row + 1)});
            for (; face < end; ++face)
                visit(face, internalFace(row, face - begin));
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
