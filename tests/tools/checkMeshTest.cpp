// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs our checkMesh and OpenFOAM's on the same meshes: every line and every set must be the same.

#include "formats/foam/polyMeshIo.h"
#include "formats/foam/sets.h"
#include "tests/support/meshes.h"
#include "tests/support/temporaryDirectory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace polymesh {
namespace {

namespace fs = std::filesystem;

constexpr const char* header =
    "FoamFile { version 2.0; format ascii; class dictionary; object d; }\n";

constexpr const char* controlDict = R"(
application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;
writeControl timeStep; writeInterval 1; writeFormat ascii; writePrecision 6;
)";

constexpr const char* curvedBlock = R"(
vertices ((0 0 0)(2 0 0)(2 1 0)(0 1 0)(0 0 1)(2 0 1.3)(2 1.2 1)(0 1 1));
blocks (hex (0 1 2 3 4 5 6 7) zone (9 7 8) simpleGrading (5 0.3 ((0.5 0.4 3)(0.5 0.6 0.2))));
edges (arc 0 1 (1 -0.4 0.1) spline 4 5 ((0.5 0.2 1.3)(1.5 -0.2 1.2)));
boundary (a { type wall; faces ((0 1 5 4)); } b { type patch; faces ((0 4 7 3)(2 6 5 1)); }
    c { type wall; faces ((3 7 6 2)(0 3 2 1)(4 5 6 7)); });
)";

constexpr const char* flatBlock = R"(
vertices ((0 0 0)(2 0 0)(2 1 0)(0 1 0)(0 0 0.1)(2 0 0.1)(2 1 0.1)(0 1 0.1));
blocks (hex (0 1 2 3 4 5 6 7) (12 6 1) simpleGrading (5 0.3 1));
boundary (a { type wall; faces ((0 1 5 4)(3 7 6 2)); } b { type patch; faces ((0 4 7 3)(2 6 5 1)); }
    c { type empty; faces ((0 3 2 1)(4 5 6 7)); });
)";

constexpr const char* wedgeBlock = R"(
vertices ((0 0 0)(2 0 0)(2 1 -0.0436609)(0 1 -0.0436609)(2 1 0.0436609)(0 1 0.0436609));
blocks (hex (0 1 2 3 0 1 4 5) (12 6 1) simpleGrading (5 0.3 1));
boundary (w1 { type wedge; faces ((0 1 2 3)); } w2 { type wedge; faces ((0 1 4 5)); }
    c { type wall; faces ((3 2 4 5)(0 3 5 0)(1 2 4 1)); } axis { type empty; faces ((0 1 1 0)); });
)";

constexpr const char* cyclicBlock = R"(
vertices ((0 0 0)(2 0 0)(2.3 1 0)(0.3 1 0)(0 0 1)(2 0 1)(2.3 1 1)(0.3 1 1));
blocks (hex (0 1 2 3 4 5 6 7) (5 4 3) simpleGrading (5 0.3 1));
boundary (l { type cyclic; neighbourPatch r; faces ((0 4 7 3)); }
    r { type cyclic; neighbourPatch l; faces ((2 6 5 1)); }
    c { type wall; faces ((3 7 6 2)(0 3 2 1)(4 5 6 7)(0 1 5 4)); });
)";

constexpr const char* cubeBlock = R"(
vertices ((-1 -1 -1)(1 -1 -1)(1 1 -1)(-1 1 -1)(-1 -1 1)(1 -1 1)(1 1 1)(-1 1 1));
blocks (hex (0 1 2 3 4 5 6 7) (8 8 8) simpleGrading (1 1 1));
boundary (walls { type wall;
    faces ((0 1 5 4)(3 7 6 2)(0 4 7 3)(2 6 5 1)(0 3 2 1)(4 5 6 7)); });
)";

