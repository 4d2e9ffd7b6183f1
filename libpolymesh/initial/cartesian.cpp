// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/cartesian.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polymesh {

namespace {

constexpr std::array<char, 3> axisName{'x', 'y', 'z'};

/// Every label of the mesh, and the 4 labels of each face in one array, must fit.
void requireLabelsFit(const std::array<double, 3>& n) {
    const double faces = 3 * n[0] * n[1] * n[2] + n[0] * n[1] + n[1] * n[2] + n[0] * n[2];
    require(4 * faces < static_cast<double>(std::numeric_limits<Label>::max()),
            "a box of {:.6g} x {:.6g} x {:.6g} cells is too large for {}-bit labels; choose larger "
            "cells{}",
            n[0],
            n[1],
            n[2],
            8 * sizeof(Label),
            sizeof(Label) < 8 ? " or configure with POLYMESH_LABEL64" : "");
}

std::vector<double> planesBetween(double min, double max, Label n, char axis) {
    std::vector<double> planes(index(n) + 1);
    for (Label i = 0; i <= n; ++i)
        planes[index(i)] = min + (max - min) * static_cast<double>(i) / static_cast<double>(n);
    planes.back() = max; // min + (max - min) may differ by rounding
    const auto notAscending = [](double a, double b) { return !(a < b); };
    require(std::adjacent_find(planes.begin(), planes.end(), notAscending) == planes.end(),
            "{} cells from {} to {} in {} are smaller than the spacing of numbers; choose larger "
            "cells or move the geometry towards the origin",
            n,
            min,
            max,
            axis);
    return planes;
}

} // namespace

CartesianBox boxAround(const Box& surfaceBox, double cellSize, double margin) {
    require(std::isfinite(cellSize) && cellSize > 0, "cell size {}: must be positive", cellSize);
    require(std::isfinite(margin) && margin >= 0, "margin {}: must not be negative", margin);
    require(!surfaceBox.isEmpty() && isFinite(surfaceBox.min) && isFinite(surfaceBox.max),
            "the surface has no points to put a box around; give one with triangles");
    std::array<double, 3> n{};
    for (int axis = 0; axis < 3; ++axis) {
        const double cells = (surfaceBox.size()[axis] + 2 * margin) / cellSize;
        // A hair over a whole number is rounding: 1.1 / 0.1 means 11 cells, not 12.
        n[static_cast<std::size_t>(axis)] = std::max(1.0, std::ceil(cells * (1 - 1e-12)));
    }
    requireLabelsFit(n);
    const Vec3 half = 0.5 * cellSize * Vec3{n[0], n[1], n[2]};
    const Vec3 min = surfaceBox.centre() - half;
    return {{min, min + cellSize * Vec3{n[0], n[1], n[2]}},
            {static_cast<Label>(n[0]), static_cast<Label>(n[1]), static_cast<Label>(n[2])}};
}

CartesianMesh::CartesianMesh(const CartesianBox& box)
    : nx_(box.cells[0]), ny_(box.cells[1]), nz_(box.cells[2]) {
    require(nx_ > 0 && ny_ > 0 && nz_ > 0,
            "cells ({} {} {}): every number must be positive",
            nx_,
            ny_,
            nz_);
    requireLabelsFit(
        {static_cast<double>(nx_), static_cast<double>(ny_), static_cast<double>(nz_)});
    require(isFinite(box.box.min) && isFinite(box.box.max),
            "the box is not finite; give corners that are numbers");
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const double min = box.box.min[axis];
        const double max = box.box.max[axis];
        require(min < max,
                "the box from {} to {} in {} is empty; give the smaller corner first",
                min,
                max,
                axisName[a]);
        planes_[a] = planesBetween(min, max, box.cells[a], axisName[a]);
    }
}

Vec3 CartesianMesh::point(Label label) const {
    const Label i = label % (nx_ + 1);
    const Label jk = label / (nx_ + 1);
    return {
        planes_[0][index(i)], planes_[1][index(jk % (ny_ + 1))], planes_[2][index(jk / (ny_ + 1))]};
}

