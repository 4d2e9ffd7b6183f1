// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/blockGrid.h"

#include <utility>

namespace polymesh {

SideGrid SideGrid::flippedU() const {
    SideGrid result = *this;
    result.firstPoint += counts[0] * pointSteps[0];
    result.firstCell += (counts[0] - 1) * cellSteps[0];
    result.pointSteps[0] = -pointSteps[0];
    result.cellSteps[0] = -cellSteps[0];
    return result;
}

SideGrid SideGrid::swapped() const {
    SideGrid result = *this;
    std::swap(result.counts[0], result.counts[1]);
    std::swap(result.pointSteps[0], result.pointSteps[1]);
    std::swap(result.cellSteps[0], result.cellSteps[1]);
    return result;
}

SideGrid sideGrid(const BlockGrid& grid, std::size_t side) {
    const std::size_t normal = side / 2;
    const std::size_t u = normal == 0 ? 1 : 0;
    const std::size_t v = normal == 2 ? 1 : 2;
    const std::array<Label, 3> points = grid.pointSteps();
    const std::array<Label, 3> cells = grid.cellSteps();
    const bool upper = side % 2 == 1;
    return {.counts = {grid.cells[u], grid.cells[v]},
            .firstPoint = upper ? grid.cells[normal] * points[normal] : 0,
            .pointSteps = {points[u], points[v]},
            .firstCell = upper ? (grid.cells[normal] - 1) * cells[normal] : 0,
            .cellSteps = {cells[u], cells[v]}};
}

std::array<std::size_t, 4> sideCorners(std::size_t side) {
    constexpr std::array<std::array<std::size_t, 4>, 6> corners{
        {{0, 3, 7, 4}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 2, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}}};
    return corners[side];
}

} // namespace polymesh
