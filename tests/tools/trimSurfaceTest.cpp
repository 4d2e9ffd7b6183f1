// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/polyMeshIo.h"
#include "formats/surfaceIo.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"
#include "tests/support/twistedStar.h"
#include "tests/tools/program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace polymesh::tools {

namespace {

using test::cuboid;
using test::join;

/// A case with a box of 6 x 6 x 6 cells from the origin to (1 1 1), and a surface.
class TrimCase : public TemporaryCase {
public:
    explicit TrimCase(const TriSurface& surface = cuboid({.2, .2, .2}, {.7, .7, .7}, "body"),
                      const char* name = "part.obj") {
        std::filesystem::create_directories(dir() / "constant/triSurface");
        addSurface(surface, name);
        restoreMesh();
    }

    void addSurface(const TriSurface& surface, const char* name) const {
        writeSurface(surface, dir() / "constant/triSurface" / name);
    }

    void restoreMesh() const {
        EXPECT_EQ(run("blockInit -box '0 0 0 1 1 1' -cells '6 6 6' -quiet").status, 0);
    }

    PolyMesh mesh() const { return foam::readPolyMesh(dir() / "constant/polyMesh"); }

    /// All bytes of the mesh.
    std::string meshBytes() const {
        std::string bytes;
        for (const char* file : {"points", "faces", "owner", "neighbour", "boundary"})
            bytes += read(std::filesystem::path("constant/polyMesh") / file);
        return bytes;
    }

    nlohmann::json report() const { return nlohmann::json::parse(read("report.json")); }

    ProgramResult trim(const std::string& options = "") const {
        return run("trimSurface -surface part.obj -json report.json " + options);
    }
};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The call fails with status 2 and one line on stderr that has these parts; the mesh stays.
void expectRefused(const TrimCase& box,
                   const std::string& command,
                   const std::vector<std::string>& parts) {
    const std::string before = box.meshBytes();
    const ProgramResult result = box.run(command);
    EXPECT_EQ(result.status, 2) << command;
    EXPECT_TRUE(result.err.starts_with("trimSurface: ")) << result.err;
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    for (const std::string& part : parts)
        EXPECT_TRUE(contains(result.err, part)) << part << " is not in: " << result.err;
    EXPECT_TRUE(box.meshBytes() == before) << command;
    for (const auto& entry : std::filesystem::directory_iterator(box.dir() / "constant"))
        EXPECT_TRUE(entry.path().filename() == "polyMesh" ||
                    entry.path().filename() == "triSurface")
            << entry.path();
}

} // namespace

TEST(TrimSurface, trimsAndReports) {
    const TrimCase box;
    const ProgramResult result = box.trim();
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const PolyMesh mesh = box.mesh();
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_EQ(mesh.patches.back().name, "body");
    EXPECT_EQ(mesh.patches.back().type, "wall");
    const nlohmann::json report = box.report();
    EXPECT_EQ(report["cells"], mesh.cellCount);
    EXPECT_EQ(report["untouched"].get<Label>() + report["trimmed"].get<Label>(), mesh.cellCount);
    EXPECT_NEAR(report["volume"].get<double>(), 0.125, 1e-14);
    EXPECT_NEAR(report["area"].get<double>(), 1.5, 1e-14);
    EXPECT_NEAR(report["patches"]["body"]["area"].get<double>(), 1.5, 1e-14);
    EXPECT_EQ(report["cornersInMesh"], 8);
    EXPECT_EQ(report["cornersCaptured"], 8);
    EXPECT_EQ(report["featureEdges"], 12);
    EXPECT_EQ(report["surface"]["selfIntersections"]["pairs"], 0);
    EXPECT_GT(report["peakMemoryBytes"], 100000);
    EXPECT_GT(report["stages"].size(), 5U);
    for (const char* line :
         {"\ncells ", "\nfeatures ", "\nvolume ", "\narea ", "\ntime ", "\nmemory "})
        EXPECT_TRUE(contains(result.out, line)) << line;
}

