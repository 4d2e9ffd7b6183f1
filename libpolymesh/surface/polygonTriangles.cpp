// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/polygonTriangles.h"

#include "libpolymesh/geometry/box.h"
#include "libpolymesh/geometry/predicates.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace polymesh {

namespace {

using Corners = std::array<std::size_t, 3>;

/// A polygon seen along an axis so that it runs to the left.
class View {
public:
    explicit View(std::span<const Vec3> polygon) : polygon_(polygon) {
        Vec3 normal;
        for (std::size_t i = 2; i < polygon.size(); ++i)
            normal += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
        for (int axis = 1; axis < 3; ++axis)
            if (std::abs(normal[axis]) > std::abs(normal[axis_])) axis_ = axis;
        sign_ = normal[axis_] < 0 ? -1 : 1;
    }

    /// +1 where the three corners turn left.
    int turn(std::size_t a, std::size_t b, std::size_t c) const {
        return sign_ * normalSign(polygon_[a], polygon_[b], polygon_[c], axis_);
    }

    bool isFolded(const Corners& t) const { return turn(t[0], t[1], t[2]) < 0; }

    /// Whether the triangle lies in what is left of the polygon: it turns left and holds no corner.
    bool isEar(const Corners& t, std::span<const std::size_t> left) const {
        if (turn(t[0], t[1], t[2]) <= 0) return false;
        return std::ranges::none_of(left, [&](std::size_t p) {
            const Vec3& point = polygon_[p];
            if (point == polygon_[t[0]] || point == polygon_[t[1]] || point == polygon_[t[2]])
                return false;
            return turn(t[0], t[1], p) >= 0 && turn(t[1], t[2], p) >= 0 && turn(t[2], t[0], p) >= 0;
        });
    }

    double cutLength(const Corners& t) const { return norm(polygon_[t[2]] - polygon_[t[0]]); }

private:
    std::span<const Vec3> polygon_;
    int axis_ = 0;
    int sign_ = 1;
};

std::vector<Corners> fan(std::size_t count) {
    std::vector<Corners> triangles;
    for (std::size_t i = 2; i < count; ++i)
        triangles.push_back({0, i - 1, i});
    return triangles;
}

/// Empty when there is a time without an ear.
std::vector<Corners> cutEars(const View& view, std::size_t count) {
    std::vector<std::size_t> left(count);
    std::iota(left.begin(), left.end(), std::size_t{0});
    std::vector<Corners> triangles;
    while (left.size() > 2) {
        std::size_t best = left.size();
        double shortest = Box::inf;
        Corners ear{};
        for (std::size_t i = 0; i < left.size(); ++i) {
            const Corners t{
                left[(i + left.size() - 1) % left.size()], left[i], left[(i + 1) % left.size()]};
            if (view.cutLength(t) >= shortest || !view.isEar(t, left)) continue;
            best = i;
            shortest = view.cutLength(t);
            ear = t;
        }
        if (best == left.size()) return {};
        triangles.push_back(ear);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return triangles;
}

} // namespace

std::vector<std::array<std::size_t, 3>> polygonTriangles(std::span<const Vec3> polygon) {
    std::vector<Corners> triangles = fan(polygon.size());
    if (triangles.size() < 2) return triangles;
    const View view(polygon);
    if (std::ranges::none_of(triangles, [&](const Corners& t) { return view.isFolded(t); }))
        return triangles;
    std::vector<Corners> ears = cutEars(view, polygon.size());
    return ears.empty() ? triangles : ears;
}

} // namespace polymesh
