// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/flatSides.h"

#include <algorithm>
#include <cmath>

namespace polymesh {

namespace {

constexpr double clearance = 0.2; // of a cell

struct FlatTriangle {
    double coordinate;
    double area;
};

/// Joins triangles of nearly the same coordinate and keeps the places with enough area.
std::vector<double> largeOnes(std::vector<FlatTriangle>& triangles, double cellSize) {
    std::ranges::sort(triangles, {}, &FlatTriangle::coordinate);
    std::vector<double> places;
    for (std::size_t i = 0; i < triangles.size();) {
        double area = 0;
        std::size_t j = i;
        for (; j < triangles.size() &&
               triangles[j].coordinate - triangles[i].coordinate <= 1e-3 * cellSize;
             ++j)
            area += triangles[j].area;
        if (area >= 0.5 * cellSize * cellSize) places.push_back(triangles[i].coordinate);
        i = j;
    }
    return places;
}

/// The planes of a grid across one axis.
struct Planes {
    double cellSize = 0; // [m]
    int levels = 0;      // how often cells may be halved
};

/// Distance from the nearest plane of a grid that begins at `origin` to the nearest flat side, in
/// cells of the plane's level.
double clearanceOf(double origin, const Planes& planes, const std::vector<double>& flats) {
    double least = 0.5;
    double cellSize = planes.cellSize;
    for (int level = 0; level <= planes.levels; ++level, cellSize /= 2)
        for (const double flat : flats) {
            const double place = (flat - origin) / cellSize;
            least = std::min(least, std::abs(place - std::round(place)));
        }
    return least;
}

/// The smallest shift, in cells, that gives enough clearance; else the one that gives most.
double bestShift(double origin, const Planes& planes, const std::vector<double>& flats) {
    double best = 0;
    double bestClearance = clearanceOf(origin, planes, flats);
    // A third of a cell is a third or two of any cell that comes of it.
    const int steps = planes.levels == 0 ? 32 : 96;
    for (int k = 1; k <= steps / 2 && bestClearance < clearance; ++k)
        for (const int sign : {1, -1}) {
            const double shift = static_cast<double>(sign * k) / steps;
            const double found = clearanceOf(origin + shift * planes.cellSize, planes, flats);
            if (found <= bestClearance + 1e-9) continue;
            best = shift;
            bestClearance = found;
        }
    return best;
}

} // namespace

std::array<std::vector<double>, 3> flatSides(const TriSurface& surface, double cellSize) {
    std::array<std::vector<FlatTriangle>, 3> flat;
    for (Label t = 0; t < surface.triangleCount(); ++t) {
        const Vec3& a = surface.corner(t, 0);
        const Vec3& b = surface.corner(t, 1);
        const Vec3& c = surface.corner(t, 2);
        for (int axis = 0; axis < 3; ++axis) {
            const auto [low, high] = std::minmax({a[axis], b[axis], c[axis]});
            if (high - low <= 1e-3 * cellSize)
                flat[static_cast<std::size_t>(axis)].push_back(
                    {low, 0.5 * norm(cross(b - a, c - a))});
        }
    }
    return {
        largeOnes(flat[0], cellSize), largeOnes(flat[1], cellSize), largeOnes(flat[2], cellSize)};
}

CartesianBox clearOfFlatSides(const CartesianBox& box,
                              const Box& surfaceBox,
                              double margin,
                              const std::array<std::vector<double>, 3>& flats,
                              int levels) {
    CartesianBox shifted = box;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const double h = box.box.size()[axis] / static_cast<double>(box.cells[a]);
        const double shift = bestShift(box.box.min[axis], {h, levels}, flats[a]);
        if (shift == 0) continue;
        double min = box.box.min[axis] + shift * h;
        Label cells = box.cells[a];
        const double slack = 1e-9 * h;
        if (min > surfaceBox.min[axis] - margin + slack) {
            min -= h;
            ++cells;
        }
        if (min + static_cast<double>(cells) * h < surfaceBox.max[axis] + margin - slack) ++cells;
        shifted.box.min[axis] = min;
        shifted.box.max[axis] = min + static_cast<double>(cells) * h;
        shifted.cells[a] = cells;
    }
    return shifted;
}

} // namespace polymesh