TEST(TrimSurface, keepsTheOutside) {
    const TrimCase box;
    ASSERT_EQ(box.trim("-keep outside").status, 0);
    EXPECT_NEAR(box.report()["volume"].get<double>(), 1 - 0.125, 1e-13);
    EXPECT_NEAR(box.report()["volumeError"].get<double>(), 0, 1e-13);
    EXPECT_EQ(box.mesh().patches.size(), 7U);
}

TEST(TrimSurface, isQuietWhenAskedTo) {
    const TrimCase box;
    const ProgramResult result = box.trim("-quiet");
    EXPECT_EQ(result.out + result.err, "");
}

TEST(TrimSurface, readsItsDictionaryAndOptionsWin) {
    const TrimCase box;
    box.write("system/trimSurfaceDict",
              "surface part.obj; keep outside; deviation 0; patchType patch;\n"
              "patchTypes { body symmetry; }\n");
    ASSERT_EQ(box.run("trimSurface").status, 0);
    EXPECT_EQ(box.mesh().patches.size(), 7U);
    EXPECT_EQ(box.mesh().patches.back().type, "symmetry");
    box.restoreMesh();
    ASSERT_EQ(box.run("trimSurface -keep inside -patchType wall").status, 0);
    EXPECT_EQ(box.mesh().patches.size(), 1U);
    EXPECT_EQ(box.mesh().patches.back().type, "wall");
    box.restoreMesh();
    box.write("system/trimSurfaceDict", "surface part.obj;\n\npatchTypes\n{ bdy wall; }\n");
    expectRefused(box, "trimSurface", {"trimSurfaceDict:4: bdy", "nearest is body"});
    box.write("system/trimSurfaceDict", "surface part.obj;\npatchTypes { body wal; }\n");
    expectRefused(box, "trimSurface", {"trimSurfaceDict:2: body", "'wal'", "nearest: wall"});
    box.write("system/trimSurfaceDict", "surface part.obj;\nkep outside;\n");
    expectRefused(box, "trimSurface", {"trimSurfaceDict:2: kep", "nearest is keep"});
}

TEST(TrimSurface, eachRegionHasItsPatchType) {
    const TrimCase box(join(cuboid({.1, .1, .1}, {.4, .4, .4}, "left"),
                            cuboid({.6, .6, .6}, {.9, .9, .9}, "right")));
    box.write("system/trimSurfaceDict", "patchType patch; patchTypes { right wall; }");
    ASSERT_EQ(box.trim().status, 0);
    const PolyMesh mesh = box.mesh();
    ASSERT_EQ(mesh.patches.size(), 2U);
    EXPECT_EQ(mesh.patches[0].name + " " + mesh.patches[0].type, "left patch");
    EXPECT_EQ(mesh.patches[1].name + " " + mesh.patches[1].type, "right wall");
}

TEST(TrimSurface, adjustsNodesAndSaysHowMany) {
    const TrimCase box(cuboid({.15, .15, .15}, {.7, .7, .7}));
    const ProgramResult result = box.trim("-adjust project");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(contains(result.out,
                         "adjusted   8 nodes onto corners, 24 onto edges, 24 onto faces"
                         "; 0 refused"))
        << result.out;
    EXPECT_EQ(box.report()["adjusted"]["corners"], 8);
    EXPECT_EQ(box.report()["adjusted"]["faces"], 24);
    EXPECT_EQ(box.report()["cells"], 27);
    box.restoreMesh();
    ASSERT_EQ(box.trim("-adjust repel -adjustDistance 0.2").status, 0);
    EXPECT_GT(box.report()["adjusted"]["away"], 0);
    box.restoreMesh();
    const ProgramResult avoided = box.trim("-adjust avoid");
    ASSERT_EQ(avoided.status, 0) << avoided.err;
    EXPECT_NE(avoided.out.find("edges near feature edges: "), std::string::npos) << avoided.out;
    EXPECT_NE(avoided.out.find("% have three edges"), std::string::npos) << avoided.out;
    EXPECT_GE(box.report()["closeEdges"][0], box.report()["closeEdges"][1]);
    EXPECT_GT(box.report()["trivalentNodes"], 0);
    ASSERT_EQ(box.trim("-adjust project -adjustDistance 0.01").status, 0);
    EXPECT_EQ(box.report()["adjusted"]["faces"], 0);
}

