// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/chords.h"

#include <vector>

namespace polymesh {

namespace {

/// A polygon with its bends as corners, seen along its normal.
class SeenPolygon {
public:
    explicit SeenPolygon(std::vector<Vec3> points) : points_(std::move(points)) {
        for (std::size_t i = 2; i < points_.size(); ++i)
            normal_ += cross(points_[i - 1] - points_[0], points_[i] - points_[0]);
    }

    bool isChord(std::size_t i, std::size_t j) const {
        return leavesInside(i, j) && leavesInside(j, i) && !crosses(i, j) && liesAsAll(i, j) &&
               liesAsAll(j, i);
    }

private:
    /// Whether the corners from one to another lie as the polygon does: a corner that stands out of
    /// it would become a piece across it, maybe flat on another face of the cell.
    bool liesAsAll(std::size_t from, std::size_t to) const {
        constexpr double leastCosine = 0.4;
        const std::size_t n = points_.size();
        Vec3 area;
        for (std::size_t k = (from + 1) % n; k != to; k = (k + 1) % n)
            area += cross(points_[k] - points_[from], points_[(k + 1) % n] - points_[from]);
        return dot(area, normal_) >= leastCosine * norm(area) * norm(normal_);
    }

    /// On which side of the line from a to b the point c is.
    double side(const Vec3& a, const Vec3& b, const Vec3& c) const {
        return dot(cross(b - a, c - a), normal_);
    }

    bool leavesInside(std::size_t from, std::size_t to) const {
        const std::size_t n = points_.size();
        const Vec3& here = points_[from];
        const Vec3& there = points_[to];
        const Vec3& before = points_[(from + n - 1) % n];
        const Vec3& after = points_[(from + 1) % n];
        const bool isLeftOfOut = side(here, after, there) > 0;
        const bool isLeftOfIn = side(before, here, there) > 0;
        return side(before, here, after) > 0 ? isLeftOfOut && isLeftOfIn
                                             : isLeftOfOut || isLeftOfIn;
    }

    bool crosses(std::size_t i, std::size_t j) const {
        const std::size_t n = points_.size();
        const auto differ = [](double a, double b) { return (a > 0) != (b > 0); };
        for (std::size_t k = 0; k < n; ++k) {
            const std::size_t next = (k + 1) % n;
            if (k == i || k == j || next == i || next == j) continue;
            const Vec3& a = points_[k];
            const Vec3& b = points_[next];
            if (differ(side(points_[i], points_[j], a), side(points_[i], points_[j], b)) &&
                differ(side(a, b, points_[i]), side(a, b, points_[j])))
                return true;
        }
        return false;
    }

    std::vector<Vec3> points_;
    Vec3 normal_;
};

} // namespace

bool isChord(const PolyMesh& mesh,
             const Bends& bends,
             std::span<const Label> polygon,
             std::size_t i,
             std::size_t j) {
    std::vector<Vec3> points;
    std::vector<std::size_t> place(polygon.size());
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        place[k] = points.size();
        points.push_back(mesh.points[index(polygon[k])]);
        const Bend* bend = findBend(bends, polygon[k], polygon[(k + 1) % polygon.size()]);
        if (bend != nullptr) points.push_back(bend->at);
    }
    return SeenPolygon(std::move(points)).isChord(place[i], place[j]);
}

} // namespace polymesh
