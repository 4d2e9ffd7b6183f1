// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/macroMesh.h"

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"

#include <bit>

namespace polymesh {
namespace {

Rows<Label> cellsAtPoints(std::span<const MacroMesh::Corners> corners, Label pointCount) {
    Rows<Label> rows;
    rows.offsets = freshList<Label>(index(pointCount) + 1);
    for (const MacroMesh::Corners& cell : corners)
        for (const Label p : cell)
            ++rows.offsets[index(p) + 1];
    for (std::size_t p = 1; p < rows.offsets.size(); ++p)
        rows.offsets[p] += rows.offsets[p - 1];
    rows.values = freshList<Label>(8 * corners.size());
    std::vector<Label> next = rows.offsets;
    for (std::size_t c = 0; c < corners.size(); ++c)
        for (const Label p : corners[c])
            rows.values[index(next[index(p)]++)] = toLabel(c);
    return rows;
}

} // namespace

MacroMesh::MacroMesh(std::span<const Corners> corners, Label pointCount)
    : corners_(corners),
      neighbours_(freshList<std::array<Label, 6>>(corners.size())),
      cellsAt_(cellsAtPoints(corners, pointCount)) {
    parallelFor(cellCount(), [&](Label cell) {
        for (std::size_t side = 0; side < 6; ++side)
            neighbours_[index(cell)][side] = findNeighbour(cell, side);
    });
}

Label MacroMesh::findNeighbour(Label cell, std::size_t side) const {
    const Corners& own = corners_[index(cell)];
    const std::array<std::size_t, 4>& loop = sideLoops[side];
    for (const Label other : cellsAt(own[loop[0]])) {
        if (other == cell || cornerAt(other, own[loop[2]]) == 8) continue;
        if (cornerAt(other, own[loop[1]]) < 8 && cornerAt(other, own[loop[3]]) < 8) return other;
    }
    return -1;
}

Passage::Passage(const MacroMesh& mesh, Label cell, std::size_t side)
    : cell_(mesh.neighbour(cell, side)) {
    const std::size_t normal = side / 2;
    const bool upper = side % 2 == 1;
    const std::size_t origin = upper ? std::size_t{1} << normal : 0;
    const auto there = [&](std::size_t corner) {
        return mesh.cornerAt(cell_, mesh.corners(cell)[corner]);
    };
    const std::size_t otherOrigin = there(origin);
    std::size_t normalBit = 7; // what the two directions along the side leave
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (axis == normal) continue;
        const std::size_t bit = otherOrigin ^ there(origin | std::size_t{1} << axis);
        const auto to = static_cast<std::size_t>(std::countr_zero(bit));
        normalBit &= ~bit;
        from_[to] = axis;
        const bool flipped = (otherOrigin & bit) != 0;
        sign_[to] = flipped ? -1 : 1;
        shift_[to] = flipped ? latticeSize : 0;
    }
    const auto to = static_cast<std::size_t>(std::countr_zero(normalBit));
    from_[to] = normal;
    // How far beyond the side: x - size or -x; there: as much from 0 up, or from the size down.
    const bool flipped = (otherOrigin & normalBit) != 0;
    sign_[to] = flipped == upper ? -1 : 1;
    shift_[to] = flipped ? (upper ? 2 * latticeSize : latticeSize) : (upper ? -latticeSize : 0);
}

} // namespace polymesh
