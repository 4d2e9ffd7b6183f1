// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/triangulate.h"

#include <algorithm>

namespace polymesh {

namespace {

/// The best triangulation of the corners i ... j, by dynamic programming over the diagonals.
class Triangulation {
public:
    Triangulation(std::span<const Label> polygon,
                  const MayJoin& mayJoin,
                  const TriangleQuality& quality)
        : polygon_(polygon), quality_(quality), size_(polygon.size()), best_(size_ * size_) {
        for (std::size_t gap = 2; gap < size_; ++gap)
            for (std::size_t i = 0; i + gap < size_; ++i)
                if (gap == size_ - 1 || mayJoin(polygon[i], polygon[i + gap])) choose(i, i + gap);
        for (std::size_t i = 0; i + 1 < size_; ++i)
            at(i, i + 1).quality = 1;
    }

    std::vector<Triangle> result() const {
        constexpr double flat = 1e-7;
        std::vector<Triangle> triangles;
        if (at(0, size_ - 1).quality > flat) collect(0, size_ - 1, triangles);
        return triangles;
    }

private:
    struct Choice {
        double quality = 0;
        std::size_t apex = 0;
    };

    Choice& at(std::size_t i, std::size_t j) { return best_[i * size_ + j]; }

    const Choice& at(std::size_t i, std::size_t j) const { return best_[i * size_ + j]; }

    void choose(std::size_t i, std::size_t j) {
        for (std::size_t k = i + 1; k < j; ++k) {
            const double left = k == i + 1 ? 1 : at(i, k).quality;
            const double right = k + 1 == j ? 1 : at(k, j).quality;
            const double quality =
                std::min({left, right, quality_(polygon_[i], polygon_[k], polygon_[j])});
            if (quality > at(i, j).quality) at(i, j) = {quality, k};
        }
    }

    void collect(std::size_t i, std::size_t j, std::vector<Triangle>& triangles) const {
        if (j - i < 2) return;
        const std::size_t k = at(i, j).apex;
        triangles.push_back({polygon_[i], polygon_[k], polygon_[j]});
        collect(i, k, triangles);
        collect(k, j, triangles);
    }

    std::span<const Label> polygon_;
    const TriangleQuality& quality_;
    std::size_t size_;
    std::vector<Choice> best_; // by first and last corner
};

} // namespace

std::vector<Triangle> triangulate(std::span<const Label> polygon,
                                  const MayJoin& mayJoin,
                                  const TriangleQuality& quality) {
    if (polygon.size() < 3) return {};
    return Triangulation(polygon, mayJoin, quality).result();
}

std::vector<Triangle>
triangulate(std::span<const Vec3> points, std::span<const Label> polygon, const MayJoin& mayJoin) {
    const auto at = [&](Label p) { return points[index(p)]; };
    Vec3 normal;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        normal += cross(at(polygon[i - 1]) - at(polygon[0]), at(polygon[i]) - at(polygon[0]));
    const double length = norm(normal);
    if (!(length > 0)) return {};
    return triangulate(polygon, mayJoin, [&](Label i, Label k, Label j) {
        const Vec3 a = at(k) - at(i);
        const Vec3 b = at(j) - at(i);
        const double sides = squaredNorm(a) + squaredNorm(b) + squaredNorm(b - a);
        return sides > 0 ? dot(cross(a, b), normal) / (length * sides) : 0;
    });
}

} // namespace polymesh
