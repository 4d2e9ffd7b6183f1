// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/trim.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/threadLimit.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/surface/measure.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"
#include "tests/support/trimmed.h"

#include <gtest/gtest.h>

#include <random>

namespace polymesh::test {
namespace {

TriSurface octahedron(const Vec3& centre, double radius) {
    return sphere(0, radius, centre);
}

/// A box far larger than the unit cube, turned so that one face lies in the plane through `point`
/// with the given normal: the part below the plane.
TriSurface halfSpace(const Vec3& point, const Vec3& normal) {
    const Vec3 n = normal / norm(normal);
    const Vec3 other = std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 u = cross(n, other) / norm(cross(n, other));
    const Vec3 v = cross(n, u);
    TriSurface surface = cuboid({-20, -20, -40}, {20, 20, 0});
    for (Vec3& p : surface.points)
        p = point + p.x * u + p.y * v + p.z * n;
    return surface;
}

Label countHexahedra(const PolyMesh& mesh) {
    const Rows<Label> facesOf = cellFaces(mesh);
    Label count = 0;
    for (Label c = 0; c < mesh.cellCount; ++c) {
        bool isHex = facesOf.rowSize(c) == 6;
        for (const Label f : facesOf[c])
            isHex = isHex && mesh.faces.rowSize(f) == 4;
        count += isHex ? 1 : 0;
    }
    return count;
}

void expectExact(const PolyMesh& mesh, const TriSurface& surface) {
    const double part = measure(surface).volume;
    const double inside = volumeOf(trimmed(mesh, surface, exact()));
    const double outside = volumeOf(trimmed(mesh, surface, exact(Keep::outside)));
    EXPECT_NEAR(inside / part, 1, 1e-12);
    EXPECT_NEAR((inside + outside) / volumeOf(mesh), 1, 1e-12);
}

TEST(Trim, sliversWhoseNormalIsOnlyRoundingAreNotLost) {
    // Two corners of a triangle of length 12 are one unit in the last place apart.
    const TriSurface surface =
        surfaceOf({{-16.13588375717001, 0.6592335909088672, -32.72854074987478},
                   {-11.464256198601213, 2.3090246706419224, -21.799035484436015},
                   {-11.464256198601213, 2.309024670641922, -21.799035484436015},
                   {-17.2, 4.1, -27.5},
                   {-9.5, -1.2, -28.4}},
                  {{0, 2, 1}, {0, 1, 3}, {0, 4, 2}, {3, 1, 2}, {3, 2, 4}, {0, 3, 4}});
    for (const Label n : {3, 8, 13}) {
        PolyMesh mesh = box(n, n, n, {10, 7, 13});
        for (Vec3& p : mesh.points)
            p += Vec3{-18.1, -2.03, -33.7};
        const double volume = volumeOf(trimmed(mesh, surface, exact()));
        EXPECT_NEAR(volume / measure(surface).volume, 1, 1e-12) << n;
    }
}

TEST(Trim, boxAlignedWithGridGivesTheHexahedraDrawnByHand) {
    const PolyMesh mesh = box(4, 4, 4);
    const PolyMesh inside = trimmed(mesh, cuboid({.25, .25, .25}, {.75, .75, .75}), exact());
    EXPECT_EQ(inside.cellCount, 8);
    EXPECT_EQ(inside.pointCount(), 27);
    EXPECT_EQ(inside.faceCount(), 36);
    EXPECT_EQ(countHexahedra(inside), 8);
    const PolyMesh outside =
        trimmed(mesh, cuboid({.25, .25, .25}, {.75, .75, .75}), exact(Keep::outside));
    EXPECT_EQ(outside.cellCount, 56);
    EXPECT_EQ(countHexahedra(outside), 56);
    EXPECT_EQ(outside.pointCount(), 124);
}

TEST(Trim, boxWithTheFacesOfTheMeshGivesTheMesh) {
    const PolyMesh mesh = box(3, 2, 2);
    const PolyMesh result = trimmed(mesh, cuboid(), exact());
    EXPECT_EQ(result.cellCount, 12);
    EXPECT_EQ(result.faceCount(), mesh.faceCount());
    EXPECT_EQ(result.pointCount(), mesh.pointCount());
    EXPECT_EQ(countHexahedra(result), 12);
}

TEST(Trim, boxThroughTheMiddlesOfCellsHalvesThem) {
    const PolyMesh result =
        trimmed(box(4, 4, 4), cuboid({.125, .25, .25}, {.875, .75, .75}), exact());
    EXPECT_EQ(result.cellCount, 16);
    EXPECT_EQ(countHexahedra(result), 16);
    EXPECT_NEAR(volumeOf(result), 0.75 * 0.25, 1e-15);
}

TEST(Trim, surfacesOnGridPlanesEdgesAndNodesAreExact) {
    const PolyMesh mesh = box(4, 4, 4, {4, 4, 4});
    expectExact(mesh, octahedron({2, 2, 2}, 1));
    expectExact(mesh, octahedron({2, 2, 2}, 1.5));
    expectExact(mesh, octahedron({2, 2, 2}, 2));
    expectExact(mesh, octahedron({1.5, 2, 2}, 1.5));
    expectExact(mesh, cuboid({1, 1, 1}, {3, 2.5, 2}));
    expectExact(mesh, cuboid({0, 1, 0.5}, {4, 2, 1}));
}

TEST(Trim, planeCutsAndTheirComplementsFillTheHexahedron) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    const PolyMesh cube = unitCube();
    for (int i = 0; i < 200; ++i) {
        const Vec3 n{unit(random), unit(random), unit(random)};
        const Vec3 p{0.5 + 0.4 * unit(random), 0.5 + 0.4 * unit(random), 0.5 + 0.4 * unit(random)};
        const TriSurface surface = halfSpace(p, n);
        const double below = volumeOf(trimmed(cube, surface, exact()));
        const double above = volumeOf(trimmed(cube, surface, exact(Keep::outside)));
        ASSERT_NEAR(below + above, 1, 1e-12) << "plane " << i;
        ASSERT_GT(below, 0);
        ASSERT_GT(above, 0);
    }
}

/// Faces and points of the part of a cube that keeps `kept` corners, by what one plane can make.
struct Shape {
    Label faces;
    Label points;
};

std::vector<Shape> shapesKeeping(int kept) {
    switch (kept) {
    case 1:
        return {{4, 4}};
    case 2:
        return {{5, 6}};
    case 3:
        return {{6, 8}};
    case 4:
        return {{6, 8}, {7, 10}};
    default:
        return {{7, 10}};
    }
}

TEST(Trim, everyCornerMaskOfAPlaneGivesItsPolyhedron) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-1, 1);
    const PolyMesh cube = unitCube();
    std::vector<bool> seen(256, false);
    for (int i = 0; i < 6000; ++i) {
        const Vec3 n{unit(random), unit(random), unit(random)};
        const Vec3 p{0.5 + 0.5 * unit(random), 0.5 + 0.5 * unit(random), 0.5 + 0.5 * unit(random)};
        unsigned mask = 0;
        for (std::size_t k = 0; k < 8; ++k)
            if (dot(cube.points[k] - p, n) < 0) mask |= 1U << k;
        const int kept = std::popcount(mask);
        if (kept == 0 || kept == 8 || seen[mask]) continue;
        seen[mask] = true;
        const PolyMesh part = trimmed(cube, halfSpace(p, n), exact());
        ASSERT_EQ(part.cellCount, 1);
        const std::vector<Shape> shapes = shapesKeeping(kept);
        EXPECT_TRUE(std::ranges::any_of(shapes,
                                        [&](const Shape& s) {
                                            return s.faces == part.faceCount() &&
                                                   s.points == part.pointCount();
                                        }))
            << "mask " << mask << ": " << part.faceCount() << " faces, " << part.pointCount()
            << " points";
    }
    EXPECT_EQ(std::ranges::count(seen, true), 102); // of 254 corner sets, one plane can cut these
}

