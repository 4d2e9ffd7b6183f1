// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/validate.h"

#include "libpolymesh/base/error.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <limits>

namespace polymesh {
namespace {

std::vector<int> laws(const PolyMesh& mesh) {
    std::vector<int> result;
    for (const Defect& defect : validate(mesh))
        result.push_back(defect.law);
    return result;
}

TEST(Validate, acceptsEveryMeshOfTheSupport) {
    for (const PolyMesh& mesh : {PolyMesh{},
                                 test::unitCube(),
                                 test::box(3, 4, 5),
                                 test::jittered(test::box(8, 8, 8), 0.03),
                                 test::prismFan(7),
                                 test::lShapedCell(),
                                 test::tetrahedron(),
                                 test::pyramid(),
                                 test::wedge(),
                                 test::hangingNodes()})
        EXPECT_EQ(laws(mesh), std::vector<int>{});
}

TEST(Validate, findsLabelsOutOfRangeAndStopsThere) {
    PolyMesh mesh = test::twoHexes();
    mesh.faces.values[5] = 1000;
    EXPECT_EQ(laws(mesh), std::vector<int>{0});
    mesh = test::twoHexes();
    mesh.owner[2] = -1;
    mesh.neighbour[0] = 2;
    EXPECT_EQ(laws(mesh), (std::vector<int>{0, 0}));
    mesh = test::twoHexes();
    mesh.owner.pop_back();
    EXPECT_EQ(laws(mesh), std::vector<int>{0});
    mesh = test::twoHexes();
    mesh.points[3].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(laws(mesh), std::vector<int>{0});
    mesh = test::twoHexes();
    mesh.cellZones.push_back({"zone", {0, 2}, {}});
    EXPECT_EQ(laws(mesh), std::vector<int>{0});
}

TEST(Validate, findsAFaceWithARepeatedPoint) {
    PolyMesh mesh = test::unitCube();
    mesh.faces[0][1] = mesh.faces[0][0];
    const std::vector<int> found = laws(mesh);
    EXPECT_EQ(found.front(), 1);
    EXPECT_EQ(found.back(), 4);
}

TEST(Validate, findsAFaceWithoutEnoughPoints) {
    for (const Label size : {0, 1, 2}) {
        PolyMesh mesh = test::unitCube();
        const std::vector<Label> stump(mesh.faces[0].begin(), mesh.faces[0].begin() + size);
        Rows<Label> faces;
        faces.add(stump);
        for (Label face = 1; face < mesh.faceCount(); ++face)
            faces.add(std::as_const(mesh.faces)[face]);
        mesh.faces = faces;
        EXPECT_EQ(laws(mesh), (std::vector<int>{1, 4})) << size;
    }
}

TEST(Validate, findsACellInsideOut) {
    const std::vector<Defect> defects = validate(test::invertedCell());
    ASSERT_EQ(defects.size(), 1U);
    EXPECT_EQ(defects[0].law, 1);
    EXPECT_EQ(defects[0].message, "cell 0 has its faces inside out");
}

TEST(Validate, findsOneFaceTurnedRound) {
    PolyMesh mesh = test::unitCube();
    std::reverse(mesh.faces[2].begin(), mesh.faces[2].end());
    EXPECT_EQ(laws(mesh), std::vector<int>{4});
}

TEST(Validate, findsAnOpenCell) {
    EXPECT_EQ(laws(test::openCell()), std::vector<int>{4});
}

TEST(Validate, findsFacesOutOfOrder) {
    PolyMesh mesh = test::box(3, 1, 1); // internal faces 0|1, 1|2
    std::swap_ranges(mesh.faces[0].begin(), mesh.faces[0].end(), mesh.faces[1].begin());
    std::swap(mesh.owner[0], mesh.owner[1]);
    std::swap(mesh.neighbour[0], mesh.neighbour[1]);
    EXPECT_EQ(laws(mesh), std::vector<int>{2});
    mesh = test::twoHexes();
    std::swap(mesh.owner[0], mesh.neighbour[0]);
    EXPECT_EQ(laws(mesh)[0], 2);
}

TEST(Validate, findsGapsBetweenPatches) {
    PolyMesh mesh = test::unitCube();
    ++mesh.patches[1].start;
    EXPECT_EQ(laws(mesh), (std::vector<int>{3, 3}));
    mesh = test::unitCube();
    mesh.patches.pop_back();
    EXPECT_EQ(laws(mesh), std::vector<int>{3});
}

TEST(Validate, findsUnusedPointsAndCellsWithFewFaces) {
    PolyMesh mesh = test::unitCube();
    mesh.points.push_back({});
    EXPECT_EQ(laws(mesh), std::vector<int>{5});
    mesh = test::unitCube();
    ++mesh.cellCount;
    EXPECT_EQ(laws(mesh), std::vector<int>{5});
}

TEST(RequireValid, namesTheFirstDefects) {
    EXPECT_NO_THROW(requireValid(test::unitCube(), "the mesh"));
    try {
        requireValid(test::openCell(), "the trimmed mesh");
        FAIL();
    } catch (const WorkError& error) {
        EXPECT_NE(
            std::string(error.what()).find("the trimmed mesh is not valid, 1 defects; cell 0"),
            std::string::npos);
    }
}

} // namespace
} // namespace polymesh