constexpr const char* snappyBall = R"(
castellatedMesh true; snap true; addLayers false;
geometry { ball { type searchableSphere; centre (0.1 0 0); radius 0.45; } }
castellatedMeshControls {
    maxLocalCells 100000; maxGlobalCells 100000; minRefinementCells 0; nCellsBetweenLevels 1;
    features (); refinementSurfaces { ball { level (1 2); } } resolveFeatureAngle 30;
    refinementRegions {} locationInMesh (0.91 0.83 0.77); allowFreeStandingZoneFaces true;
}
snapControls { nSmoothPatch 3; tolerance 2; nSolveIter 10; nRelaxIter 3; }
addLayersControls {
    relativeSizes true; layers {} expansionRatio 1; finalLayerThickness 0.3; minThickness 0.1;
    nGrow 0; featureAngle 60; nRelaxIter 3; nSmoothSurfaceNormals 1; nSmoothNormals 3;
    nSmoothThickness 10; maxFaceThicknessRatio 0.5; maxThicknessToMedialRatio 0.3;
    minMedianAxisAngle 90; nBufferCellsNoExtrude 0; nLayerIter 5;
}
meshQualityControls {
    maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80; minVol 1e-13;
    minTetQuality 1e-15; minArea -1; minTwist 0.02; minDeterminant 0.001; minFaceWeight 0.05;
    minVolRatio 0.01; minTriangleTwist -1; nSmoothScale 4; errorReduction 0.75;
}
mergeTolerance 1e-6;
)";

/// A case in a fresh directory, in which programs are run.
class Case {
public:
    Case() {
        fs::create_directories(dir_ / "system");
        fs::create_directories(dir_ / "constant");
        write("controlDict", controlDict);
        write("fvSchemes",
              "ddtSchemes {} gradSchemes {} divSchemes {} laplacianSchemes {} "
              "interpolationSchemes {} snGradSchemes {}");
        write("fvSolution", "");
    }

    void write(const std::string& dictionary, const std::string& text) const {
        std::ofstream(dir_ / "system" / dictionary) << header << text;
    }

    fs::path mesh() const { return dir_ / "constant" / "polyMesh"; }

    fs::path path(const std::string& name) const { return dir_ / name; }

