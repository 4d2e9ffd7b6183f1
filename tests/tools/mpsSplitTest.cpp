// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/polyMeshIo.h"
#include "formats/foam/sets.h"
#include "formats/surfaceIo.h"
#include "libpolymesh/mesh/validate.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"
#include "tests/tools/program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace polymesh::tools {

namespace {

class MeshCase : public TemporaryCase {
public:
    explicit MeshCase(const PolyMesh& mesh) { foam::writePolyMesh(mesh, meshDir(), {}); }

    std::filesystem::path meshDir() const { return dir() / "constant/polyMesh"; }

    PolyMesh mesh() const { return foam::readPolyMesh(meshDir()); }

    nlohmann::json report() const { return nlohmann::json::parse(read("report.json")); }

    ProgramResult split(const std::string& options = "") const {
        return run("mpsSplit -json report.json " + options);
    }
};

} // namespace

TEST(MpsSplit, dividesAndReports) {
    const MeshCase pyramid(test::pyramid());
    const ProgramResult result = pyramid.split();
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("4 hexahedra and 8 pyramids"), std::string::npos) << result.out;
    const nlohmann::json report = pyramid.report();
    EXPECT_EQ(report["hexahedra"], 4);
    EXPECT_EQ(report["pyramids"], 8);
    EXPECT_EQ(report["demandedHexahedra"], 4);
    EXPECT_EQ(report["demandedPyramids"], 8);
    EXPECT_EQ(report["invertedCells"], 0);
    EXPECT_EQ(report["beyondLimits"], 0);
    EXPECT_EQ(report["movedForQuality"], 0);
    EXPECT_EQ(pyramid.mesh().cellCount, 12);
}

TEST(MpsSplit, movesPointsForTheSakeOfSkewFaces) {
    PolyMesh leaning = test::tetrahedron();
    leaning.points[3] = {6, 6, .25};
    const MeshCase tetrahedron(leaning);
    const ProgramResult result = tetrahedron.split("&& checkMesh -allTopology");
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    const nlohmann::json report = tetrahedron.report();
    EXPECT_EQ(report["beyondLimits"], 3);
    EXPECT_EQ(report["beyondLimitsLeft"], 0);
    EXPECT_GT(report["movedForQuality"], 0);
    EXPECT_NE(result.out.find("for the sake of 3 cells and faces"), std::string::npos);
    EXPECT_NEAR(report["volumeError"], 0, 1e-12);
}

TEST(MpsSplit, dividesATrimmedMesh) {
    const TemporaryCase box;
    std::filesystem::create_directories(box.dir() / "constant/triSurface");
    writeSurface(test::cuboid({.21, .22, .23}, {.71, .72, .73}, "body"),
                 box.dir() / "constant/triSurface/part.obj");
    const ProgramResult result =
        box.run("blockInit -box '0 0 0 1 1 1' -cells '6 6 6' -quiet && trimSurface -surface "
                "part.obj -quiet && mpsSplit -json report.json && checkMesh -allTopology");
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    const auto report = nlohmann::json::parse(box.read("report.json"));
    EXPECT_NEAR(report["volume"], 0.125, 1e-12);
}

TEST(MpsSplit, leavesHexahedraAloneWhenAsked) {
    const TemporaryCase box;
    std::filesystem::create_directories(box.dir() / "constant/triSurface");
    writeSurface(test::sphere(4, .41, {.5, .5, .5}), box.dir() / "constant/triSurface/part.obj");
    const ProgramResult result =
        box.run("blockInit -box '0 0 0 1 1 1' -cells '12 12 12' -quiet && trimSurface -surface "
                "part.obj -quiet && mpsSplit -only polyhedra -json report.json && checkMesh "
                "-allTopology");
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    const auto report = nlohmann::json::parse(box.read("report.json"));
    EXPECT_GT(report["wholeHexahedra"], 50);
    EXPECT_GT(report["layerPyramids"], report["layerHexahedra"]);
    EXPECT_EQ(report["hexahedra"],
              report["demandedHexahedra"].get<int>() + report["wholeHexahedra"].get<int>());
    EXPECT_NEAR(report["volumeError"], 0, 1e-12);
}

