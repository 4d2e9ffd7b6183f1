// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Surfaces built in code, shared by all tests. Normals point outward.

#include "libpolymesh/geometry/box.h"
#include "libpolymesh/surface/surfaceBuilder.h"
#include "libpolymesh/surface/triSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace polymesh::test {

/// The surface of these polygons, all in region `region`.
inline TriSurface surfaceOf(const std::vector<Vec3>& points,
                            const std::vector<std::vector<Label>>& polygons,
                            const std::string& region = "walls") {
    SurfaceBuilder builder;
    const Label label = builder.addRegion(region);
    for (const auto& polygon : polygons) {
        std::vector<Label> corners;
        for (Label p : polygon)
            corners.push_back(builder.addPoint(points[index(p)]));
        builder.addPolygon(corners, label);
    }
    return builder.finish("walls");
}

/// 12 triangles; the first two are the floor, the last two the lid.
inline TriSurface cuboid(const Vec3& min = {0, 0, 0},
                         const Vec3& max = {1, 1, 1},
                         const std::string& region = "walls") {
    std::vector<Vec3> points;
    for (int i = 0; i < 8; ++i)
        points.push_back({(i & 1) != 0 ? max.x : min.x,
                          (i & 2) != 0 ? max.y : min.y,
                          (i & 4) != 0 ? max.z : min.z});
    return surfaceOf(
        points,
        {{0, 2, 3, 1}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}, {4, 5, 7, 6}},
        region);
}

/// A prism over a regular n-gon of radius 1 in the xy plane, from z = 0 to z = height.
inline TriSurface cylinder(Label n, double height = 2) {
    std::vector<Vec3> points;
    for (double z : {0.0, height})
        for (Label i = 0; i < n; ++i) {
            const double angle =
                2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
            points.push_back({std::cos(angle), std::sin(angle), z});
        }
    std::vector<std::vector<Label>> polygons(2);
    for (Label i = 0; i < n; ++i) {
        const Label j = (i + 1) % n;
        polygons[0].insert(polygons[0].begin(), i);
        polygons[1].push_back(n + i);
        polygons.push_back({i, j, n + j, n + i});
    }
    return surfaceOf(points, polygons);
}

/// A sphere: an octahedron whose triangles are divided into four `divisions` times.
inline TriSurface sphere(int divisions, double radius = 1, const Vec3& centre = {}) {
    std::vector<Vec3> points{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<std::vector<Label>> triangles{
        {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};
    for (int division = 0; division < divisions; ++division) {
        std::vector<std::vector<Label>> finer;
        for (const auto& t : triangles) {
            std::array<Label, 3> middle{};
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3 sum = points[index(t[i])] + points[index(t[(i + 1) % 3])];
                middle[i] = toLabel(points.size());
                points.push_back(sum / norm(sum)); // equal points are merged by surfaceOf
            }
            finer.push_back({t[0], middle[0], middle[2]});
            finer.push_back({t[1], middle[1], middle[0]});
            finer.push_back({t[2], middle[2], middle[1]});
            finer.push_back({middle[0], middle[1], middle[2]});
        }
        triangles = std::move(finer);
    }
    for (Vec3& p : points)
        p = centre + radius * p;
    return surfaceOf(points, triangles);
}

/// The surface of a set of unit cubes, named by their lowest corners: it touches itself where cubes
/// have only an edge or a corner in common.
inline TriSurface cubes(const std::set<std::array<int, 3>>& places) {
    std::vector<Vec3> points;
    std::vector<std::vector<Label>> polygons;
    for (const auto& place : places)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1}) {
                std::array<int, 3> beyond = place;
                beyond[axis] += 2 * side - 1;
                if (places.contains(beyond)) continue;
                const Label first = toLabel(points.size());
                for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                    std::array<int, 3> corner = place;
                    corner[axis] += side;
                    corner[(axis + 1) % 3] += side == 1 ? u : v;
                    corner[(axis + 2) % 3] += side == 1 ? v : u;
                    points.push_back({static_cast<double>(corner[0]),
                                      static_cast<double>(corner[1]),
                                      static_cast<double>(corner[2])});
                }
                polygons.push_back({first, first + 1, first + 2, first + 3});
            }
    return surfaceOf(points, polygons);
}

/// Both surfaces as one; equal points are merged, regions of the same name too.
inline TriSurface join(const TriSurface& a, const TriSurface& b) {
    SurfaceBuilder builder;
    for (const TriSurface* surface : {&a, &b})
        for (Label t = 0; t < surface->triangleCount(); ++t) {
            std::array<Label, 3> corners{};
            for (int i = 0; i < 3; ++i)
                corners[static_cast<std::size_t>(i)] = builder.addPoint(surface->corner(t, i));
            const Label region = surface->region[index(t)];
            builder.addPolygon(corners, builder.addRegion(surface->regionNames[index(region)]));
        }
    return builder.finish("walls");
}

/// The surface with the triangle's normal turned round.
inline void turn(TriSurface& surface, Label t) {
    std::swap(surface.triangles[index(t)][1], surface.triangles[index(t)][2]);
}

inline TriSurface inverted(TriSurface surface) {
    for (Label t = 0; t < surface.triangleCount(); ++t)
        turn(surface, t);
    return surface;
}

/// The surface without triangle t.
inline TriSurface without(TriSurface surface, Label t) {
    surface.triangles.erase(surface.triangles.begin() + t);
    surface.region.erase(surface.region.begin() + t);
    return surface;
}

/// The same surface with its triangles in another order, each beginning at another corner.
inline TriSurface shuffled(TriSurface surface, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::vector<std::size_t> order(surface.triangles.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random() % i]);
    TriSurface result = surface;
    for (std::size_t i = 0; i < order.size(); ++i) {
        result.triangles[i] = surface.triangles[order[i]];
        result.region[i] = surface.region[order[i]];
        const auto shift = static_cast<std::ptrdiff_t>(random() % 3);
        std::rotate(result.triangles[i].begin(),
                    result.triangles[i].begin() + shift,
                    result.triangles[i].end());
    }
    return result;
}

} // namespace polymesh::test