    /// Runs a command in the case; its output goes to `log`. Returns the exit status.
    int run(const std::string& command, const std::string& log = "log") const {
        const std::string line = "cd '" + dir_.path().string() +
                                 "' && WM_PROJECT_DIR=/usr/share/openfoam " + command + " > " +
                                 log + " 2>&1";
        const int status = std::system(line.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    std::string text(const std::string& name) const { return test::readText(dir_ / name); }

private:
    test::TemporaryDirectory dir_;
};

bool hasOpenFoam() {
    return fs::exists("/usr/bin/checkMesh") && fs::exists("/usr/bin/blockMesh");
}

/// The lines of a report, blanks squeezed (OpenFOAM's columns move when there are polyhedra).
/// Left out: what is ours, and a file that only OpenFOAM writes.
std::vector<std::string> reportLines(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text.substr(std::min(text.size(), text.find("Mesh stats"))));
    for (std::string line; std::getline(in, line) && line != "End";) {
        std::istringstream words(line);
        std::string squeezed;
        for (std::string word; words >> word;)
            squeezed += (squeezed.empty() ? "" : " ") + word;
        if (squeezed.empty() || squeezed.starts_with("worst:") ||
            squeezed.starts_with("<<Writing region information"))
            continue;
        lines.push_back(squeezed);
    }
    return lines;
}

/// All files of sets, each without its head.
std::map<std::string, std::vector<Label>> takeSets(const fs::path& mesh) {
    std::map<std::string, std::vector<Label>> sets;
    if (!fs::exists(mesh / "sets")) return sets;
    for (const auto& entry : fs::directory_iterator(mesh / "sets")) {
        const std::string name = entry.path().filename().string();
        std::ostringstream all;
        all << std::ifstream(entry.path()).rdbuf();
        const auto kind = all.str().find("pointSet") != std::string::npos  ? foam::SetKind::point
                          : all.str().find("faceSet") != std::string::npos ? foam::SetKind::face
                                                                           : foam::SetKind::cell;
        sets[name] = foam::readSet(mesh, kind, name);
    }
    fs::remove_all(mesh / "sets");
    return sets;
}

void expectSameReport(const Case& c, const std::string& options) {
    fs::remove_all(c.mesh() / "sets");
    c.run("/usr/bin/checkMesh -constant -noFunctionObjects " + options, "log.openfoam");
    const auto theirSets = takeSets(c.mesh());
    const int status = c.run(std::string(POLYMESH_BIN) + "/checkMesh " + options, "log.ours");
    const auto ourSets = takeSets(c.mesh());
    const auto theirs = reportLines(c.text("log.openfoam"));
    const auto ours = reportLines(c.text("log.ours"));
    ASSERT_FALSE(theirs.empty()) << c.text("log.openfoam");
    EXPECT_EQ(ours, theirs);
    EXPECT_EQ(ourSets, theirSets);
    EXPECT_EQ(status, theirs.back() == "Mesh OK." ? 0 : 1);
}

void expectSame(const Case& c) {
    expectSameReport(c, "");
    expectSameReport(c, "-allTopology -allGeometry");
}

void expectSame(const PolyMesh& mesh) {
    const Case c;
    foam::writePolyMesh(mesh, c.mesh(), {});
    expectSame(c);
}

void block(const Case& c, const std::string& dictionary) {
    c.write("blockMeshDict", dictionary);
    ASSERT_EQ(c.run("blockMesh"), 0) << c.text("log");
}

class CheckMesh : public testing::Test {
protected:
    void SetUp() override {
        if (!hasOpenFoam()) GTEST_SKIP() << "OpenFOAM is not installed";
    }
};

TEST_F(CheckMesh, agreesOnAGradedCurvedBlock) {
    const Case c;
    block(c, curvedBlock);
    expectSame(c);
}

TEST_F(CheckMesh, agreesOnTwoDimensions) {
    const Case c;
    block(c, flatBlock);
    expectSame(c);
}

TEST_F(CheckMesh, agreesOnAWedge) {
    const Case c;
    block(c, wedgeBlock);
    expectSame(c);
}

TEST_F(CheckMesh, agreesOnCyclicPatches) {
    const Case c;
    block(c, cyclicBlock);
    expectSame(c);
}

TEST_F(CheckMesh, agreesOnDistortedMeshesWhateverIsWrongWithThem) {
    const Case c;
    block(c, curvedBlock);
    const PolyMesh mesh = foam::readPolyMesh(c.mesh());
    for (const double amplitude : {0.02, 0.06, 0.15, 0.4}) {
        foam::writePolyMesh(test::jittered(mesh, amplitude), c.mesh(), {});
        expectSame(c);
    }
}

TEST_F(CheckMesh, agreesOnDistortedFlatMeshes) {
    const Case c;
    block(c, flatBlock);
    foam::writePolyMesh(test::jittered(foam::readPolyMesh(c.mesh()), 0.02), c.mesh(), {});
    expectSame(c);
}

TEST_F(CheckMesh, agreesOnSnappyHexMeshAndItsDual) {
    const Case c;
    block(c, cubeBlock);
    c.write("snappyHexMeshDict", snappyBall);
    ASSERT_EQ(c.run("snappyHexMesh -overwrite"), 0) << c.text("log");
    expectSame(c);
    fs::remove(c.mesh() / "cellLevel");
    fs::remove(c.mesh() / "pointLevel");
    fs::remove(c.mesh() / "level0Edge");
    fs::remove(c.mesh() / "surfaceIndex");
    ASSERT_EQ(c.run("polyDualMesh 60 -overwrite"), 0) << c.text("log");
    expectSame(c);
}

TEST_F(CheckMesh, agreesOnEveryMeshOfTheSupport) {
    for (const PolyMesh& mesh : {test::unitCube(),
                                 test::box(3, 4, 5),
                                 test::prismFan(7),
                                 test::lShapedCell(),
                                 test::tetrahedron(),
                                 test::pyramid(),
                                 test::wedge(),
                                 test::hangingNodes(),
                                 test::jittered(test::hangingNodes(), 0.1),
                                 test::invertedCell()})
        expectSame(mesh);
}

TEST_F(CheckMesh, agreesOnAnOpenCell) {
    expectSame(test::openCell());
}

TEST_F(CheckMesh, agreesOnPartsThatTouchOrNot) {
    const PolyMesh grid = test::box(4, 2, 1);
    const auto at = [](Label i, Label j, Label k) { return i + 5 * (j + 3 * k); };
    const auto hex = [&](Label i, Label j) {
        return test::hexahedron({at(i, j, 0),
                                 at(i + 1, j, 0),
                                 at(i + 1, j + 1, 0),
                                 at(i, j + 1, 0),
                                 at(i, j, 1),
                                 at(i + 1, j, 1),
                                 at(i + 1, j + 1, 1),
                                 at(i, j + 1, 1)});
    };
    PolyMesh mesh = test::meshOf(grid.points, {hex(0, 0), hex(1, 1), hex(3, 0)});
    expectSame(mesh); // with unused points, too
}

TEST_F(CheckMesh, agreesOnFacesOutOfOrder) {
    PolyMesh mesh = test::box(3, 1, 1);
    std::swap_ranges(mesh.faces[0].begin(), mesh.faces[0].end(), mesh.faces[1].begin());
    std::swap(mesh.owner[0], mesh.owner[1]);
    std::swap(mesh.neighbour[0], mesh.neighbour[1]);
    expectSame(mesh);
    PolyMesh turned = test::box(2, 2, 2);
    std::reverse(turned.faces[3].begin(), turned.faces[3].end());
    expectSame(turned);
}

TEST_F(CheckMesh, agreesOnShortEdgesAndNearPoints) {
    PolyMesh mesh = test::box(3, 3, 3);
    mesh.points[0] = mesh.points[1] + Vec3{1e-7, 0, 0};
    mesh.points[37] = mesh.points[21] + Vec3{0, 1e-7, 1e-7};
    expectSame(mesh);
}

TEST_F(CheckMesh, agreesOnZones) {
    PolyMesh mesh = test::box(3, 3, 3);
    mesh.pointZones.push_back({"points", {0, 5}, {}});
    mesh.cellZones.push_back({"cells", {0, 1, 13}, {}});
    mesh.faceZones.push_back({"faces", {0, 1, 2, 20}, {false, true, false, false}});
    expectSame(mesh);
}

TEST(CheckMeshTool, reportsInJson) {
    const Case c;
    foam::writePolyMesh(test::invertedCell(), c.mesh(), {});
    EXPECT_EQ(c.run(std::string(POLYMESH_BIN) + "/checkMesh -json r.json -quiet"), 1);
    const auto json = nlohmann::json::parse(c.text("r.json"));
    EXPECT_EQ(json["ok"], false);
    EXPECT_EQ(json["cells"], 1);
    EXPECT_EQ(json["shapes"]["hexahedra"], 1);
    EXPECT_NEAR(json["volume"].get<double>(), -1, 1e-14);
    EXPECT_EQ(json["failed"].dump(), R"(["aspectRatio","cellVolume","facePyramids"])");
    EXPECT_TRUE(fs::exists(c.mesh() / "sets" / "zeroVolumeCells"));
    EXPECT_EQ(c.text("log"), "");
}

TEST(CheckMeshTool, removesSetsThatNoLongerHold) {
    const Case c;
    foam::writePolyMesh(test::unitCube(), c.mesh(), {});
    foam::writeSet(c.mesh(), foam::SetKind::cell, "zeroVolumeCells", std::vector<Label>{0});
    foam::writeSet(c.mesh(), foam::SetKind::cell, "mine", std::vector<Label>{0});
    EXPECT_EQ(c.run(std::string(POLYMESH_BIN) + "/checkMesh"), 0);
    EXPECT_FALSE(fs::exists(c.mesh() / "sets" / "zeroVolumeCells"));
    EXPECT_TRUE(fs::exists(c.mesh() / "sets" / "mine"));
}

/// The sides of the unit cube as faces of an OBJ file, with the normals outward.
const std::vector<std::string> cubeSides{
    "1 4 3 2", "5 6 7 8", "1 2 6 5", "4 8 7 3", "1 5 8 4", "2 3 7 6"};

/// Compares the unit cube of eight cells with a surface of these sides: the output, and the
/// report's part `surface`.
std::pair<std::string, nlohmann::json> compareCube(const std::vector<std::string>& sides) {
    const Case c;
    foam::writePolyMesh(test::box(2, 2, 2), c.mesh(), {});
    std::ofstream obj(c.path("s.obj"));
    obj << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
    for (const std::string& side : sides)
        obj << "f " << side << '\n';
    obj.close();
    EXPECT_EQ(c.run(std::string(POLYMESH_BIN) + "/checkMesh -surface s.obj -json r.json"), 0)
        << c.text("log");
    return {c.text("log"), nlohmann::json::parse(c.text("r.json"))["surface"]};
}

void expectNoDifference(const nlohmann::json& surface) {
    for (const char* key : {"volumeError", "areaError", "maxDistance", "meanDistance"})
        EXPECT_NEAR(surface[key].get<double>(), 0, 1e-15) << key;
    EXPECT_NEAR(surface["surfaceVolume"].get<double>(), 1, 1e-15);
}

std::string turned(std::string side) {
    std::ranges::reverse(side);
    return side;
}

TEST(CheckMeshTool, comparesWithASurface) {
    const auto [log, surface] = compareCube(cubeSides);
    expectNoDifference(surface);
    EXPECT_NEAR(surface["volume"].get<double>(), 1, 1e-15);
    EXPECT_NEAR(surface["area"].get<double>(), 6, 1e-14);
    EXPECT_EQ(surface["turnedTriangles"], 0);
    EXPECT_EQ(surface["openEdges"], 0);
    EXPECT_EQ(log.find("Turned"), std::string::npos);
    EXPECT_EQ(log.find("Open"), std::string::npos);
}

TEST(CheckMeshTool, turnsTheSidesOfASurfaceThatDisagreeWithTheOthers) {
    std::vector<std::string> sides = cubeSides;
    for (const std::size_t i : {0U, 3U})
        sides[i] = turned(sides[i]);
    const auto [log, surface] = compareCube(sides);
    expectNoDifference(surface);
    EXPECT_EQ(surface["turnedTriangles"], 4);
    EXPECT_NE(log.find("Turned 4 triangles, so that normals leave the part\n"), std::string::npos)
        << log;
}

TEST(CheckMeshTool, turnsASurfaceThatIsInsideOut) {
    std::vector<std::string> sides = cubeSides;
    std::ranges::transform(sides, sides.begin(), turned);
    const auto [log, surface] = compareCube(sides);
    expectNoDifference(surface);
    EXPECT_EQ(surface["turnedTriangles"], 12);
    EXPECT_NE(log.find("(the surface was inside out)"), std::string::npos) << log;
}

TEST(CheckMeshTool, saysThatASurfaceIsOpen) {
    const auto [log, surface] = compareCube({cubeSides.begin(), cubeSides.end() - 1});
    EXPECT_EQ(surface["openEdges"], 4);
    EXPECT_NEAR(surface["surfaceArea"].get<double>(), 5, 1e-14);
    EXPECT_NE(log.find("Open: 4 edges without a partner, one at (1 "), std::string::npos) << log;
}

TEST(CheckMeshTool, saysWhatIsMissing) {
    const Case c;
    EXPECT_EQ(c.run(std::string(POLYMESH_BIN) + "/checkMesh"), 2);
    EXPECT_NE(c.text("log").find("constant/polyMesh"), std::string::npos);
    EXPECT_EQ(c.run(std::string(POLYMESH_BIN) + "/checkMesh -allGeometri"), 2);
    EXPECT_NE(c.text("log").find("allGeometry"), std::string::npos);
}

} // namespace
} // namespace polymesh
