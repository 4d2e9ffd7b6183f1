// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Meshes built in code, shared by all tests.

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace polymesh::test {

using Polygon = std::vector<Label>;
using Polyhedron = std::vector<Polygon>; // faces as outward loops

/// The mesh of the given polyhedra. Faces with equal point sets are shared; the others go to the
/// patch that patchOf(face centre) names. Patches come in alphabetical order.
inline PolyMesh meshOf(
    std::vector<Vec3> points,
    const std::vector<Polyhedron>& cells,
    const std::function<std::string(const Vec3&)>& patchOf = [](const Vec3&) {
        return std::string("walls");
    }) {
    struct Side {
        Polygon loop;
        Label owner = -1;
        Label neighbour = -1;
    };

    std::map<std::set<Label>, Side> sides;
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (const Polygon& loop : cells[c]) {
            Side& side = sides[std::set<Label>(loop.begin(), loop.end())];
            if (side.owner < 0) {
                side.loop = loop;
                side.owner = toLabel(c);
            } else {
                side.neighbour = toLabel(c);
            }
        }
    std::map<std::pair<Label, Label>, std::vector<const Side*>> internal;
    std::map<std::string, std::map<Label, std::vector<const Side*>>> boundary;
    for (const auto& [key, side] : sides) {
        if (side.neighbour >= 0) {
            internal[{side.owner, side.neighbour}].push_back(&side);
            continue;
        }
        Vec3 centre;
        for (const Label p : side.loop)
            centre += points[index(p)];
        boundary[patchOf(centre / static_cast<double>(side.loop.size()))][side.owner].push_back(
            &side);
    }
    PolyMesh mesh;
    mesh.points = std::move(points);
    mesh.cellCount = toLabel(cells.size());
    for (const auto& [pair, list] : internal)
        for (const Side* side : list) {
            mesh.faces.add(side->loop);
            mesh.owner.push_back(side->owner);
            mesh.neighbour.push_back(side->neighbour);
        }
    for (const auto& [name, byOwner] : boundary) {
        Patch patch;
        patch.name = name;
        patch.start = mesh.faceCount();
        for (const auto& [owner, list] : byOwner)
            for (const Side* side : list) {
                mesh.faces.add(side->loop);
                mesh.owner.push_back(owner);
            }
        patch.size = mesh.faceCount() - patch.start;
        mesh.patches.push_back(patch);
    }
    return mesh;
}

/// The hexahedron of eight corners in OpenFOAM's order: bottom loop 0 1 2 3, top loop 4 5 6 7.
inline Polyhedron hexahedron(const std::array<Label, 8>& v) {
    return {{v[0], v[4], v[7], v[3]},
            {v[1], v[2], v[6], v[5]},
            {v[0], v[1], v[5], v[4]},
            {v[3], v[7], v[6], v[2]},
            {v[0], v[3], v[2], v[1]},
            {v[4], v[5], v[6], v[7]}};
}

/// A box from the origin to `size`, of nx x ny x nz hexahedra; patches xMin, xMax, yMin ... zMax.
inline PolyMesh box(Label nx, Label ny, Label nz, const Vec3& size = {1, 1, 1}) {
    const auto at = [&](Label i, Label j, Label k) { return i + (nx + 1) * (j + (ny + 1) * k); };
    const auto along = [](double length, Label i, Label n) {
        return length * static_cast<double>(i) / static_cast<double>(n);
    };
    std::vector<Vec3> points;
    for (Label k = 0; k <= nz; ++k)
        for (Label j = 0; j <= ny; ++j)
            for (Label i = 0; i <= nx; ++i)
                points.push_back(
                    {along(size.x, i, nx), along(size.y, j, ny), along(size.z, k, nz)});
    std::vector<Polyhedron> cells;
    for (Label k = 0; k < nz; ++k)
        for (Label j = 0; j < ny; ++j)
            for (Label i = 0; i < nx; ++i)
                cells.push_back(hexahedron({at(i, j, k),
                                            at(i + 1, j, k),
                                            at(i + 1, j + 1, k),
                                            at(i, j + 1, k),
                                            at(i, j, k + 1),
                                            at(i + 1, j, k + 1),
                                            at(i + 1, j + 1, k + 1),
                                            at(i, j + 1, k + 1)}));
    return meshOf(std::move(points), cells, [&](const Vec3& c) -> std::string {
        const double margin = 1e-6;
        if (c.x < margin * size.x) return "xMin";
        if (c.x > (1 - margin) * size.x) return "xMax";
        if (c.y < margin * size.y) return "yMin";
        if (c.y > (1 - margin) * size.y) return "yMax";
        return c.z < margin * size.z ? "zMin" : "zMax";
    });
}

inline PolyMesh unitCube() {
    return box(1, 1, 1);
}

inline PolyMesh twoHexes() {
    return box(2, 1, 1, {2, 1, 1});
}

/// The mesh with every point moved by up to `amplitude` in each direction, always alike.
inline PolyMesh jittered(PolyMesh mesh, double amplitude, unsigned seed = 1) {
    std::mt19937 random(seed);
    const auto shift = [&] {
        return amplitude * (static_cast<double>(random()) / 2147483648.0 - 1.0);
    };
    for (Vec3& p : mesh.points) {
        const double x = shift();
        const double y = shift();
        p += {x, y, shift()};
    }
    return mesh;
}

/// n prisms of height 1 round an axis that all of them use.
inline PolyMesh prismFan(Label n) {
    std::vector<Vec3> points{{0, 0, 0}, {0, 0, 1}};
    for (Label i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        points.push_back({std::cos(angle), std::sin(angle), 0});
        points.push_back({std::cos(angle), std::sin(angle), 1});
    }
    std::vector<Polyhedron> cells;
    for (Label i = 0; i < n; ++i) {
        const Label a = 2 + 2 * i;
        const Label b = 2 + 2 * ((i + 1) % n);
        cells.push_back({{0, b, a},
                         {1, a + 1, b + 1},
                         {0, a, a + 1, 1},
                         {a, b, b + 1, a + 1},
                         {b, 0, 1, b + 1}});
    }
    return meshOf(std::move(points), cells);
}

/// One concave cell: the L of three unit squares, of height 1.
inline PolyMesh lShapedCell() {
    const std::array<std::array<double, 2>, 6> corners{
        {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
    std::vector<Vec3> points;
    for (const double z : {0.0, 1.0})
        for (const auto& c : corners)
            points.push_back({c[0], c[1], z});
    Polyhedron cell{{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
    for (Label i = 0; i < 6; ++i)
        cell.push_back({i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
    return meshOf(std::move(points), {cell});
}

inline PolyMesh tetrahedron() {
    return meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                  {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}});
}

/// Base 1 x 1, height 1.
inline PolyMesh pyramid() {
    return meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}},
                  {{{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}});
}

/// OpenFOAM's wedge: a hexahedron with one edge collapsed.
inline PolyMesh wedge() {
    return meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                  {{{0, 2, 1}, {3, 4, 5, 6}, {0, 3, 6}, {1, 2, 5, 4}, {0, 1, 4, 3}, {0, 6, 5, 2}}});
}

/// A big hexahedron beside four small ones: its face towards them is four faces (hanging nodes).
inline PolyMesh hangingNodes() {
    PolyMesh fine = box(1, 2, 2, {1, 2, 2});
    std::vector<Vec3> points = fine.points; // (i, j, k) at i + 2 (j + 3 k)
    const auto at = [](Label i, Label j, Label k) { return i + 2 * (j + 3 * k); };
    const Label first = toLabel(points.size());
    for (const double z : {0.0, 2.0})
        for (const double y : {0.0, 2.0})
            points.push_back({3, y, z});
    std::vector<Polyhedron> cells;
    for (Label k = 0; k < 2; ++k)
        for (Label j = 0; j < 2; ++j)
            cells.push_back(hexahedron({at(0, j, k),
                                        at(1, j, k),
                                        at(1, j + 1, k),
                                        at(0, j + 1, k),
                                        at(0, j, k + 1),
                                        at(1, j, k + 1),
                                        at(1, j + 1, k + 1),
                                        at(0, j + 1, k + 1)}));
    const auto p = [&](Label j, Label k) { return at(1, j, k); };
    const Label q = first;
    Polyhedron big{{q, q + 1, q + 3, q + 2},
                   {p(0, 0), q, q + 2, p(0, 2), p(0, 1)},
                   {p(2, 0), p(2, 1), p(2, 2), q + 3, q + 1},
                   {p(0, 0), p(1, 0), p(2, 0), q + 1, q},
                   {p(0, 2), q + 2, q + 3, p(2, 2), p(1, 2)}};
    for (Label k = 0; k < 2; ++k)
        for (Label j = 0; j < 2; ++j)
            big.push_back({p(j, k), p(j, k + 1), p(j + 1, k + 1), p(j + 1, k)});
    cells.push_back(big);
    return meshOf(std::move(points), cells);
}

/// A unit cube whose top is missing.
inline PolyMesh openCell() {
    Polyhedron cell = hexahedron({0, 1, 2, 3, 4, 5, 6, 7});
    cell.pop_back();
    return meshOf(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
        {cell});
}

/// A unit cube all of whose faces point inwards.
inline PolyMesh invertedCell() {
    PolyMesh mesh = unitCube();
    for (Label face = 0; face < mesh.faceCount(); ++face)
        std::reverse(mesh.faces[face].begin(), mesh.faces[face].end());
    return mesh;
}

/// The sum of the cells' volumes.
inline double volumeOf(const PolyMesh& mesh) {
    const std::vector<double> volumes = computeGeometry(mesh).cellVolumes;
    return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

} // namespace polymesh::test
