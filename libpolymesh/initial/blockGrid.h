// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/blocks.h"

#include <array>
#include <cstddef>
#include <vector>

namespace polymesh {

/// The edges of a block by its corners: four along x, four along y, four along z.
inline constexpr std::array<std::array<std::size_t, 2>, 12> hexEdges{{{0, 1},
                                                                      {3, 2},
                                                                      {7, 6},
                                                                      {4, 5},
                                                                      {0, 3},
                                                                      {1, 2},
                                                                      {5, 6},
                                                                      {4, 7},
                                                                      {0, 4},
                                                                      {1, 5},
                                                                      {2, 6},
                                                                      {3, 7}}};

/// The sides of a block by its corners, outward by the right-hand rule: x min, x max, y min, ...
inline constexpr std::array<std::array<std::size_t, 4>, 6> hexSides{
    {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};

/// The numbers of the points and cells of one block: x first, then y, then z.
struct BlockGrid {
    std::array<Label, 3> cells{};

    Label pointCount() const { return (cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1); }

    Label cellCount() const { return cells[0] * cells[1] * cells[2]; }

    std::array<Label, 3> pointSteps() const {
        return {1, cells[0] + 1, (cells[0] + 1) * (cells[1] + 1)};
    }

    std::array<Label, 3> cellSteps() const { return {1, cells[0], cells[0] * cells[1]}; }

    Label point(Label i, Label j, Label k) const {
        return i + (cells[0] + 1) * (j + (cells[1] + 1) * k);
    }

    Label cell(Label i, Label j, Label k) const { return i + cells[0] * (j + cells[1] * k); }
};

/// A walk over the points and the cells of one side of a block, with two coordinates u and v.
struct SideGrid {
    std::array<Label, 2> counts{}; // cells along u and v
    Label firstPoint = 0;
    std::array<Label, 2> pointSteps{};
    Label firstCell = 0;
    std::array<Label, 2> cellSteps{};

    Label point(Label u, Label v) const {
        return firstPoint + u * pointSteps[0] + v * pointSteps[1];
    }

    Label cell(Label u, Label v) const { return firstCell + u * cellSteps[0] + v * cellSteps[1]; }

    /// The same side walked with u from the other end.
    SideGrid flippedU() const;
    /// The same side with u and v exchanged.
    SideGrid swapped() const;

    bool operator==(const SideGrid&) const = default;
};

/// Side `side` of a block, u and v along the two directions of the block in the order x, y, z.
SideGrid sideGrid(const BlockGrid& grid, std::size_t side);

/// The corners of a side at (u, v) = (0, 0), (1, 0), (1, 1), (0, 1) of sideGrid.
std::array<std::size_t, 4> sideCorners(std::size_t side);

/// The shapes that the sides of a block lie on; null: none.
using SideShapes = std::array<const Shape*, 6>;

/// Those of the description, which must outlive the result.
SideShapes sideShapes(const BlockMeshDescription& description, const Block& block);

/// The points of one block, not scaled. Inside by trans-finite interpolation: every point is
/// interpolated along the twelve edges, at the parameters that these have there. The weight of an
/// edge is the sum of those of its two ends, and that of a corner is the product, over its three
/// edges, of how near the point is to the corner by their parameters. Curved edges add what they
/// differ from the straight line by, with the same weights; projected sides then add what they
/// moved by. `curves`: those of the description, `block`: one of its blocks.
std::vector<Vec3> blockPoints(const BlockMeshDescription& description, const Block& block);

} // namespace polymesh