TEST(TrimSurface, adjustOnlyMovesNodesAndDoesNotTrim) {
    const TrimCase box(cuboid({.15, .15, .15}, {.7, .7, .7}));
    const PolyMesh before = box.mesh();
    const ProgramResult result = box.trim("-adjust project -adjustOnly");
    ASSERT_EQ(result.status, 0) << result.err;
    const PolyMesh after = box.mesh();
    EXPECT_TRUE(validate(after).empty());
    EXPECT_EQ(after.faces, before.faces);
    EXPECT_EQ(after.patches, before.patches);
    EXPECT_EQ(std::ranges::count(after.points, Vec3{.15, .7, .15}), 1);
    std::size_t moved = 0;
    for (std::size_t p = 0; p < after.points.size(); ++p)
        moved += after.points[p] != before.points[p] ? 1U : 0U;
    EXPECT_EQ(moved, 8U + 24U + 24U);
    expectRefused(box, "trimSurface -surface part.obj -adjustOnly", {"adjustOnly", "project"});
}

TEST(TrimSurface, wrongOptionsAreRefused) {
    const TrimCase box;
    const std::string call = "trimSurface -surface part.obj ";
    expectRefused(box, "trimSurface", {"-surface is missing"});
    expectRefused(box, "trimSurface -surface missing.stl", {"missing.stl"});
    expectRefused(box, call + "-case nowhere", {"nowhere"});
    expectRefused(box, call + "-keep inide", {"-keep", "nearest: inside"});
    expectRefused(box, call + "-deviation -1", {"-deviation"});
    expectRefused(box, call + "-deviation much", {"-deviation", "much"});
    expectRefused(box, call + "-deviation nan", {"-deviation"});
    expectRefused(box, call + "-featureAngle 181", {"-featureAngle"});
    expectRefused(box, call + "-minEdge 0.7", {"-minEdge"});
    expectRefused(box, call + "-minVolume -0.1", {"-minVolume"});
    expectRefused(box, call + "-concave maybe", {"-concave"});
    expectRefused(box, call + "-adjust projct", {"-adjust", "nearest: project"});
    expectRefused(box, call + "-adjust project -adjustDistance 0.6", {"-adjustDistance"});
    expectRefused(box, call + "-patchType 'a b'", {"-patchType", "a b"});
    expectRefused(box, call + "-patchTyp wall", {"-patchTyp", "nearest is -patchType"});
    expectRefused(box, call + "-format asci", {"-format", "ascii"});
    expectRefused(box, call + "-threads 0", {"-threads"});
}

TEST(TrimSurface, bothAlgorithmsGiveTheSameBytes) {
    const TrimCase box(join(cuboid({.1, .1, .1}, {.9, .9, .9}, "body"),
                            test::inverted(test::sphere(2, 0.21, {0.6, 0.6, 0.6}))));
    for (const char* options : {"", "-deviation 0 -minEdge 0 -minVolume 0", "-keep outside"}) {
        std::array<std::string, 2> bytes;
        for (std::size_t i = 0; i < 2; ++i) {
            box.restoreMesh();
            const std::string algorithm = i == 0 ? "mesh " : "cell ";
            const ProgramResult result = box.trim("-algorithm " + algorithm + options);
            EXPECT_EQ(result.status, 0) << result.err;
            bytes[i] = box.meshBytes();
        }
        EXPECT_TRUE(bytes[0] == bytes[1]) << options;
    }
    box.restoreMesh();
    box.write("system/trimSurfaceDict", "algorithm cell;\n");
    expectRefused(
        box, "trimSurface -surface part.obj -algorithm cells", {"-algorithm", "nearest: cell"});
    EXPECT_EQ(box.trim().status, 0);
    EXPECT_TRUE(contains(box.read("report.json"), "join cells"));
}

TEST(TrimSurface, openSurfaceIsRefusedWithNumberAndPlace) {
    const TrimCase box(test::without(cuboid({.2, .2, .2}, {.7, .7, .7}), 2));
    expectRefused(box,
                  "trimSurface -surface part.obj",
                  {"part.obj", "open", "3 edges", "one at (", "close the gaps"});
}

