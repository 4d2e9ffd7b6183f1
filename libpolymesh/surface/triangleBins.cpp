// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/triangleBins.h"

#include "libpolymesh/base/parallel.h"

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cmath>

namespace polymesh {

namespace {

constexpr double maxBins = 1.5e6;

using Polygon = boost::container::static_vector<Vec3, 9>;

/// The part of a convex polygon with low <= coordinate <= high.
Polygon clipped(const Polygon& polygon, int axis, double low, double high) {
    Polygon half;
    Polygon both;
    const auto clip = [axis](const Polygon& from, Polygon& to, double limit, double sign) {
        for (std::size_t i = 0; i < from.size(); ++i) {
            const Vec3& a = from[i];
            const Vec3& b = from[(i + 1) % from.size()];
            const double da = sign * (a[axis] - limit);
            const double db = sign * (b[axis] - limit);
            if (da <= 0) to.push_back(a);
            if ((da < 0 && db > 0) || (da > 0 && db < 0))
                to.push_back(a + da / (da - db) * (b - a));
        }
    };
    clip(polygon, half, low, -1);
    clip(half, both, high, 1);
    return both;
}

} // namespace

TriangleBins::TriangleBins(const TriSurface& surface, double binSize)
    : box_(boundingBox(surface.points)) {
    divide(binSize);
    listTriangles(pairsOf(surface));
    countOccupied();
}

/// Widens the box by a little and divides it.
void TriangleBins::divide(double binSize) {
    const Vec3 extents = box_.size();
    const double largest = std::max({extents.x, extents.y, extents.z});
    const double margin = 1e-6 * largest;
    box_.min -= {margin, margin, margin};
    box_.max += {margin, margin, margin};
    const Vec3 whole = box_.size();
    const double smallest = std::cbrt(whole.x * whole.y * whole.z / maxBins);
    const double size = std::max({binSize, smallest, largest / 16000});
    for (int axis = 0; axis < 3; ++axis) {
        const double wanted = std::min(std::floor(whole[axis] / size) + 1, 16000.0);
        count_[static_cast<std::size_t>(axis)] = static_cast<int>(wanted);
        size_[axis] = whole[axis] / wanted;
    }
    slack_ = 1e-9 * largest;
}

std::array<int, 2> TriangleBins::rangeOf(std::span<const Vec3> polygon, int axis) const {
    double low = Box::inf;
    double high = -Box::inf;
    for (const Vec3& p : polygon) {
        low = std::min(low, p[axis]);
        high = std::max(high, p[axis]);
    }
    const auto bin = [&](double x) {
        return std::clamp(static_cast<int>(std::floor((x - box_.min[axis]) / size_[axis])),
                          0,
                          count_[static_cast<std::size_t>(axis)] - 1);
    };
    return {bin(low - slack_), bin(high + slack_)};
}

/// Calls visit(i, the part of the polygon in it) for the bins along an axis that it reaches.
template<class Polygon, class Visit>
void TriangleBins::forSlabs(const Polygon& polygon, int axis, Visit&& visit) const {
    const auto [first, last] = rangeOf({polygon.data(), polygon.size()}, axis);
    if (first == last) return visit(first, polygon);
    for (int i = first; i <= last; ++i) {
        const double low = box_.min[axis] + i * size_[axis];
        const Polygon part = clipped(polygon, axis, low - slack_, low + size_[axis] + slack_);
        if (!part.empty()) visit(i, part);
    }
}

/// Slices a triangle by axis after axis.
void TriangleBins::addPairs(const TriSurface& surface, Label t, std::vector<Pair>& pairs) const {
    const Polygon whole{surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)};
    forSlabs(whole, 0, [&](int i, const Polygon& slice) {
        forSlabs(slice, 1, [&](int j, const Polygon& row) {
            const auto [first, last] = rangeOf({row.data(), row.size()}, 2);
            for (int k = first; k <= last; ++k)
                pairs.push_back({toLabel(position(i, j, k)), t});
        });
    });
}

/// The bins of each triangle, in blocks of triangles.
std::vector<std::vector<TriangleBins::Pair>>
TriangleBins::pairsOf(const TriSurface& surface) const {
    constexpr Label block = 1024;
    const Label blocks = (surface.triangleCount() + block - 1) / block;
    std::vector<std::vector<Pair>> pairs(index(blocks));
    parallelBlocks(surface.triangleCount(), block, [&](Label b, Label first, Label last) {
        for (Label t = first; t < last; ++t)
            addPairs(surface, t, pairs[index(b)]);
    });
    return pairs;
}

