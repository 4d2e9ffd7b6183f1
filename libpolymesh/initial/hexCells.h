// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace polymesh {

/// A side of a cell on the boundary: x lower, x upper, y lower, ...
struct HexBoundarySide {
    Label cell = 0;
    Label side = 0;
    Label patch = 0;
};

/// The cells of an initial mesh as hexahedra that can be refined.
/// Laws: (1) cells and points are numbered as in the mesh itself; (2) the sides are sorted by
/// patch, then by cell, then by side; (3) where edges of a cell have collapsed, the cell has a
/// corner more than once, and sides without area are not listed.
struct HexCells {
    std::vector<std::array<Label, 8>> corners; // of each cell, x first, then y, then z
    std::vector<Vec3> points;                  // [m]
    std::vector<HexBoundarySide> sides;
    std::vector<Patch> patches; // start and size are not set
    std::vector<Zone> cellZones;

    /// Whether a cell has a corner more than once.
    bool hasCollapsed = false;

    /// Whether the cells are boxes along the axes.
    bool areBoxes = false;

    /// How pointIn finds a point; the cells are these.
    std::function<Vec3(const HexCells& cells, Label cell, const Vec3& at)> map;

    /// A point of a cell at fractions of it, each in [0, 1]: on curved edges and sides too, and
    /// where the grading of the whole puts it. Points that cells share are the same up to rounding.
    /// Thread-safe.
    Vec3 pointIn(Label cell, const Vec3& at) const { return map(*this, cell, at); }

    Label cellCount() const { return toLabel(corners.size()); }
};

/// The cells of cartesianMesh. Points are exactly on common planes at every fraction.
HexCells hexCells(const CartesianBox& box);

} // namespace polymesh
