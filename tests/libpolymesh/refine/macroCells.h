// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Hexahedra to refine, made in code.

#include "libpolymesh/initial/hexCells.h"
#include "libpolymesh/refine/macroMesh.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace polymesh::test {

/// Cells with straight edges and one patch, `walls`.
inline HexCells hexCellsOf(std::vector<Vec3> points, std::vector<std::array<Label, 8>> corners) {
    HexCells cells;
    cells.points = std::move(points);
    cells.corners = std::move(corners);
    const MacroMesh macro(cells.corners, toLabel(cells.points.size()));
    cells.patches.push_back({"walls", "wall", 0, 0, {}});
    for (Label c = 0; c < cells.cellCount(); ++c)
        for (Label side = 0; side < 6; ++side)
            if (macro.neighbour(c, index(side)) < 0) cells.sides.push_back({c, side, 0});
    cells.map = [](const HexCells& of, Label cell, const Vec3& at) {
        Vec3 sum;
        for (std::size_t c = 0; c < 8; ++c) {
            double weight = 1;
            for (int axis = 0; axis < 3; ++axis)
                weight *= (c >> static_cast<unsigned>(axis) & 1U) != 0 ? at[axis] : 1 - at[axis];
            sum += weight * of.points[index(of.corners[index(cell)][c])];
        }
        return sum;
    };
    return cells;
}

/// The same cells, each turned to one of the 24 ways it can lie.
inline HexCells turned(HexCells cells, unsigned seed) {
    std::mt19937 random(seed);
    const auto roll = [](const std::array<Label, 8>& c) { // x to y, y to minus x
        return std::array<Label, 8>{c[1], c[3], c[0], c[2], c[5], c[7], c[4], c[6]};
    };
    const auto cycle = [](const std::array<Label, 8>& c) { // x to y to z to x
        return std::array<Label, 8>{c[0], c[2], c[4], c[6], c[1], c[3], c[5], c[7]};
    };
    for (std::array<Label, 8>& c : cells.corners)
        for (auto n = random() % 24; n > 0; --n)
            c = n % 2 == 0 ? roll(c) : cycle(c);
    return hexCellsOf(std::move(cells.points), std::move(cells.corners));
}

/// A ring of `sectors` columns of hexahedra round a common edge: that edge has as many cells.
inline HexCells star(Label sectors) {
    std::vector<Vec3> points;
    const Label perLayer = 1 + 2 * sectors;
    for (int layer = 0; layer < 3; ++layer) {
        points.push_back({0, 0, 1.0 * layer});
        for (Label i = 0; i < 2 * sectors; ++i) {
            const double angle =
                std::numbers::pi * static_cast<double>(i) / static_cast<double>(sectors);
            const double radius = i % 2 == 0 ? 1 : 1.3;
            points.push_back({radius * std::cos(angle), radius * std::sin(angle), 1.0 * layer});
        }
    }
    std::vector<std::array<Label, 8>> corners;
    for (Label layer = 0; layer < 2; ++layer)
        for (Label s = 0; s < sectors; ++s) {
            const auto at = [&](Label i) { return layer * perLayer + 1 + i % (2 * sectors); };
            const Label axis = layer * perLayer;
            const Label up = perLayer;
            corners.push_back({axis,
                               at(2 * s),
                               at(2 * s + 2),
                               at(2 * s + 1),
                               axis + up,
                               at(2 * s) + up,
                               at(2 * s + 2) + up,
                               at(2 * s + 1) + up});
        }
    return hexCellsOf(std::move(points), std::move(corners));
}

} // namespace polymesh::test