TEST(TrimSurface, surfaceInsideOutIsTurnedAndSaid) {
    const TrimCase box(test::inverted(cuboid({.2, .2, .2}, {.7, .7, .7})));
    const ProgramResult result = box.trim();
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(contains(result.out, "turned     12 triangles")) << result.out;
    EXPECT_TRUE(contains(result.out, "inside out")) << result.out;
    EXPECT_NEAR(box.report()["volume"].get<double>(), 0.125, 1e-14);
    EXPECT_EQ(box.report()["surface"]["turnedTriangles"], 12);
}

TEST(TrimSurface, surfaceOutsideTheMeshIsRefusedWithBothBoxes) {
    const TrimCase box(cuboid({2, 2, 2}, {3, 3, 3}));
    for (const char* side : {"inside", "outside"})
        expectRefused(box,
                      std::string("trimSurface -surface part.obj -keep ") + side,
                      {"outside the mesh", "(2 2 2) (3 3 3)", "(0 0 0) (1 1 1)"});
}

TEST(TrimSurface, surfacePartlyOutsideIsWarnedOfAndTrimmed) {
    const TrimCase box(cuboid({.5, .2, .2}, {2, .7, .7}));
    const ProgramResult result = box.trim();
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(result.err.starts_with("trimSurface: warning: ")) << result.err;
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1);
    EXPECT_TRUE(contains(result.err, "(0.5 0.2 0.2) (2 0.7 0.7)")) << result.err;
    EXPECT_TRUE(contains(result.err, "(0 0 0) (1 1 1)")) << result.err;
    EXPECT_NEAR(box.report()["volume"].get<double>(), 0.125, 1e-14);
    EXPECT_FALSE(box.report().contains("volumeError"));
    EXPECT_EQ(box.mesh().patches.size(), 2U); // the mesh's own xMax closes it
}

TEST(TrimSurface, anEmptyResultIsRefused) {
    const TrimCase box(cuboid({-1, -1, -1}, {2, 2, 2}));
    const std::string before = box.meshBytes();
    const ProgramResult result = box.trim("-keep outside");
    EXPECT_EQ(result.status, 2);
    EXPECT_TRUE(contains(result.err, "trimSurface: nothing is left")) << result.err;
    EXPECT_EQ(box.meshBytes(), before);
}

TEST(TrimSurface, featuresLeftOutForTheSakeOfCellsAreWarnedOf) {
    const TrimCase thread(test::TwistedStar{3, 20, 0.3}.surface());
    EXPECT_EQ(thread.run("blockInit -surface part.obj -cellSize 0.4 -quiet").status, 0);
    const ProgramResult result = thread.trim("-quiet");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(result.err.starts_with("trimSurface: warning: features of the surface are left "))
        << result.err;
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    EXPECT_EQ(thread.report()["badCells"], 0);
    EXPECT_EQ(thread.run("blockInit -surface part.obj -cellSize 0.4 -quiet").status, 0);
    EXPECT_EQ(thread.trim("-quiet -concave keep").err, "");
}

TEST(TrimSurface, partsThatOverlapAreUnitedAndSaidSo) {
    const TrimCase box(
        join(cuboid({.2, .2, .2}, {.6, .6, .6}), cuboid({.4, .4, .4}, {.8, .8, .8})));
    const ProgramResult result = box.trim("-deviation 0 -minEdge 0 -minVolume 0");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(result.err.starts_with("trimSurface: warning: ")) << result.err;
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    for (const char* part : {" pairs of triangles, near (", "of 24 triangles divided", "united"})
        EXPECT_TRUE(contains(result.err, part)) << part << " is not in: " << result.err;
    EXPECT_NEAR(box.report()["volume"].get<double>(), 2 * 0.064 - 0.008, 1e-14);
    EXPECT_NEAR(box.report()["volumeError"].get<double>(), 0, 1e-13);
    EXPECT_NEAR(box.report()["surface"]["united"]["volumeBefore"].get<double>(), 0.128, 1e-14);
}

