// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trimCell/cutByCells.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/threadLimit.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/refine/refine.h"
#include "tests/libpolymesh/trimCell/bothWays.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <set>

namespace polymesh::test {
namespace {

/// A random place with coordinates in [low, high].
Vec3 placeIn(std::mt19937& random, double low, double high) {
    const auto at = [&] {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    const double x = at();
    const double y = at();
    return {x, y, at()};
}

/// A random multiple of 1 / parts in [0, 1].
double gridPlace(std::mt19937& random, unsigned parts) {
    return static_cast<double>(random() % (parts + 1)) / parts;
}

TEST(CutByCells, givesTheSameCutForConvexAndDentedParts) {
    const PolyMesh mesh = box(4, 3, 3);
    std::mt19937 random(1);
    for (unsigned i = 0; i < 30; ++i) {
        const double roughness = i % 3 == 0 ? 0 : 0.6;
        const TriSurface part = dentedSphere(
            1 + static_cast<int>(i % 3), placeIn(random, 0.3, 0.7), 0.45, roughness, i);
        expectSameCut(mesh, part, fmt::format("part {}", i));
    }
}

TEST(CutByCells, givesTheSameCutWhereThePartLeavesTheMesh) {
    std::mt19937 random(2);
    for (unsigned i = 0; i < 10; ++i)
        expectSameCut(box(3, 3, 3),
                      dentedSphere(2, placeIn(random, 0, 1), 0.6, 0.5, i),
                      fmt::format("part {}", i));
}

TEST(CutByCells, givesTheSameCutOnGridPlanesEdgesAndNodes) {
    const PolyMesh mesh = box(4, 4, 4);
    std::mt19937 random(3);
    for (unsigned i = 0; i < 30; ++i) {
        Box part;
        while (part.size().x <= 0 || part.size().y <= 0 || part.size().z <= 0)
            for (int k = 0; k < 2; ++k)
                part.add(Vec3{gridPlace(random, 8), gridPlace(random, 4), gridPlace(random, 12)});
        expectSameCut(mesh, cuboid(part.min, part.max), fmt::format("box {}", i));
    }
    for (const double radius : {0.25, 0.375, 0.5})
        for (const double x : {0.5, 0.375, 0.4})
            expectSameCut(
                mesh, sphere(0, radius, {x, 0.5, 0.5}), fmt::format("octahedron {} {}", radius, x));
}

/// A node, the middle of an edge, of a face or of a diagonal of one, or any place.
Vec3 placeOnMesh(std::mt19937& random, const PolyMesh& mesh) {
    const auto face = mesh.faces[static_cast<Label>(random() % index(mesh.faceCount()))];
    const auto n = face.size();
    const auto at = [&](std::size_t i) { return mesh.points[index(face[i % n])]; };
    const std::size_t i = random() % n;
    switch (random() % 5) {
    case 0:
        return at(i);
    case 1:
        return 0.5 * (at(i) + at(i + 1));
    case 2:
        return 0.5 * (at(i) + at(i + 2));
    case 3: {
        Vec3 sum;
        for (std::size_t k = 0; k < n; ++k)
            sum += at(k);
        return sum / static_cast<double>(n);
    }
    default:
        return placeIn(random, 0, 1);
    }
}

TEST(CutByCells, givesTheSameCutWhereCornersLieOnTheMesh) {
    std::mt19937 random(9);
    for (unsigned i = 0; i < 600; ++i) {
        const PolyMesh mesh = i % 2 == 0 ? box(2, 2, 2) : jittered(box(2, 2, 2), 0.0002 * i, i);
        std::vector<Vec3> corners(4);
        std::ranges::generate(corners, [&] { return placeOnMesh(random, mesh); });
        const int side = orient3d(corners[0], corners[1], corners[2], corners[3]);
        if (side == 0) continue;
        if (side > 0) std::swap(corners[0], corners[1]);
        expectSameCut(mesh,
                      surfaceOf(corners, {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}}),
                      fmt::format("tetrahedron {}", i));
    }
}

TEST(CutByCells, givesTheSameCutForPartsThatTouchThemselves) {
    std::mt19937 random(4);
    for (unsigned i = 0; i < 10; ++i) {
        std::set<std::array<int, 3>> places;
        for (int k = 0; k < 6; ++k) {
            const auto at = [&] { return static_cast<int>(random() % 3); };
            const int x = at();
            const int y = at();
            places.insert({x, y, at()});
        }
        TriSurface part = cubes(places);
        expectSameCut(box(3, 3, 3, {3, 3, 3}), part, fmt::format("cubes {}, on the grid", i));
        for (Vec3& p : part.points)
            p += {0.31, 0.17, 0.4};
        expectSameCut(box(4, 4, 4, {4, 4, 4}), part, fmt::format("cubes {}", i));
    }
}

TEST(CutByCells, givesTheSameCutOfWarpedMeshes) {
    std::mt19937 random(5);
    for (unsigned i = 0; i < 20; ++i)
        expectSameCut(jittered(box(3, 3, 3), 0.03 + 0.005 * i, i),
                      dentedSphere(2, placeIn(random, 0.4, 0.6), 0.5, 0.5, i),
                      fmt::format("mesh {}", i));
}

TEST(CutByCells, givesTheSameCutOfRefinedMeshes) {
    std::mt19937 random(6);
    const HexCells coarse = hexCells(CartesianBox{{{0, 0, 0}, {1, 1, 1}}, {3, 3, 3}});
    for (unsigned i = 0; i < 6; ++i) {
        const Vec3 centre = placeIn(random, 0, 1);
        const Criterion isNear = [&](const RefineCell& cell) {
            return cell.level < 2 && norm(cell.centre - centre) < cell.radius;
        };
        const PolyMesh mesh = refine(coarse, {{isNear}, 1}).mesh;
        const TriSurface part = dentedSphere(2, placeIn(random, 0.3, 0.7), 0.5, 0.5, i);
        expectSameCut(mesh, part, fmt::format("mesh {}", i));
        expectSameCut(jittered(mesh, 0.03, i), part, fmt::format("warped mesh {}", i));
        expectSameCut(mesh,
                      cuboid({0.25, 1.0 / 3, 0.1}, {0.75, 5.0 / 6, 0.9}),
                      fmt::format("box in mesh {}", i));
    }
}

TEST(CutByCells, givesTheSameCutWithHolesIslandsAndVoids) {
    const PolyMesh mesh = box(2, 2, 2);
    // A rod through the middles of faces; its outside leaves a hole in each.
    expectSameCut(mesh, cuboid({-0.5, 0.2, 0.2}, {1.5, 0.3, 0.35}), "rod");
    expectSameCut(jittered(mesh, 0.04), cuboid({-0.5, 0.2, 0.2}, {1.5, 0.3, 0.35}), "warped rod");
    // Balls within one cell, across one face and with a void.
    const TriSurface balls =
        join(sphere(1, 0.08, {0.2, 0.2, 0.2}), sphere(1, 0.09, {0.3, 0.4, 0.3}));
    expectSameCut(mesh, balls, "balls in a cell");
    expectSameCut(mesh, sphere(1, 0.1, {0.5, 0.2, 0.3}), "ball across a face");
    expectSameCut(
        jittered(mesh, 0.05), sphere(1, 0.2, {0.5, 0.25, 0.3}), "ball across a warped face");
    const TriSurface hollow =
        join(sphere(2, 0.4, {0.5, 0.5, 0.5}), inverted(sphere(1, 0.1, {0.3, 0.6, 0.6})));
    expectSameCut(mesh, hollow, "hollow ball");
    // A tube within one layer of cells: walls thinner than a cell, a hole in the hole.
    const TriSurface tube = join(cuboid({-1, 0.1, 0.1}, {2, 0.4, 0.4}),
                                 inverted(cuboid({-0.9, 0.15, 0.15}, {1.9, 0.35, 0.35})));
    expectSameCut(mesh, tube, "tube");
    expectSameCut(jittered(mesh, 0.02), tube, "tube in a warped mesh");
}

TEST(CutByCells, givesTheSameCutOfSmallPartsInWarpedCells) {
    std::mt19937 random(7);
    for (unsigned i = 0; i < 1000; ++i) {
        const PolyMesh mesh = jittered(box(2, 2, 2), 0.02 + 0.0001 * i, i);
        expectSameCut(
            mesh, sphere(0, 0.02, placeIn(random, 0.05, 0.95)), fmt::format("part {}", i));
    }
}

/// Triangles whose normal is rounding alone: one way must not lose them in its search.
TEST(CutByCells, givesTheSameCutOfSlivers) {
    std::mt19937 random(8);
    for (unsigned i = 0; i < 300; ++i) {
        Vec3 a = placeIn(random, 0, 1);
        Vec3 b = placeIn(random, 0, 1);
        const Vec3 d = placeIn(random, 0, 1);
        const Vec3 c = a + placeIn(random, 0.2, 0.8).x * (b - a);
        const int side = orient3d(a, b, c, d);
        if (side == 0) continue;
        if (side > 0) std::swap(a, b);
        expectSameCut(box(3, 3, 3),
                      surfaceOf({a, b, c, d}, {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}}),
                      fmt::format("tetrahedron {}", i));
    }
}

TEST(CutByCells, anyOptionGivesTheSameBytes) {
    const PolyMesh mesh = jittered(box(5, 5, 5), 0.02);
    const TriSurface part = join(cuboid({0.21, 0.2, 0.2}, {0.5, 0.77, 0.6}, "block"),
                                 dentedSphere(2, {0.75, 0.5, 0.5}, 0.2, 0.3, 7));
    for (const Keep keep : {Keep::inside, Keep::outside})
        for (const double deviation : {0.0, 0.1})
            for (const Adjust how : {Adjust::none, Adjust::project, Adjust::repel}) {
                TrimOptions options;
                options.keep = keep;
                options.deviation = deviation;
                options.adjust.how = how;
                EXPECT_EQ(trimByCells(mesh, part, options), trim(mesh, part, options).mesh)
                    << deviation;
            }
    EXPECT_EQ(trimByCells(mesh, part, exact()), trim(mesh, part, exact()).mesh);
}

TEST(CutByCells, isTheSameForAnyNumberOfThreads) {
    const PolyMesh mesh = jittered(box(6, 6, 6), 0.02);
    const TriSurface part = dentedSphere(3, {0.5, 0.5, 0.5}, 0.45, 0.4, 3);
    std::vector<PolyMesh> meshes;
    for (const std::size_t threads : {1U, 2U, 8U}) {
        const ThreadLimit limit(threads);
        meshes.push_back(trimByCells(mesh, part, exact()));
    }
    EXPECT_EQ(meshes[0], meshes[1]);
    EXPECT_EQ(meshes[0], meshes[2]);
}

TEST(CutByCells, refusesPartsThatOverlap) {
    const TriSurface both =
        join(cuboid({0.1, 0.1, 0.1}, {0.7, 0.6, 0.6}), cuboid({0.4, 0.3, 0.35}, {0.9, 0.9, 0.8}));
    EXPECT_THROW(trimByCells(box(3, 3, 3), both, exact()), InputError);
}

} // namespace
} // namespace polymesh::test
