// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/makeDivisible.h"

#include "libpolymesh/base/threadLimit.h"
#include "libpolymesh/mps/bends.h"
#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/splitFaces.h"
#include "libpolymesh/mps/untangle.h"
#include "tests/libpolymesh/mps/divided.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

namespace polymesh {

namespace {

/// Makes a mesh divisible, divides it and holds the laws: no part is inverted, volume and patch
/// areas stay, the parts are what theory demands.
Divisible dividedWell(const PolyMesh& mesh) {
    Divisible work = makeDivisible(mesh);
    EXPECT_TRUE(validate(work.mesh).empty());
    EXPECT_TRUE(work.plan.inverted.empty());
    const double volume = test::volumeOf(mesh);
    EXPECT_NEAR(test::volumeOf(work.mesh), volume, 1e-12 * volume);
    const SubdivisionCounts demanded = demandedCounts(work.mesh);
    SubdivisionPlan plan = work.plan;
    const PolyMesh result = divide(work.mesh, std::move(plan));
    EXPECT_TRUE(validate(result).empty());
    const ShapeCounts shapes = countShapes(result, cellFaces(result));
    EXPECT_EQ(shapes[StandardShape::hexahedron], demanded.hexahedra);
    EXPECT_EQ(shapes[StandardShape::pyramid], demanded.pyramids);
    EXPECT_EQ(result.cellCount, demanded.hexahedra + demanded.pyramids);
    EXPECT_NEAR(test::volumeOf(result), volume, 1e-12 * volume);
    EXPECT_GT(test::leastJacobianOfFaces(result), leastJacobian);
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        const auto [area, magnitude] = test::patchArea(mesh, mesh.patches[p]);
        EXPECT_LE(norm(test::patchArea(result, result.patches[p]).first - area), 1e-12 * magnitude);
    }
    return work;
}

} // namespace

TEST(MakeDivisible, leavesCellsThatDivideWell) {
    const PolyMesh mesh = test::box(3, 3, 3);
    const Divisible work = dividedWell(mesh);
    EXPECT_EQ(work.mesh, mesh);
    EXPECT_EQ(work.counts.movedPoints, 0);
}

TEST(MakeDivisible, coarseCellBesideFineOnesDividesConformally) {
    EXPECT_FALSE(planSubdivision(test::hangingNodes()).inverted.empty());
    dividedWell(test::hangingNodes());
}

TEST(MakeDivisible, concaveCellsDivideWell) {
    const Divisible work = dividedWell(test::lShapedCell());
    EXPECT_EQ(work.counts.firstInverted, 1);
    EXPECT_GT(work.mesh.cellCount, 1);
}

TEST(MakeDivisible, cellWithOneReflexEdgeIsCutInTwoHexahedra) {
    const Divisible work = dividedWell(test::lShapedCell());
    EXPECT_EQ(work.mesh.cellCount, 2);
    EXPECT_EQ(work.plan.hexahedra, 16);
    EXPECT_EQ(work.plan.pyramids, 0);
}

/// Two cubes of which an edge goes by way of a point beside its middle.
PolyMesh bentCubes(const Vec3& aside) {
    PolyMesh mesh = test::twoHexes();
    const auto edge = edges(mesh).front();
    const Vec3 middle = 0.5 * (mesh.points[index(edge[0])] + mesh.points[index(edge[1])]);
    return withBendsAsPoints(std::move(mesh), {{edge, middle + aside}});
}

TEST(Bends, pointsBetweenTwoEdgesBecomeMiddles) {
    const Vec3 aside{0.01, 0.02, 0.03};
    PolyMesh mesh = bentCubes(aside);
    const PolyMesh before = mesh;
    const Bends bends = takeBends(mesh);
    ASSERT_EQ(bends.size(), 1U);
    EXPECT_EQ(mesh, test::twoHexes());
    EXPECT_EQ(withBendsAsPoints(mesh, bends), before);
    EXPECT_NE(findBend(bends, bends[0].ends[1], bends[0].ends[0]), nullptr);
}

TEST(Bends, warpedFacesKeepTheirVolume) {
    const PolyMesh mesh = bentCubes({0.05, -0.08, 0.06});
    Divisible work = makeDivisible(mesh);
    EXPECT_TRUE(work.plan.inverted.empty());
    EXPECT_EQ(work.plan.hexahedra, 16);
    EXPECT_EQ(work.plan.pyramids, 0);
    const double volume = test::volumeOf(mesh);
    const PolyMesh result = divide(work.mesh, std::move(work.plan));
    EXPECT_NEAR(test::volumeOf(result), volume, 1e-14);
    EXPECT_GT(test::leastJacobianOfFaces(result), leastJacobian);
}

TEST(MakeDivisible, sameMeshWithAnyNumberOfThreads) {
    std::vector<PolyMesh> results;
    for (const std::size_t threads : {1U, 2U, 8U}) {
        const ThreadLimit limit(threads);
        Divisible work = makeDivisible(test::hangingNodes());
        results.push_back(divide(work.mesh, std::move(work.plan)));
    }
    EXPECT_EQ(results[0], results[1]);
    EXPECT_EQ(results[0], results[2]);
}

TEST(SplitFaces, piecesStayInTheirPatchAndZone) {
    PolyMesh mesh = test::unitCube();
    mesh.faceZones.push_back({"zone", {0, 5}, {true, false}});
    const auto loop = mesh.faces[5];
    const FacePieces pieces{5, {{loop[0], loop[1], loop[2]}, {loop[0], loop[2], loop[3]}}};
    const PolyMesh split = withPieces(mesh, std::vector{pieces});
    EXPECT_TRUE(validate(split).empty());
    EXPECT_EQ(split.faceCount(), 7);
    EXPECT_EQ(split.patches[5].size, 2);
    EXPECT_EQ(split.faceZones[0].labels, (std::vector<Label>{0, 5, 6}));
    EXPECT_EQ(split.faceZones[0].flip, (std::vector<bool>{true, false, false}));
}

TEST(Cones, cellBecomesConesAndZonesGoOn) {
    PolyMesh mesh = test::twoHexes();
    mesh.cellZones.push_back({"first", {0}, {}});
    mesh.faceZones.push_back({"middle", {0}, {false}});
    const CellCones cones{0, {{0.5, 0.5, 0.5}}, {0, 1, 2, 3, 4, 5}, 6};
    const PolyMesh coned = withCones(mesh, cellFaces(mesh), std::vector{cones});
    EXPECT_TRUE(validate(coned).empty());
    EXPECT_EQ(coned.cellCount, 7);
    EXPECT_EQ(coned.cellZones[0].labels, (std::vector<Label>{0, 2, 3, 4, 5, 6}));
    ASSERT_EQ(coned.faceZones[0].labels.size(), 1U);
    EXPECT_DOUBLE_EQ(faceGeometry(coned.points, coned.faces[coned.faceZones[0].labels[0]]).centre.x,
                     1);
    EXPECT_NEAR(test::volumeOf(coned), 2, 1e-14);
}

} // namespace polymesh