TEST(TrimSurface, aCrackOfRoundingIsClosedAndSaidSo) {
    // The lid of a box comes with coordinates of its own, one unit off in the last of six digits.
    std::string text = "v 0.2 0.2 0.2\nv 0.7 0.2 0.2\nv 0.7 0.7 0.2\nv 0.2 0.7 0.2\n"
                       "v 0.2 0.2 0.7\nv 0.7 0.2 0.7\nv 0.7 0.7 0.7\nv 0.2 0.7 0.7\n"
                       "v 0.2 0.2 0.700001\nv 0.7 0.2 0.700001\nv 0.7 0.7 0.700001\n"
                       "v 0.2 0.7 0.700001\nf 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n"
                       "f 4 1 5 8\nf 9 10 11 12\n";
    const TrimCase box;
    box.write("constant/triSurface/part.obj", text);
    const ProgramResult result = box.trim();
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(contains(result.err, "8 open edges, closed by joining 4 points")) << result.err;
    EXPECT_NEAR(box.report()["volume"].get<double>(), 0.125, 1e-14);
}

TEST(TrimSurface, unitesPartsThatOverlapOutsideTheMeshToo) {
    // Two cubes that overlap outside the mesh only.
    TrimCase box(join(cuboid({.2, .2, .2}, {1.6, .5, .5}), cuboid({1.3, .3, .3}, {1.9, .9, .9})));
    const ProgramResult result = box.trim();
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(contains(result.err, "intersects itself")) << result.err;
    EXPECT_GT(box.report()["surface"]["selfIntersections"]["pairs"], 0);
    EXPECT_NEAR(box.report()["volume"].get<double>(), 0.8 * 0.09, 1e-14);
}

TEST(TrimSurface, whatIsUnusualButHarmlessIsMentioned) {
    // Two cubes that share an edge, on which four triangles meet.
    const TrimCase box(
        join(cuboid({.1, .1, .1}, {.5, .5, .5}), cuboid({.5, .5, .1}, {.9, .9, .5})));
    const ProgramResult result = box.trim();
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(contains(result.out, "unusual    1 edges of more than two triangles"))
        << result.out;
    EXPECT_NEAR(box.report()["volume"].get<double>(), 2 * 0.064, 1e-14);
}

TEST(TrimSurface, cellZonesStayAndOtherZonesAreDroppedAloud) {
    const TrimCase box;
    PolyMesh mesh = box.mesh();
    mesh.cellZones = {{"low", {}, {}}};
    for (Label c = 0; c < 108; ++c)
        mesh.cellZones[0].labels.push_back(c);
    mesh.faceZones = {{"some", {0, 1, 2}, {false, true, false}}};
    mesh.pointZones = {{"few", {5}, {}}};
    foam::writePolyMesh(mesh, box.dir() / "constant/polyMesh", {});
    const ProgramResult result = box.trim();
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(contains(result.out, "1 faceZones and 1 pointZones are dropped")) << result.out;
    const PolyMesh after = box.mesh();
    ASSERT_EQ(after.cellZones.size(), 1U);
    EXPECT_EQ(after.cellZones[0].name, "low");
    std::vector<Label> lowCells; // the zone's cells were those below z = 0.5
    const std::vector<Vec3> centres = computeGeometry(after).cellCentres;
    for (Label c = 0; c < after.cellCount; ++c)
        if (centres[static_cast<std::size_t>(c)].z < 0.5) lowCells.push_back(c);
    EXPECT_EQ(after.cellZones[0].labels, lowCells);
    EXPECT_LT(toLabel(lowCells.size()), after.cellCount);
    EXPECT_TRUE(after.faceZones.empty());
}

