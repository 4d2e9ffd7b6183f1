// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// blockInit on blockMeshDict files, alone and against OpenFOAM's blockMesh.

#include "formats/foam/polyMeshIo.h"
#include "libpolymesh/mesh/validate.h"
#include "tests/tools/program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace polymesh::tools {

namespace {

namespace fs = std::filesystem;

constexpr const char* dictionary = R"(FoamFile { format ascii; class dictionary; }
scale 0.1; n 3; h #eval{ 2*$n };
vertices ( (0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 $h) (1 0 $h) name top (1 1 $h) (0 1 $h) );
blocks ( name b hex (0 1 2 3 4 5 top 7) zone ($n 2 4) simpleGrading (((1 2 3) (1 1 1)) -2 1) );
edges ( arc 0 1 (0.5 -0.2 0) );
boundary ( floor { type wall; faces ((b 4)); }
           sides { type patch; faces ((0 4 7 3) (1 2 6 5)); } );
defaultPatch { name rest; type patch; }
)";

/// The dictionary with a part replaced.
std::string with(const std::string& part, const std::string& other) {
    std::string text = dictionary;
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), other);
}

PolyMesh meshOf(const TemporaryCase& box) {
    return foam::readPolyMesh(box.dir() / "constant/polyMesh");
}

} // namespace

TEST(BlockMeshDict, isReadFromSystemWithoutOptions) {
    const TemporaryCase box;
    box.write("system/blockMeshDict", dictionary);
    const ProgramResult result = box.run("blockInit");
    ASSERT_EQ(result.status, 0) << result.err;
    const PolyMesh mesh = meshOf(box);
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_EQ(mesh.cellCount, 24);
    ASSERT_EQ(mesh.patches.size(), 3U);
    EXPECT_EQ(mesh.patches[0].name, "floor");
    EXPECT_EQ(mesh.patches[0].size, 6);
    EXPECT_EQ(mesh.patches[2].name, "rest");
    ASSERT_EQ(mesh.cellZones.size(), 1U);
    EXPECT_EQ(mesh.cellZones[0].name, "zone");
}

TEST(BlockMeshDict, isFoundInPolyMeshToo) {
    const TemporaryCase box;
    box.write("constant/polyMesh/blockMeshDict", dictionary);
    ASSERT_EQ(box.run("blockInit").status, 0);
    ASSERT_EQ(box.run("blockInit").status, 0); // the first run has left it there
    EXPECT_EQ(meshOf(box).cellCount, 24);
}

TEST(BlockMeshDict, optionsAndBlockInitDictComeFirst) {
    const TemporaryCase box;
    box.write("system/blockMeshDict", dictionary);
    ASSERT_EQ(box.run("blockInit -box '(0 0 0) (1 1 1)' -cells '(1 1 1)'").status, 0);
    EXPECT_EQ(meshOf(box).cellCount, 1);
    box.write("system/blockInitDict", "box ((0 0 0) (1 1 1)); cells (2 1 1);");
    ASSERT_EQ(box.run("blockInit").status, 0);
    EXPECT_EQ(meshOf(box).cellCount, 2);
    ASSERT_EQ(box.run("blockInit -dict system/blockMeshDict").status, 0);
    EXPECT_EQ(meshOf(box).cellCount, 24);
}

TEST(BlockMeshDict, whatIsWrongIsSaidWithFileLineAndExpectation) {
    struct Wrong {
        std::string text;
        std::string message;
    };

    const std::vector<Wrong> wrong{
        {with("vertices", "vertexes"), "Dict:3: unknown entry vertexes; did you mean vertices?"},
        {with("boundary", "bounadry"), "Dict:6: unknown entry bounadry; did you mean boundary?"},
        {with("0 1 2 3 4", "0 1 2 3"), "Dict:4: blocks: found (0 1 2 3 5 top 7), expected eight"},
        {with("top 7) zone", "top 8) zone"), "Dict:4: blocks: found 8, expected a vertex, from 0"},
        {with("top 7) zone", "tip 7) zone"), "Dict:4: blocks: found tip, expected a vertex"},
        {with("0 1 2 3 4 5 top 7", "4 5 top 7 0 1 2 3"), "Dict:4: this block is inside out"},
        {with("($n 2 4)", "($n 0 4)"), "Dict:4: blocks: found 0, expected a number of cells"},
        {with("($n 2 4)", "($n 2)"), "Dict:4: blocks: found (3 2), expected three numbers"},
        {with("-2 1)", "0 1)"), "Dict:4: blocks: found 0, expected an expansion ratio other"},
        {with("-2 1)", "1e300 1)"), "Dict:4: blocks: found 1e300, expected an expansion ratio"},
        {with("($n 2 4)", "(1000000 1000000 1000000)"), "Dict:4: up to this block there are 1e+18"},
        {with("-2 1)", "-2)"), "expected 3 ratios (simpleGrading) or 12 (edgeGrading)"},
        {with("simpleGrading", "simpelGrading"), "Dict:4: blocks: found simpelGrading, expected"},
        {with("arc 0 1 (0.5 -0.2 0)", "arc 0 1 (2 0 0)"), "Dict:5: the three points of this arc"},
        {with("arc 0 1", "ark 0 1"), "Dict:5: edges: found ark, expected arc, line,"},
        {with("arc 0 1 (0.5 -0.2 0)", "arc 0 1"), "Dict:5: edges: the list ends where a point"},
        {with("type wall", "type walls"), "Dict:6: type: found walls, expected a type of patch;"},
        {with("(0 4 7 3)", "(0 4 7 2)"), "Dict:7: patch sides: (0 4 7 2) is no side of a block"},
        {with("(0 4 7 3)", "(b 4)"), "Dict:7: patch sides: side (0 3 2 1) belongs to patch floor"},
        {with("scale 0.1", "scale 0"), "Dict:2: scale: found 0, expected a positive number"},
        {with("0.2 0) );", "0.2 0) )"), "is not expected after the list; is a ; missing"}};
    const TemporaryCase box;
    for (const Wrong& each : wrong) {
        box.write("system/blockMeshDict", each.text);
        const ProgramResult result = box.run("blockInit");
        EXPECT_EQ(result.status, 2) << each.message;
        EXPECT_NE(result.err.find(each.message), std::string::npos) << result.err;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_FALSE(fs::exists(box.dir() / "constant/polyMesh"));
    }
}