TEST(Trim, distortedMeshesAreTrimmedExactly) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const PolyMesh mesh = jittered(box(5, 5, 5), 0.05, seed);
        expectExact(mesh, octahedron({.5, .5, .5}, .3));
        expectExact(mesh, cuboid({.21, .22, .23}, {.71, .72, .77}));
    }
}

TEST(Trim, meshesWithHangingNodesAreTrimmedExactly) {
    const PolyMesh mesh = hangingNodes();
    const Box bounds = boundingBox(mesh.points);
    const Vec3 c = bounds.centre();
    expectExact(mesh, octahedron(c, 0.3 * bounds.size().y));
    expectExact(mesh, octahedron({c.x, c.y, c.z}, 0.25));
}

TEST(Trim, aPartInsideOneCellIsACellAndLeavesACavity) {
    const PolyMesh mesh = box(3, 3, 3);
    const TriSurface small = octahedron({.5, .5, .5}, .1);
    const PolyMesh inside = trimmed(mesh, small, exact());
    EXPECT_EQ(inside.cellCount, 1);
    EXPECT_EQ(inside.faceCount(), 8);
    const PolyMesh outside = trimmed(mesh, small, exact(Keep::outside));
    EXPECT_EQ(outside.cellCount, 27);
    EXPECT_NEAR(volumeOf(outside), 1 - measure(small).volume, 1e-14);
}

