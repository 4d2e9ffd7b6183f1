// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/hexCells.h"

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"

namespace polymesh {
namespace {

/// As planesBetween in cartesian.cpp, between the planes too.
double plane(const CartesianBox& box, int axis, double at) {
    const Label n = box.cells[static_cast<std::size_t>(axis)];
    const double min = box.box.min[axis];
    const double max = box.box.max[axis];
    return at == static_cast<double>(n) ? max : min + (max - min) * at / static_cast<double>(n);
}

std::array<Label, 3> placeOf(const CartesianBox& box, Label cell) {
    const Label row = cell / box.cells[0];
    return {cell % box.cells[0], row % box.cells[1], row / box.cells[1]};
}

std::vector<HexBoundarySide> boundarySides(const CartesianBox& box) {
    const auto [nx, ny, nz] = box.cells;
    std::vector<HexBoundarySide> sides;
    for (Label side = 0; side < 6; ++side) {
        const auto normal = static_cast<std::size_t>(side / 2);
        std::array<Label, 3> first{};
        std::array<Label, 3> last{nx, ny, nz};
        (side % 2 == 0 ? last[normal] : first[normal]) = side % 2 == 0 ? 1 : box.cells[normal] - 1;
        for (Label k = first[2]; k < last[2]; ++k)
            for (Label j = first[1]; j < last[1]; ++j)
                for (Label i = first[0]; i < last[0]; ++i)
                    sides.push_back({i + nx * (j + ny * k), side, side});
    }
    return sides;
}

} // namespace

HexCells hexCells(const CartesianBox& box) {
    const CartesianMesh mesh(box);
    HexCells cells;
    cells.points = freshList<Vec3>(index(mesh.pointCount()));
    parallelFor(mesh.pointCount(), [&](Label p) { cells.points[index(p)] = mesh.point(p); });
    const Label toY = box.cells[0] + 1;
    const Label toZ = toY * (box.cells[1] + 1);
    cells.corners = freshList<std::array<Label, 8>>(index(mesh.cellCount()));
    parallelFor(mesh.cellCount(), [&](Label c) {
        const auto [i, j, k] = placeOf(box, c);
        const Label p = i + toY * j + toZ * k;
        cells.corners[index(c)] = {
            p, p + 1, p + toY, p + toY + 1, p + toZ, p + toZ + 1, p + toZ + toY, p + toZ + toY + 1};
    });
    cells.sides = boundarySides(box);
    cells.patches = mesh.patches();
    cells.areBoxes = true;
    cells.map = [box](const HexCells&, Label cell, const Vec3& at) {
        const auto [i, j, k] = placeOf(box, cell);
        return Vec3{plane(box, 0, static_cast<double>(i) + at.x),
                    plane(box, 1, static_cast<double>(j) + at.y),
                    plane(box, 2, static_cast<double>(k) + at.z)};
    };
    return cells;
}

} // namespace polymesh