TEST(BlockMeshDict, whatIsNotSupportedIsNamed) {
    const TemporaryCase box;
    const std::vector<std::pair<std::string, std::string>> unsupported{
        {with("arc 0 1 (0.5 -0.2 0)", "projectCurve 0 1 (s)"), "type of edge is not supported"},
        {with("arc 0 1 (0.5 -0.2 0)", "project 0 1 (s t)"), "onto several is not supported"},
        {with("#eval{ 2*$n }", "#codeStream { code #{ #}; }"), "#codeStream is not supported"},
        {std::string("geometry { s { type plane; } }") +
             with("arc 0 1 (0.5 -0.2 0)", "project 0 1 (s)"),
         "projection onto another type is not supported"}};
    for (const auto& [text, message] : unsupported) {
        box.write("system/blockMeshDict", text);
        const ProgramResult result = box.run("blockInit");
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    }
}

/// A few of OpenFOAM's examples, each with its own features; all: benchmarks/compareBlockMesh
TEST(BlockMeshDict, examplesGiveTheMeshOfOpenFoam) {
    const fs::path examples = "/usr/share/doc/openfoam-examples/examples";
    if (!fs::exists("/usr/bin/blockMesh") || !fs::exists(examples))
        GTEST_SKIP() << "OpenFOAM or openfoam-examples is not installed";
    const std::vector<std::string> cases{
        "mesh/blockMesh/sphere",                          // arcs, projected sides
        "multiphase/reactingTwoPhaseEulerFoam/RAS/LBend", // merged patches
        "compressible/rhoCentralFoam/LadenburgJet60psi",  // a wedge, collapsed on its axis
        "compressible/rhoCentralFoam/biconic25-55Run35",  // patches in the old way
        "combustion/XiDyMFoam/oscillatingCylinder"};      // .gz, an arc beyond its end
    for (const std::string& each : cases) {
        const TemporaryCase box;
        box.run(fmt::format("mkdir system; cp -r {}/system/blockMeshDict* system; "
                            "gunzip -f system/*.gz",
                            (examples / each).string()));
        box.write("system/controlDict",
                  "FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }\n"
                  "deltaT 1; endTime 1; writeInterval 1; writeFormat binary;");
        const ProgramResult theirs =
            box.run("WM_PROJECT_DIR=/usr/share/openfoam /usr/bin/blockMesh");
        ASSERT_EQ(theirs.status, 0) << theirs.out << theirs.err;
        const PolyMesh expected = meshOf(box);
        const ProgramResult ours = box.run("blockInit");
        ASSERT_EQ(ours.status, 0) << each << ": " << ours.err;
        const PolyMesh mesh = meshOf(box);
        EXPECT_EQ(mesh.cellCount, expected.cellCount) << each;
        EXPECT_EQ(mesh.neighbour.size(), expected.neighbour.size()) << each;
        ASSERT_EQ(mesh.points.size(), expected.points.size()) << each;
        ASSERT_EQ(mesh.patches.size(), expected.patches.size()) << each;
        for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
            EXPECT_EQ(mesh.patches[p].name, expected.patches[p].name) << each;
            EXPECT_EQ(mesh.patches[p].type, expected.patches[p].type) << each;
            EXPECT_EQ(mesh.patches[p].size, expected.patches[p].size) << each;
        }
        // OpenFOAM numbers merged points in another way
        if (each.ends_with("LBend")) continue;
        double worst = 0;
        for (std::size_t p = 0; p < mesh.points.size(); ++p)
            worst = std::max(worst, norm(mesh.points[p] - expected.points[p]));
        EXPECT_LT(worst, 1e-9 * norm(expected.points.back() - expected.points.front())) << each;
    }
}

} // namespace polymesh::tools