TEST(TrimSurface, brokenMeshAndBrokenSurfaceAreRefused) {
    const TrimCase box;
    box.write("constant/triSurface/broken.stl", "solid x\nfacet normal 0 0\n");
    expectRefused(box, "trimSurface -surface broken.stl", {"broken.stl"});
    const std::string owner = box.read("constant/polyMesh/owner");
    box.write("constant/polyMesh/owner", std::string_view(owner).substr(0, owner.size() / 2));
    expectRefused(box, "trimSurface -surface part.obj", {"owner"});
    std::filesystem::remove_all(box.dir() / "constant/polyMesh");
    std::filesystem::create_directories(box.dir() / "constant/polyMesh");
    expectRefused(box, "trimSurface -surface part.obj", {"polyMesh"});
}

TEST(TrimSurface, aMeshThatIsNotValidIsRefusedWithWhatIsWrong) {
    const TrimCase box;
    PolyMesh mesh = box.mesh();
    const Label inside = 86; // a cell in the middle of the body
    const auto face = std::ranges::find(mesh.owner, inside) - mesh.owner.begin();
    mesh.owner[static_cast<std::size_t>(face)] = mesh.neighbour[static_cast<std::size_t>(face)];
    foam::writePolyMesh(mesh, box.dir() / "constant/polyMesh", {});
    const std::vector<std::string> parts{"constant/polyMesh: face",
                                         "has owner 87 and neighbour 87"};
    expectRefused(box, "trimSurface -surface part.obj", parts);
    expectRefused(box, "trimSurface -surface part.obj -deviation 0 -minEdge 0 -minVolume 0", parts);
}

TEST(TrimSurface, aMeshWithAPointFarOffIsRefused) {
    const TrimCase box;
    PolyMesh mesh = box.mesh();
    mesh.points[0].x = -1e300;
    foam::writePolyMesh(mesh, box.dir() / "constant/polyMesh", {});
    expectRefused(box, "trimSurface -surface part.obj", {"constant/polyMesh", "(-1e+300 0 0)"});
}

TEST(TrimSurface, givesTheSameBytesWithAnyNumberOfThreads) {
    const TrimCase box(test::sphere(3, .41, {.5, .5, .5}));
    std::string one;
    for (const char* threads : {"1", "2", "8"}) {
        box.restoreMesh();
        ASSERT_EQ(box.trim(std::string("-threads ") + threads).status, 0);
        if (one.empty()) one = box.meshBytes();
        EXPECT_TRUE(box.meshBytes() == one) << threads << " threads";
    }
}

TEST(TrimSurface, saysWhereCellsWereMadeWithAnotherDeviationAndGivesTheSameBytes) {
    using test::sphere;
    const TrimCase box(join(sphere(2), test::inverted(sphere(1, 0.4, {0.22, 0.35, 0.03}))));
    std::string one;
    for (const char* threads : {"1", "2", "8"}) {
        EXPECT_EQ(box.run("blockInit -surface part.obj -cellSize 0.25 -quiet").status, 0);
        const ProgramResult result = box.trim(std::string("-threads ") + threads);
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_TRUE(contains(result.out, "; 0 bad cells left\n")) << result.out;
        EXPECT_TRUE(contains(result.out, "\nremade     ")) << result.out;
        const nlohmann::json report = box.report();
        EXPECT_GT(report["remadeCells"], 0);
        EXPECT_GT(report["remadePlaces"].size(), 0U);
        EXPECT_LT(report["remadePlaces"][0]["min"][0], report["remadePlaces"][0]["max"][0]);
        if (one.empty()) one = box.meshBytes();
        EXPECT_TRUE(box.meshBytes() == one) << threads << " threads";
    }
}

TEST(TrimSurface, refinedMeshesAreTrimmedExactly) {
    const TrimCase box;
    const std::string flange =
        "-surface /usr/share/doc/openfoam-examples/examples/resources/geometry/flange.stl.gz ";
    ASSERT_EQ(box.run("blockInit " + flange +
                      "-cellSize 0.005 -levels '((0 1) (0.002 1))' -curvature '(3 3)'")
                  .status,
              0);
    const ProgramResult exact =
        box.run("trimSurface " + flange + "-deviation 0 -minEdge 0 -minVolume 0 -json report.json");
    ASSERT_EQ(exact.status, 0) << exact.err;
    EXPECT_NEAR(box.report()["volumeError"].get<double>(), 0, 1e-11);
}

} // namespace polymesh::tools