TEST(Trim, aRodThroughTheMiddlesOfFacesOpensHoles) {
    const PolyMesh mesh = box(3, 3, 3, {3, 3, 3});
    const TriSurface rod = cuboid({1.4, 1.3, -1}, {1.6, 1.7, 4});
    const Trimmed result = trim(mesh, rod, exact(Keep::outside));
    EXPECT_TRUE(validate(result.mesh).empty());
    EXPECT_EQ(result.summary.holedFaces, 4);
    EXPECT_NEAR(volumeOf(result.mesh), 27 - 0.2 * 0.4 * 3, 1e-13);
    EXPECT_EQ(trimmed(mesh, rod, exact()).cellCount, 3);
}

TEST(Trim, aWallThinnerThanACellDividesCells) {
    const PolyMesh mesh = box(3, 3, 3, {3, 3, 3});
    const PolyMesh result =
        trimmed(mesh, cuboid({1.45, -1, -1}, {1.55, 4, 4}), exact(Keep::outside));
    EXPECT_EQ(result.cellCount, 36);
    EXPECT_NEAR(volumeOf(result), 27 - 0.1 * 9, 1e-13);
}

TEST(Trim, regionsBecomePatchesAndThePatchesOfTheMeshStay) {
    const PolyMesh mesh = box(4, 4, 4);
    const PolyMesh result =
        trimmed(mesh, cuboid({.3, .3, .3}, {.7, .7, .7}, "body"), exact(Keep::outside));
    ASSERT_EQ(result.patches.size(), mesh.patches.size() + 1);
    EXPECT_EQ(result.patches.back().name, "body");
    EXPECT_EQ(result.patches.back().type, "wall");
    EXPECT_GT(result.patches.back().size, 0);
    EXPECT_EQ(result.patches.front(), [&] {
        Patch patch = mesh.patches.front();
        patch.start = result.internalFaceCount();
        return patch;
    }());
}

TEST(Trim, resultDoesNotDependOnTheNumberOfThreads) {
    const PolyMesh mesh = box(12, 12, 12);
    const TriSurface surface = octahedron({.5, .5, .5}, .37);
    PolyMesh one;
    {
        const ThreadLimit limit(1);
        one = trim(mesh, surface, TrimOptions{}).mesh;
    }
    for (const std::size_t count : {2U, 8U}) {
        const ThreadLimit limit(count);
        EXPECT_TRUE(trim(mesh, surface, TrimOptions{}).mesh == one) << count << " threads";
    }
}

TEST(Trim, defaultOptionsKeepTheVolumeWithinTheDeviation) {
    const TriSurface ball = cylinder(64, 1);
    PolyMesh mesh = box(12, 12, 12, {3, 3, 3});
    for (Vec3& p : mesh.points)
        p -= {1.53, 1.54, 0.87};
    const PolyMesh result = trimmed(mesh, ball, TrimOptions{});
    EXPECT_NEAR(volumeOf(result) / measure(ball).volume, 1, 0.01);
}