std::vector<Patch> CartesianMesh::patches() const {
    std::vector<Patch> patches;
    Label start = internalFaceCount();
    for (int side = 0; side < 6; ++side) {
        const char axis = axisName[static_cast<std::size_t>(side / 2)];
        patches.push_back({.name = std::string(1, axis) + (side % 2 == 0 ? "Min" : "Max"),
                           .start = start,
                           .size = sideSize(side),
                           .entries = {}});
        start += sideSize(side);
    }
    return patches;
}

/// Internal faces of all rows of cells (j, k) before `row` = j + ny k: in a row there are nx - 1
/// faces across x, and nx across y and across z unless it is the last in that direction.
Label CartesianMesh::internalBefore(Label row) const {
    const Label j = row % ny_;
    const Label k = row / ny_;
    const Label acrossY = k * (ny_ - 1) + j;
    const Label acrossZ = std::min(row, (nz_ - 1) * ny_);
    return row * (nx_ - 1) + (acrossY + acrossZ) * nx_;
}

Label CartesianMesh::rowOfInternal(Label face) const {
    Label low = 0;
    Label high = ny_ * nz_; // internalBefore(low) <= face < internalBefore(high)
    while (high - low > 1) {
        const Label middle = low + (high - low) / 2;
        (internalBefore(middle) <= face ? low : high) = middle;
    }
    return low;
}

Label CartesianMesh::sideSize(int side) const {
    return side < 2 ? ny_ * nz_ : side < 4 ? nx_ * nz_ : nx_ * ny_;
}

CartesianMesh::Face CartesianMesh::boundaryFace(int side, Label local) const {
    const int axis = side / 2;
    const bool upper = side % 2 == 1;
    const Label width = axis == 0 ? ny_ : nx_;
    std::array<Label, 3> ijk{};
    ijk[axis == 0 ? 1 : 0] = local % width;
    ijk[axis == 2 ? 1 : 2] = local / width;
    const std::array<Label, 3> last{nx_ - 1, ny_ - 1, nz_ - 1};
    const auto a = static_cast<std::size_t>(axis);
    ijk[a] = upper ? last[a] : 0;
    return {facePoints(axis, ijk, upper), ijk[0] + nx_ * (ijk[1] + ny_ * ijk[2]), -1};
}

/// The upper or lower face of a cell across an axis, seen from outside counter-clockwise.
std::array<Label, 4>
CartesianMesh::facePoints(int axis, const std::array<Label, 3>& ijk, bool upper) const {
    const Label toY = nx_ + 1;
    const Label toZ = toY * (ny_ + 1);
    const std::array<Label, 3> step{1, toY, toZ};
    const Label u = step[static_cast<std::size_t>((axis + 1) % 3)];
    const Label v = step[static_cast<std::size_t>((axis + 2) % 3)];
    const Label origin = pointLabel(ijk[0], ijk[1], ijk[2]);
    if (!upper) return {origin, origin + v, origin + u + v, origin + u};
    const Label p = origin + step[static_cast<std::size_t>(axis)];
    return {p, p + u, p + u + v, p + v};
}

PolyMesh cartesianMesh(const CartesianBox& box) {
    const CartesianMesh source(box);
    constexpr Label blockSize = 1 << 15;
    PolyMesh mesh;
    mesh.cellCount = source.cellCount();
    mesh.patches = source.patches();
    mesh.points.resize(index(source.pointCount()));
    mesh.owner.resize(index(source.faceCount()));
    mesh.neighbour.resize(index(source.internalFaceCount()));
    mesh.faces.offsets.resize(index(source.faceCount()) + 1);
    mesh.faces.values.resize(4 * index(source.faceCount()));
    parallelBlocks(source.pointCount(), blockSize, [&](Label, Label first, Label last) {
        for (Label p = first; p < last; ++p)
            mesh.points[index(p)] = source.point(p);
    });
    parallelBlocks(source.faceCount(), blockSize, [&](Label, Label first, Label last) {
        source.visitFaces(first, last, [&](Label f, const CartesianMesh::Face& face) {
            mesh.owner[index(f)] = face.owner;
            if (face.neighbour >= 0) mesh.neighbour[index(f)] = face.neighbour;
            mesh.faces.offsets[index(f) + 1] = 4 * (f + 1);
            std::copy(face.points.begin(), face.points.end(), &mesh.faces.values[4 * index(f)]);
        });
    });
    return mesh;
}

} // namespace polymesh