TEST(MpsSplit, refusesToLeaveHexahedraAloneBesideCyclicPatches) {
    PolyMesh mesh = test::box(2, 2, 2);
    mesh.patches[0].type = "cyclic";
    const MeshCase cyclic(mesh);
    const ProgramResult result = cyclic.split("-only polyhedra");
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("is cyclic"), std::string::npos) << result.err;
    EXPECT_EQ(cyclic.mesh().cellCount, 8);
    EXPECT_EQ(cyclic.split("-only tetrahedra").status, 2);
}

TEST(MpsSplit, curvedPartsKeepTheirVolumeAndHaveNoInvertedPart) {
    const TemporaryCase box;
    std::filesystem::create_directories(box.dir() / "constant/triSurface");
    writeSurface(test::sphere(4, .41, {.5, .5, .5}), box.dir() / "constant/triSurface/part.obj");
    const ProgramResult result =
        box.run("blockInit -box '0 0 0 1 1 1' -cells '9 9 9' -quiet && trimSurface -surface "
                "part.obj -quiet && mpsSplit -json report.json");
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    const auto report = nlohmann::json::parse(box.read("report.json"));
    EXPECT_LE(std::abs(report["volumeError"].get<double>()), 1e-12);
    EXPECT_EQ(report["invertedCells"], 0);
}

TEST(MpsSplit, refusesAMeshThatIsNotClosedAndKeepsIt) {
    const MeshCase open(test::openCell());
    const PolyMesh before = open.mesh();
    const ProgramResult result = open.split();
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("not closed"), std::string::npos) << result.err;
    EXPECT_EQ(open.mesh(), before);
    EXPECT_EQ(foam::readSet(open.meshDir(), foam::SetKind::cell, "openCells"),
              std::vector<Label>{0});
}

TEST(MpsSplit, refusesInvertedCellsAndKeepsThem) {
    const MeshCase inverted(test::invertedCell());
    const PolyMesh before = inverted.mesh();
    const ProgramResult result = inverted.split();
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("inverted"), std::string::npos) << result.err;
    EXPECT_EQ(inverted.mesh(), before);
    EXPECT_EQ(foam::readSet(inverted.meshDir(), foam::SetKind::cell, "invertedCells"),
              std::vector<Label>{0});
}

TEST(MpsSplit, setsGoOnWithTheParts) {
    const MeshCase pair(test::twoHexes());
    foam::writeSet(pair.meshDir(), foam::SetKind::cell, "right", std::vector<Label>{1});
    foam::writeSet(pair.meshDir(), foam::SetKind::face, "middle", std::vector<Label>{0});
    ASSERT_EQ(pair.split().status, 0);
    const std::vector<Label> right = foam::readSet(pair.meshDir(), foam::SetKind::cell, "right");
    EXPECT_EQ(right, (std::vector<Label>{8, 9, 10, 11, 12, 13, 14, 15}));
    EXPECT_EQ(foam::readSet(pair.meshDir(), foam::SetKind::face, "middle").size(), 4U);
    EXPECT_TRUE(pair.mesh().cellZones.empty());
}

TEST(MpsSplit, putsBoundaryPointsOntoTheSurface) {
    const MeshCase cube(test::unitCube());
    writeSurface(test::cuboid({-.1, -.1, -.1}, {1.1, 1.1, 1.1}, "body"), cube.dir() / "part.obj");
    ASSERT_EQ(cube.split("-surface part.obj").status, 0);
    EXPECT_EQ(cube.report()["projected"], 18);
    EXPECT_EQ(cube.split("-surface missing.obj").status, 2);
}

TEST(MpsSplit, takesASurfaceWhoseTrianglesDisagreeAsTrimSurfaceDoes) {
    const MeshCase cube(test::unitCube());
    TriSurface body = test::cuboid({-.1, -.1, -.1}, {1.1, 1.1, 1.1}, "body");
    std::swap(body.triangles[3][1], body.triangles[3][2]);
    writeSurface(body, cube.dir() / "part.obj");
    const ProgramResult result = cube.split("-surface part.obj");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(cube.report()["projected"], 18);
}

} // namespace polymesh::tools