/// A box with a tent on its roof: the ridge comes from the wall x = 0.1 and fades on the roof.
/// Its slopes meet at 38 degrees there and the roof at 26.
TriSurface boxWithTent(const Vec3& ridgeEnd) {
    const std::vector<Vec3> points{{0.1, 0.1, 0.1},
                                   {0.9, 0.1, 0.1},
                                   {0.9, 0.9, 0.1},
                                   {0.1, 0.9, 0.1},
                                   {0.1, 0.1, 0.7},
                                   {0.9, 0.1, 0.7},
                                   {0.9, 0.9, 0.7},
                                   {0.1, 0.9, 0.7},
                                   {0.1, 0.5, 0.84},
                                   ridgeEnd};
    return surfaceOf(points,
                     {{0, 3, 2, 1},
                      {0, 1, 5, 4},
                      {1, 2, 6, 5},
                      {2, 3, 7, 6},
                      {3, 0, 4, 8, 7},
                      {4, 5, 9},
                      {5, 6, 9},
                      {6, 7, 9},
                      {4, 9, 8},
                      {7, 8, 9}});
}

/// Whether two points are the ends of an edge of a boundary face.
bool isBoundaryEdge(const PolyMesh& mesh, const Vec3& a, const Vec3& b) {
    for (Label f = mesh.internalFaceCount(); f < mesh.faceCount(); ++f) {
        const auto face = mesh.faces[f];
        for (std::size_t k = 0; k < face.size(); ++k)
            if (mesh.points[index(face[k])] == a &&
                mesh.points[index(face[(k + 1) % face.size()])] == b)
                return true;
    }
    return false;
}

TEST(Trim, featureEdgesThatEndInsideACellAreEdgesOfTheMesh) {
    for (const double x : {0.45, 0.52, 0.57, 0.63}) {
        const TriSurface surface = boxWithTent({x, 0.5, 0.7});
        TrimOptions options = exact();
        options.deviation = 10;
        // The grid planes x = 1/3 and 2/3 are beside the end of the ridge.
        const PolyMesh mesh = trimmed(box(3, 3, 2), surface, options);
        const double z = 0.84 - 0.14 * (1.0 / 3 - 0.1) / (x - 0.1);
        bool isFound = false;
        for (const Vec3& p : mesh.points)
            if (norm(p - Vec3{1.0 / 3, 0.5, z}) < 1e-12)
                isFound = isFound || isBoundaryEdge(mesh, p, {x, 0.5, 0.7});
        EXPECT_TRUE(isFound) << x;
    }
}

TEST(Trim, cornersOfTheSurfaceAreKeptHoweverLargeTheDeviation) {
    // The front edge of the roof has a dent of 0.02 cells.
    const TriSurface surface = surfaceOf({{0.1, 0.1, 0.1},
                                          {0.9, 0.1, 0.1},
                                          {0.9, 0.9, 0.1},
                                          {0.1, 0.9, 0.1},
                                          {0.1, 0.1, 0.7},
                                          {0.9, 0.1, 0.7},
                                          {0.9, 0.9, 0.7},
                                          {0.1, 0.9, 0.7},
                                          {0.40, 0.10, 0.7},
                                          {0.41, 0.11, 0.7},
                                          {0.42, 0.10, 0.7}},
                                         {{0, 3, 2, 1},
                                          {0, 1, 5, 10},
                                          {0, 10, 9},
                                          {0, 9, 8},
                                          {0, 8, 4},
                                          {1, 2, 6, 5},
                                          {2, 3, 7, 6},
                                          {3, 0, 4, 7},
                                          {9, 10, 5, 6, 7, 4, 8}});
    TrimOptions options = exact();
    options.deviation = 10;
    const PolyMesh mesh = trimmed(box(2, 2, 2), surface, options);
    for (const Vec3& p : surface.points)
        EXPECT_NE(std::ranges::find(mesh.points, p), mesh.points.end())
            << p.x << ' ' << p.y << ' ' << p.z;
}