void TriangleBins::listTriangles(const std::vector<std::vector<Pair>>& pairs) {
    const std::size_t bins = position(count_[0] - 1, count_[1] - 1, count_[2] - 1) + 1;
    triangles_.offsets.assign(bins + 1, 0);
    for (const auto& list : pairs)
        for (const Pair& pair : list)
            ++triangles_.offsets[index(pair.bin) + 1];
    for (std::size_t i = 0; i < bins; ++i)
        triangles_.offsets[i + 1] += triangles_.offsets[i];
    triangles_.values.resize(index(triangles_.offsets.back()));
    std::vector<Label> next(triangles_.offsets.begin(), triangles_.offsets.end() - 1);
    for (const auto& list : pairs)
        for (const Pair& pair : list)
            triangles_.values[index(next[index(pair.bin)]++)] = pair.triangle;
}

std::size_t TriangleBins::position(int i, int j, int k) const {
    return (static_cast<std::size_t>(i) * static_cast<std::size_t>(count_[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(count_[2]) +
           static_cast<std::size_t>(k);
}

void TriangleBins::countOccupied() {
    const auto at = [this](int i, int j, int k) -> std::size_t {
        return (static_cast<std::size_t>(i) * static_cast<std::size_t>(count_[1] + 1) +
                static_cast<std::size_t>(j)) *
                   static_cast<std::size_t>(count_[2] + 1) +
               static_cast<std::size_t>(k);
    };
    sumTable_.assign(at(count_[0], count_[1], count_[2]) + 1, 0);
    for (int i = 0; i < count_[0]; ++i)
        for (int j = 0; j < count_[1]; ++j) {
            Label row = 0;
            for (int k = 0; k < count_[2]; ++k) {
                row += triangles_.rowSize(toLabel(position(i, j, k))) != 0 ? 1 : 0;
                sumTable_[at(i + 1, j + 1, k + 1)] = row + sumTable_[at(i, j + 1, k + 1)] +
                                                     sumTable_[at(i + 1, j, k + 1)] -
                                                     sumTable_[at(i, j, k + 1)];
            }
        }
}

TriangleBins::Index TriangleBins::binOf(const Vec3& p) const {
    Index result{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const double bin = std::floor((p[axis] - box_.min[axis]) / size_[axis]);
        result[a] =
            static_cast<std::int16_t>(std::clamp(bin, -1.0, static_cast<double>(count_[a])));
    }
    return result;
}

bool TriangleBins::isOccupied(const Range& range) const {
    std::array<std::size_t, 3> low{};
    std::array<std::size_t, 3> high{};
    for (std::size_t a = 0; a < 3; ++a) {
        const int first = std::max<int>(range.first[a], 0);
        const int last = std::min<int>(range.last[a], count_[a] - 1);
        if (first > last) return false;
        low[a] = static_cast<std::size_t>(first);
        high[a] = static_cast<std::size_t>(last) + 1;
    }
    const std::size_t nj = static_cast<std::size_t>(count_[1]) + 1;
    const std::size_t nk = static_cast<std::size_t>(count_[2]) + 1;
    const auto sum = [&](std::size_t i, std::size_t j, std::size_t k) {
        return sumTable_[(i * nj + j) * nk + k];
    };
    return sum(high[0], high[1], high[2]) - sum(low[0], high[1], high[2]) -
               sum(high[0], low[1], high[2]) - sum(high[0], high[1], low[2]) +
               sum(low[0], low[1], high[2]) + sum(low[0], high[1], low[2]) +
               sum(high[0], low[1], low[2]) - sum(low[0], low[1], low[2]) >
           0;
}

void TriangleBins::collect(const Range& range, std::vector<Label>& found) const {
    const std::size_t before = found.size();
    std::array<int, 3> low{};
    std::array<int, 3> high{};
    for (std::size_t a = 0; a < 3; ++a) {
        low[a] = std::max<int>(range.first[a], 0);
        high[a] = std::min<int>(range.last[a], count_[a] - 1);
    }
    for (int i = low[0]; i <= high[0]; ++i)
        for (int j = low[1]; j <= high[1]; ++j) {
            if (low[2] > high[2]) break;
            const std::size_t first = position(i, j, low[2]);
            const std::size_t last = position(i, j, high[2]) + 1;
            found.insert(found.end(),
                         triangles_.values.begin() + triangles_.offsets[first],
                         triangles_.values.begin() + triangles_.offsets[last]);
        }
    std::sort(found.begin() + static_cast<std::ptrdiff_t>(before), found.end());
    found.erase(std::unique(found.begin() + static_cast<std::ptrdiff_t>(before), found.end()),
                found.end());
}

} // namespace polymesh
