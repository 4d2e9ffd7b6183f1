// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/base/rows.h"
#include "libpolymesh/refine/octant.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace polymesh {

/// The hexahedra that become trees, and which of them meet where. How two of them lie to each other
/// is read off the points they share. Sides: 0 x lower, 1 x upper, 2 y lower, ...; corners as those
/// of an Octant.
class MacroMesh {
public:
    using Corners = std::array<Label, 8>;

    /// Requires: eight different points in each cell; any three cells have no side in common; two
    /// cells do not share all points of two sides.
    /// Cost: linear, in parallel; 60 bytes a cell beside the corners, which the caller keeps.
    MacroMesh(std::span<const Corners> corners, Label pointCount);

    Label cellCount() const { return toLabel(corners_.size()); }

    Label pointCount() const { return cellsAt_.size(); }

    const Corners& corners(Label cell) const { return corners_[index(cell)]; }

    /// The cell across a side, -1 on the boundary.
    Label neighbour(Label cell, std::size_t side) const { return neighbours_[index(cell)][side]; }

    /// The cells at a point, ascending.
    std::span<const Label> cellsAt(Label point) const { return cellsAt_[point]; }

    /// Calls visit(other, corner of other at the first end, at the second end) for the cells that
    /// have the edge between two corners of a cell, that cell included, ascending.
    template<class Visit>
    void forCellsAtEdge(Label cell, std::array<std::size_t, 2> ends, Visit&& visit) const;

    /// The corner of a cell that is this point; 8 when it has none.
    std::size_t cornerAt(Label cell, Label point) const {
        const Corners& corners = corners_[index(cell)];
        std::size_t c = 0;
        while (c < 8 && corners[c] != point)
            ++c;
        return c;
    }

private:
    Label findNeighbour(Label cell, std::size_t side) const;

    std::span<const Corners> corners_;
    std::vector<std::array<Label, 6>> neighbours_;
    Rows<Label> cellsAt_;
};

/// How coordinates of a cell continue in the one across a side.
class Passage {
public:
    /// Requires: there is a cell across the side.
    Passage(const MacroMesh& mesh, Label cell, std::size_t side);

    Label cell() const { return cell_; }

    LatticePoint point(const LatticePoint& from) const {
        LatticePoint to{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            to[axis] = sign_[axis] * from[from_[axis]] + shift_[axis];
        return to;
    }

    /// The octant whose corners these become.
    Octant octant(const Octant& from) const {
        const LatticePoint low = point(from.anchor);
        const LatticePoint high = point(from.corner(7));
        Octant to{{}, from.level};
        for (std::size_t axis = 0; axis < 3; ++axis)
            to.anchor[axis] = std::min(low[axis], high[axis]);
        return to;
    }

private:
    Label cell_;
    std::array<std::size_t, 3> from_{};
    LatticePoint sign_{};
    LatticePoint shift_{};
};

/// The corners of side `side` of a cell, seen from outside counter-clockwise.
inline constexpr std::array<std::array<std::size_t, 4>, 6> sideLoops{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

template<class Visit>
void MacroMesh::forCellsAtEdge(Label cell, std::array<std::size_t, 2> ends, Visit&& visit) const {
    const Label first = corners(cell)[ends[0]];
    const Label second = corners(cell)[ends[1]];
    for (const Label other : cellsAt(first)) {
        const std::size_t b = cornerAt(other, second);
        if (b == 8) continue;
        const std::size_t a = cornerAt(other, first);
        const std::size_t difference = a ^ b;
        if ((difference & (difference - 1)) == 0) visit(other, a, b); // not across a diagonal
    }
}

} // namespace polymesh
