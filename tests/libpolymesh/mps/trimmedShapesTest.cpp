// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes that STAR-CD accepts, the trimmed ones and all in which edges have collapsed: none has
// an inverted part, and the volume is what CGAL finds, of the shape and of its parts, and TetGen.

#include "libpolymesh/mps/makeDivisible.h"
#include "libpolymesh/reference/tetgen.h"
#include "libpolymesh/shapes/recognise.h"
#include "tests/libpolymesh/mps/divided.h"
#include "tests/libpolymesh/shapes/cutCube.h"

#include <gtest/gtest.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

namespace polymesh {

namespace {

using test::Polyhedron;

/// Places of the vertices of base shapes.
using Places = std::map<BaseShape, std::vector<Vec3>>;

/// Cubes cut by planes until each trimmed shape has come up; sammTrim3 has the graph of sammTrim1.
void addTrimmed(Places& places) {
    constexpr int tries = 300;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int i = 0; i < tries; ++i) {
        const Vec3 normal{any(random), any(random), any(random)};
        const test::CutCube cut =
            test::cutCube(normal, dot(normal, {0.5, 0.5, 0.5}) + 0.5 * any(random));
        if (cut.faces.empty() || cut.cutFace.empty()) continue;
        const auto found = recognise(test::rowsOf(cut.faces));
        if (!found || !Catalogue::instance()[found->shape].collapsed.empty()) continue;
        std::vector<Vec3> own;
        for (const Label p : found->vertices())
            own.push_back(cut.points[index(p)]);
        places.try_emplace(found->base, own);
    }
}

Places placesOfBases() {
    Places places;
    places[BaseShape::tetrahedron] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    places[BaseShape::pyramid] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
    std::vector<Vec3>& hexagonal = places[BaseShape::hexagonalPrism];
    for (const double z : {0.0, 1.0})
        for (int i = 0; i < 6; ++i) {
            const double angle = std::numbers::pi / 3 * i;
            hexagonal.push_back({std::cos(angle), std::sin(angle), z});
        }
    addTrimmed(places);
    return places;
}

/// The shape with its points at those of the base, those of edges that have collapsed in the middle
/// of them; right-handed.
PolyMesh meshOf(const CatalogueShape& shape, const std::vector<Vec3>& places) {
    std::vector<Label> pointOf(places.size());
    std::iota(pointOf.begin(), pointOf.end(), 0);
    for (const ShapeEdge& edge : shape.collapsed)
        std::ranges::replace(pointOf, pointOf[edge[1]], Label{pointOf[edge[0]]});
    Polyhedron faces = test::shapeCell(shape);
    std::map<Label, Label> number;
    std::vector<Vec3> points;
    for (const Label p : test::pointsOf(faces)) {
        number[p] = toLabel(points.size());
        Vec3 sum;
        for (std::size_t v = 0; v < places.size(); ++v)
            if (pointOf[v] == p) sum += places[v];
        points.push_back(sum / static_cast<double>(std::ranges::count(pointOf, p)));
    }
    for (test::Polygon& loop : faces)
        for (Label& p : loop)
            p = number[p];
    PolyMesh mesh = test::meshOf(points, {faces});
    return test::volumeOf(mesh) < 0 ? test::meshOf(points, {test::mirrorImage(faces)}) : mesh;
}

bool hasFlatFaces(const PolyMesh& mesh) {
    for (Label face = 0; face < mesh.faceCount(); ++face) {
        const FaceGeometry g = faceGeometry(mesh.points, mesh.faces[face]);
        for (const Label p : mesh.faces[face])
            if (std::abs(dot(g.area, mesh.points[index(p)] - g.centre)) > 1e-12) return false;
    }
    return true;
}

/// The volume of a cell by CGAL with exact arithmetic, of the triangles from OpenFOAM's face
/// centres.
double cgalVolume(const PolyMesh& mesh, std::span<const Label> faces, Label cell) {
    using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
    using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
    Surface surface;
    std::map<Label, Surface::Vertex_index> vertexOf;
    const auto add = [&](const Vec3& p) { return surface.add_vertex({p.x, p.y, p.z}); };
    for (const Label face : faces)
        for (const Label p : mesh.faces[face])
            if (!vertexOf.contains(p)) vertexOf[p] = add(mesh.points[index(p)]);
    for (const Label face : faces) {
        const auto loop = mesh.faces[face];
        const auto middle = add(faceGeometry(mesh.points, loop).centre);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            auto a = vertexOf.at(loop[i]);
            auto b = vertexOf.at(loop[(i + 1) % loop.size()]);
            if (mesh.owner[index(face)] != cell) std::swap(a, b);
            EXPECT_NE(surface.add_face(a, b, middle), Surface::null_face());
        }
    }
    EXPECT_TRUE(CGAL::is_closed(surface));
    return CGAL::to_double(CGAL::Polygon_mesh_processing::volume(surface));
}

/// The sum over the cells of a mesh, each of which has one.
double cgalVolume(const PolyMesh& mesh) {
    const Rows<Label> faces = cellFaces(mesh);
    double sum = 0;
    for (Label cell = 0; cell < mesh.cellCount; ++cell) {
        const double volume = cgalVolume(mesh, faces[cell], cell);
        EXPECT_GT(volume, 0);
        sum += volume;
    }
    return sum;
}

} // namespace

TEST(TrimmedShape, dividesAndSoDoItsCollapsedVariants) {
    constexpr double noVolume = 1e-6; // shapes with all points in a plane are left out
    const Places places = placesOfBases();
    for (const auto base : {BaseShape::sammTrim1,
                            BaseShape::sammTrim2,
                            BaseShape::sammTrim4,
                            BaseShape::sammTrim5,
                            BaseShape::hexagonalPrism})
        ASSERT_TRUE(places.contains(base)) << tableOf(base).name;
    int divided = 0;
    int compared = 0;
    for (const CatalogueShape& shape : Catalogue::instance().shapes()) {
        const auto own = places.find(shape.base);
        if (own == places.end()) continue;
        const PolyMesh mesh = meshOf(shape, own->second);
        const double volume = test::volumeOf(mesh);
        if (volume < noVolume) continue;
        Divisible work = makeDivisible(mesh, {{}, tetgenTetrahedraliser()});
        EXPECT_TRUE(work.plan.inverted.empty()) << shape.name;
        const PolyMesh result = divide(work.mesh, std::move(work.plan));
        EXPECT_TRUE(validate(result).empty()) << shape.name;
        EXPECT_NEAR(test::volumeOf(result), volume, 1e-12 * volume) << shape.name;
        EXPECT_NEAR(cgalVolume(mesh), volume, 1e-12 * volume) << shape.name;
        EXPECT_NEAR(cgalVolume(result), volume, 1e-12 * volume) << shape.name;
        ++divided;
        if (!hasTetgen() || !hasFlatFaces(mesh)) continue;
        const auto oracle = tetgenVolumes(mesh, cellFaces(mesh), std::vector<Label>{0});
        ASSERT_TRUE(oracle[0]) << shape.name;
        EXPECT_NEAR(*oracle[0], volume, 1e-12 * volume) << shape.name;
        ++compared;
    }
    EXPECT_GT(divided, 100);
    EXPECT_GT(compared, 10);
}

} // namespace polymesh
