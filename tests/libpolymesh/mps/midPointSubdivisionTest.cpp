// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/midPointSubdivision.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/threadLimit.h"
#include "tests/libpolymesh/mps/divided.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace polymesh {

namespace {

using test::Divided;
using test::dividedByLaw;

/// The octahedron |x| + |y| + |z| <= 1.
PolyMesh octahedron() {
    test::Polyhedron faces;
    for (int octant = 0; octant < 8; ++octant) {
        const Label x = octant & 1 ? 1 : 0;
        const Label y = octant & 2 ? 3 : 2;
        const Label z = octant & 4 ? 5 : 4;
        const bool isEven = (octant & 1) == ((octant >> 1 ^ octant >> 2) & 1);
        faces.push_back(isEven ? test::Polygon{x, z, y} : test::Polygon{x, y, z});
    }
    return test::meshOf({{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}},
                        {faces});
}

/// Expects the shapes of a mesh, none inverted.
void expectShapes(const PolyMesh& mesh, Label hexahedra, Label pyramids) {
    const Divided divided = dividedByLaw(mesh);
    EXPECT_EQ(divided.hexahedra, hexahedra);
    EXPECT_EQ(divided.pyramids, pyramids);
    EXPECT_TRUE(divided.inverted.empty());
}

} // namespace

TEST(MidPointSubdivision, cubeBecomesEightHexahedra) {
    expectShapes(test::unitCube(), 8, 0);
}

TEST(MidPointSubdivision, tetrahedronBecomesFourHexahedra) {
    expectShapes(test::tetrahedron(), 4, 0);
}

TEST(MidPointSubdivision, pyramidBecomesFourHexahedraAndEightPyramids) {
    expectShapes(test::pyramid(), 4, 8);
}

TEST(MidPointSubdivision, octahedronBecomesPyramidsAtItsSixNodes) {
    expectShapes(octahedron(), 0, 48);
}

TEST(MidPointSubdivision, boxBecomesTheBoxOfHalfTheCellSize) {
    const Divided divided = dividedByLaw(test::box(3, 4, 5));
    EXPECT_EQ(divided.hexahedra, 8 * 60);
    EXPECT_EQ(divided.mesh.pointCount(), 7 * 9 * 11);
    EXPECT_NEAR(test::leastJacobianOfFaces(divided.mesh), 1, 1e-12);
}

TEST(MidPointSubdivision, prismsRoundAnAxisBecomeHexahedra) {
    expectShapes(test::prismFan(7), 7 * 6, 0);
}

TEST(MidPointSubdivision, concaveCellIsReported) {
    const Divided divided = dividedByLaw(test::lShapedCell());
    EXPECT_EQ(divided.inverted, std::vector<Label>{0});
}

TEST(MidPointSubdivision, jitteredBoxKeepsItsLaws) {
    expectShapes(test::jittered(test::box(4, 4, 4), 0.02), 8 * 64, 0);
}

TEST(MidPointSubdivision, cellThatIsNotClosedIsRefused) {
    EXPECT_THROW(planSubdivision(test::openCell()), InputError);
}

TEST(MidPointSubdivision, sameMeshWithAnyNumberOfThreads) {
    const PolyMesh mesh = test::jittered(test::box(15, 15, 15), 0.005);
    std::vector<PolyMesh> results;
    for (const std::size_t threads : {1U, 2U, 8U}) {
        const ThreadLimit limit(threads);
        results.push_back(divide(mesh, planSubdivision(mesh)));
    }
    EXPECT_EQ(results[0], results[1]);
    EXPECT_EQ(results[0], results[2]);
}

TEST(MidPointSubdivision, zonesGoOnWithTheParts) {
    PolyMesh mesh = test::twoHexes();
    mesh.cellZones.push_back({"right", {1}, {}});
    mesh.faceZones.push_back({"middle", {0}, {true}});
    std::vector<Label> left;
    for (Label p = 0; p < mesh.pointCount(); ++p)
        if (mesh.points[index(p)].x < 0.5) left.push_back(p);
    mesh.pointZones.push_back({"left", left, {}});
    const PolyMesh result = dividedByLaw(mesh).mesh;
    ASSERT_EQ(result.cellZones[0].labels.size(), 8U);
    const std::vector<Vec3> centres = computeGeometry(result).cellCentres;
    for (const Label cell : result.cellZones[0].labels)
        EXPECT_GT(centres[index(cell)].x, 1);
    ASSERT_EQ(result.faceZones[0].labels.size(), 4U);
    for (const Label face : result.faceZones[0].labels)
        EXPECT_DOUBLE_EQ(faceGeometry(result.points, result.faces[face]).centre.x, 1);
    EXPECT_EQ(result.faceZones[0].flip, std::vector<bool>(4, true));
    ASSERT_EQ(result.pointZones[0].labels.size(), 9U);
    for (const Label point : result.pointZones[0].labels)
        EXPECT_EQ(result.points[index(point)].x, 0);
}

} // namespace polymesh
