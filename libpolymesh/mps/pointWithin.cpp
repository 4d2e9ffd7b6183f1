// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/pointWithin.h"

#include <array>
#include <cmath>
#include <limits>

namespace polymesh {

namespace {

/// Distances r from all planes, and the plane of the least.
struct Depth {
    double least = std::numeric_limits<double>::max();
    const HalfSpace* plane = nullptr;
};

Depth depthAt(std::span<const HalfSpace> halfSpaces, const Vec3& x) {
    Depth depth;
    for (const HalfSpace& h : halfSpaces) {
        const double distance = dot(h.normal, x - h.at);
        if (!(distance < depth.least)) continue;
        depth = {distance, &h};
    }
    return depth;
}

using Vec4 = std::array<double, 4>;

double dot4(const Vec4& a, const Vec4& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// The largest r with dot(normal, x) - r >= offset for four planes that hold it, and where; x is
/// counted from `start` and in units of `reach`. Planes come in one by one; the first four are
/// those of a tetrahedron round the origin.
class DeepestPoint {
public:
    explicit DeepestPoint(double inradius) {
        // For the rows (n, -1) of the normals of a regular tetrahedron the inverse is known.
        constexpr double s = 0.57735026918962576;
        constexpr std::array<Vec3, 4> normals{{{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}}};
        for (std::size_t i = 0; i < 4; ++i) {
            columns_[i] = {0.75 * normals[i].x, 0.75 * normals[i].y, 0.75 * normals[i].z, -0.25};
            offsets_[i] = -inradius;
        }
        solve();
    }

    Vec3 point() const { return {solution_[0], solution_[1], solution_[2]}; }

    double depth() const { return solution_[3]; }

    /// Brings in a plane that cuts the point off; false when rounding does not allow it.
    bool bringIn(const Vec3& normal, double offset) {
        constexpr double tiny = 1e-12;
        const Vec4 row{normal.x, normal.y, normal.z, -1};
        Vec4 weight; // the row as a sum of those that hold the point
        std::size_t leaving = 4;
        double least = std::numeric_limits<double>::max();
        for (std::size_t i = 0; i < 4; ++i) {
            weight[i] = dot4(row, columns_[i]);
            if (weight[i] <= tiny) continue;
            // The multipliers are the last row of the inverse, with the other sign.
            const double ratio = -columns_[i][3] / weight[i];
            if (ratio >= least) continue;
            least = ratio;
            leaving = i;
        }
        if (leaving == 4) return false;
        for (double& value : columns_[leaving])
            value /= weight[leaving];
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; i != leaving && k < 4; ++k)
                columns_[i][k] -= weight[i] * columns_[leaving][k];
        offsets_[leaving] = offset;
        solve();
        return true;
    }

private:
    void solve() {
        solution_ = {};
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 4; ++k)
                solution_[k] += offsets_[i] * columns_[i][k];
    }

    std::array<Vec4, 4> columns_; // of the inverse of the rows (normal, -1)
    Vec4 offsets_;
    Vec4 solution_; // x, r
};

} // namespace

void addHalfSpace(const Vec3& a, const Vec3& b, const Vec3& at, std::vector<HalfSpace>& list) {
    const Vec3 normal = cross(a, b);
    const double length = norm(normal);
    if (length > 0) list.push_back({normal / length, at});
}

std::optional<Vec3> pointWithin(std::span<const HalfSpace> halfSpaces,
                                const Vec3& start,
                                double reach,
                                const Search& search) {
    constexpr double deep = 0.2;   // of the reach
    constexpr double enough = 0.5; // of the largest depth
    constexpr int mostPivots = 60;
    if (!(reach > 0)) return std::nullopt;
    DeepestPoint deepest(2);
    for (int pivot = 0; pivot < mostPivots; ++pivot) {
        const Vec3 x = start + reach * deepest.point();
        const Depth depth = depthAt(halfSpaces, x);
        const double bound = deepest.depth() * reach;
        if (depth.plane == nullptr || (pivot == 0 && depth.least >= deep * reach)) return x;
        if (!(bound > search.least * reach)) return std::nullopt;
        if (depth.least >= enough * bound && depth.least >= search.least * reach) return x;
        const HalfSpace& h = *depth.plane;
        if (!deepest.bringIn(h.normal, dot(h.normal, h.at - start) / reach)) return std::nullopt;
    }
    return std::nullopt;
}

} // namespace polymesh
