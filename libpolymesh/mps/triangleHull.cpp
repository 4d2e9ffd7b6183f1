// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/triangleHull.h"

#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/geometry/solidAngle.h"
#include "libpolymesh/mps/mendFlat.h"
#include "libpolymesh/mps/pointWithin.h"
#include "libpolymesh/surface/check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace polymesh {

namespace {

/// A side of a tetrahedron, or a triangle of the hull.
struct Side {
    Triangle key;    // ascending
    Triangle points; // seen from outside of the tetrahedron
    int tetrahedron; // -1 - the number of a triangle of the hull
};

Side sideOf(const Triangle& points, int tetrahedron) {
    Triangle key = points;
    std::ranges::sort(key);
    return {key, points, tetrahedron};
}

/// Whether two sides of the same points are seen from the same side.
bool isSameWay(const Side& a, const Side& b) {
    const auto at = std::ranges::find(b.points, a.points[0]) - b.points.begin();
    return b.points[static_cast<std::size_t>(at + 1) % 3] == a.points[1];
}

TriSurface surfaceOf(const TriangleHull& hull) {
    TriSurface surface;
    surface.points = hull.points;
    surface.triangles = hull.triangles;
    return surface;
}

/// The sides of all tetrahedra and the triangles of the hull, those of the same points beside each
/// other.
std::vector<Side> sidesOf(const TriangleHull& hull, const TetMesh& mesh) {
    std::vector<Side> sides;
    for (std::size_t t = 0; t < hull.triangles.size(); ++t)
        sides.push_back(sideOf(hull.triangles[t], -1 - static_cast<int>(t)));
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        const auto& [a, b, c, d] = mesh.tetrahedra[t];
        for (const Triangle& outward :
             {Triangle{a, c, b}, Triangle{a, b, d}, Triangle{b, c, d}, Triangle{c, a, d}})
            sides.push_back(sideOf(outward, static_cast<int>(t)));
    }
    std::ranges::sort(sides, [](const Side& s, const Side& t) {
        return std::pair(s.key, s.tetrahedron) < std::pair(t.key, t.tetrahedron);
    });
    return sides;
}

/// Turns the tetrahedra so that their volumes are above zero and mends those that are nearly flat;
/// false when one is flat or has a point that is not there.
bool mend(const TriangleHull& hull, TetMesh& mesh) {
    std::vector<Vec3> points = hull.points;
    points.insert(points.end(), mesh.newPoints.begin(), mesh.newPoints.end());
    for (auto& t : mesh.tetrahedra) {
        if (std::ranges::any_of(t, [&](Label p) { return p < 0 || index(p) >= points.size(); }))
            return false;
        const auto at = [&](std::size_t i) { return points[index(t[i])]; };
        const int sign = orient3d(at(0), at(1), at(2), at(3));
        if (sign == 0) return false;
        if (sign < 0) std::swap(t[0], t[1]);
    }
    mendFlat(points, mesh);
    return true;
}

/// Whether the triangles lie round a point once.
bool isOnceRound(const TriangleHull& hull, const Vec3& point) {
    double sum = 0;
    for (const Triangle& t : hull.triangles)
        sum += solidAngle(
            point, hull.points[index(t[0])], hull.points[index(t[1])], hull.points[index(t[2])]);
    return std::abs(sum - 4 * std::numbers::pi) < 1;
}

} // namespace

std::optional<Vec3> pointThatSees(const TriangleHull& hull) {
    std::vector<HalfSpace> planes;
    Vec3 mean;
    for (const Triangle& t : hull.triangles) {
        const Vec3& a = hull.points[index(t[0])];
        const Vec3& b = hull.points[index(t[1])];
        const Vec3& c = hull.points[index(t[2])];
        const Vec3 normal = cross(b - a, c - a);
        const double length = norm(normal);
        planes.push_back({length > 0 ? normal / -length : Vec3{}, a});
        mean += (a + b + c) / 3;
    }
    mean = mean / static_cast<double>(planes.size());
    double reach = 0;
    for (const Vec3& p : hull.points)
        reach = std::max(reach, norm(p - mean));
    const auto point = pointWithin(planes, mean, reach);
    return point && isOnceRound(hull, *point) ? point : std::nullopt;
}

std::vector<std::array<Label, 2>> crossingPairs(const TriangleHull& hull) {
    constexpr Label all = 10000;
    return findSelfIntersections(surfaceOf(hull), all).first;
}

Label crossingsOf(const TriangleHull& hull) {
    return findSelfIntersections(surfaceOf(hull), 0).count;
}

std::optional<CellCones>
tetrahedraIn(Label cell, const TriangleHull& hull, const Tetrahedraliser& tetrahedralise) {
    if (!tetrahedralise) return std::nullopt;
    auto mesh = tetrahedralise(surfaceOf(hull));
    if (!mesh || !mend(hull, *mesh)) return std::nullopt;
    CellCones cones{cell, mesh->newPoints, std::vector<int>(hull.triangles.size(), -1), 0, {}};
    cones.groupCount = static_cast<int>(mesh->tetrahedra.size());
    const auto labelOf = [&](Label p) {
        return index(p) < hull.labels.size() ? hull.labels[index(p)]
                                             : toLabel(hull.labels.size()) - 1 - p;
    };
    const std::vector<Side> sides = sidesOf(hull, *mesh);
    for (std::size_t i = 0; i < sides.size(); i += 2) {
        if (i + 1 == sides.size() || sides[i].key != sides[i + 1].key) return std::nullopt;
        const auto& [first, second] = std::tie(sides[i], sides[i + 1]);
        if (second.tetrahedron < 0) return std::nullopt;
        // A hull inside out is filled too, by tetrahedra that lie outside of it.
        if (isSameWay(first, second) != (first.tetrahedron < 0)) return std::nullopt;
        if (first.tetrahedron < 0) {
            cones.groupOf[static_cast<std::size_t>(-1 - first.tetrahedron)] = second.tetrahedron;
            continue;
        }
        CellWall wall{{}, first.tetrahedron, second.tetrahedron};
        for (const Label p : first.points)
            wall.loop.push_back(labelOf(p));
        cones.walls.push_back(std::move(wall));
    }
    return cones;
}

} // namespace polymesh