TEST(Trim, aVoidInACellIsSimplifiedToo) {
    const TriSurface ball = sphere(3, 0.1, {0.5, 0.5, 0.5});
    TrimOptions options = exact(Keep::outside);
    options.deviation = 0.1;
    const PolyMesh mesh = trimmed(box(3, 3, 3), ball, options);
    const auto walls = std::ranges::find(mesh.patches, "walls", &Patch::name);
    ASSERT_NE(walls, mesh.patches.end());
    EXPECT_GE(walls->size, 4);
    EXPECT_LT(walls->size, ball.triangleCount() / 4);
}

TEST(Trim, aBiteOutOfAnEdgeOfTheMeshIsOneFaceHoweverShallow) {
    TrimOptions options = exact(Keep::outside);
    options.deviation = 0.3;
    for (const double offset : {0.15, 0.19, 0.2, 0.208}) {
        const TriSurface ball = sphere(4, 0.3, {0.5 + offset, 0.5 + offset, 0.5});
        const PolyMesh mesh = trim(box(2, 2, 1), ball, options).mesh;
        ASSERT_EQ(mesh.cellCount, 4);
        EXPECT_EQ(cellFaces(mesh).rowSize(0), 7)
            << offset; // the cell's own six and one of the ball
    }
}

TEST(Trim, aPrismWhoseEdgesTouchTheBoundaryAndNearlyAGridPlaneIsExact) {
    // Of its edges two lie on a grid plane, two beside it by rounding.
    TriSurface prism = cylinder(4, 0.25);
    for (Vec3& p : prism.points)
        p = {0.5 + 0.5 * p.x, 0.5 + 0.5 * p.y, 0.1 + p.z * 0.8};
    expectExact(box(2, 2, 2), prism);
}

TEST(Trim, facesWithTooFewPointsAreNotLeftByDistortedCells) {
    // Both have given faces with two points.
    for (const auto& [n, seed] : {std::array<unsigned, 2>{4, 1121}, {3, 584}}) {
        const Vec3 centre{0.5, 0.5, 0.5};
        const TriSurface shell = join(sphere(2, 0.45, centre), inverted(sphere(1, 0.25, centre)));
        const auto count = static_cast<Label>(n);
        const PolyMesh mesh = jittered(box(count, count, count), 0.15 / n, seed);
        trimmed(mesh, shell, exact());
        trimmed(mesh, shell, exact(Keep::outside));
    }
}

TEST(Trim, aSurfaceOutsideTheMeshLeavesNothing) {
    EXPECT_THROW(trim(box(2, 2, 2), octahedron({5, 5, 5}, 1), exact()), InputError);
}

TEST(Trim, shellsThatLeaveACellOpenAreRefusedWithThePlace) {
    // Found at random: the curves of both close on each face, the cell does not.
    const TriSurface two = join(cuboid({0.5, 0.25, 0.9375}, {0.625, 0.625, 1.5}),
                                cuboid({0.5625, 0.3125, 0.75}, {0.625, 0.875, 1.125}));
    for (const Keep keep : {Keep::inside, Keep::outside})
        try {
            trim(box(2, 2, 2), two, exact(keep));
            FAIL() << "not refused";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("intersects itself near ("), std::string::npos)
                << error.what();
        }
}

TEST(Trim, overlappingShellsAreRefusedWithThePlace) {
    TriSurface two = cuboid({.2, .2, .2}, {.6, .6, .6});
    const TriSurface other = cuboid({.4, .4, .4}, {.8, .8, .8});
    const Label shift = two.pointCount();
    two.points.insert(two.points.end(), other.points.begin(), other.points.end());
    for (auto triangle : other.triangles) {
        for (Label& p : triangle)
            p += shift;
        two.triangles.push_back(triangle);
        two.region.push_back(0);
    }
    try {
        trim(box(9, 9, 9), two, exact());
        FAIL() << "not refused";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("intersects itself near ("), std::string::npos)
            << error.what();
    }
}

} // namespace
} // namespace polymesh::test
