// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/polyMeshIo.h"
#include "libpolymesh/mesh/validate.h"
#include "tests/tools/program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace polymesh::tools {

namespace {

constexpr const char* tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                    "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

void expectValidMesh(const TemporaryCase& box) {
    const auto defects = validate(foam::readPolyMesh(box.dir() / "constant/polyMesh"));
    EXPECT_TRUE(defects.empty()) << defects.front().message;
}

/// blockInit with this dictionary fails with status 2, says all of it in one line, and leaves the
/// mesh that is there.
void expectRefused(const std::string& dictionary, const std::vector<std::string>& said) {
    const TemporaryCase box;
    box.write("part.obj", tetrahedron);
    box.write("open.obj", std::string(tetrahedron).substr(0, std::string(tetrahedron).rfind('f')));
    box.write("constant/polyMesh/points", "old");
    box.write("system/blockInitDict",
              "box ((0 0 0) (1 1 1)); cells (2 2 2);\nrefinement\n" + dictionary);
    const ProgramResult result = box.run("blockInit");
    EXPECT_EQ(result.status, 2) << dictionary;
    for (const std::string& text : said)
        EXPECT_NE(result.err.find(text), std::string::npos) << text << " in " << result.err;
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    EXPECT_EQ(box.read("constant/polyMesh/points"), "old");
}

} // namespace

TEST(BlockRefine, refinesNearASurfaceAndWritesLevels) {
    const TemporaryCase box;
    box.write("part.obj", tetrahedron);
    const ProgramResult result =
        box.run("blockInit -surface part.obj -cellSize 0.25 -level 2 -json r.json -format ascii");
    ASSERT_EQ(result.status, 0) << result.err;
    expectValidMesh(box);
    const auto report = nlohmann::json::parse(box.read("r.json"));
    EXPECT_EQ(report["initialCells"], 125);
    EXPECT_EQ(report["cellsOfLevel"].size(), 3);
    EXPECT_GT(report["cellsOfLevel"][2], 8 * 30);
    EXPECT_NE(box.read("constant/polyMesh/cellLevel").find("class       labelList"),
              std::string::npos);
    EXPECT_NE(box.read("constant/polyMesh/pointLevel").find("labelList"), std::string::npos);
    const std::string edge = box.read("constant/polyMesh/level0Edge");
    EXPECT_NE(edge.find("class       uniformDimensionedScalarField"), std::string::npos) << edge;
    EXPECT_NE(edge.find("value           0.25;"), std::string::npos) << edge;
}

TEST(BlockRefine, readsRegionsAndSetsOfTheDictionary) {
    const TemporaryCase box;
    box.write("system/blockInitDict", "box ((0 0 0) (4 4 4)); cells (4 4 4);\n");
    ASSERT_EQ(box.run("blockInit").status, 0);
    box.write("constant/polyMesh/sets/mine",
              "FoamFile { version 2.0; format ascii; class cellSet; object mine; }\n1(63)\n");
    box.write("system/blockInitDict",
              "box ((0 0 0) (4 4 4)); cells (4 4 4);\n"
              "refinement { regions { low { type sphere; centre (0 0 0); radius 0.1; level 1; } }\n"
              "             cellSets { mine { level 1; } } }\n");
    ASSERT_EQ(box.run("blockInit -json r.json").status, 0);
    EXPECT_EQ(nlohmann::json::parse(box.read("r.json"))["cellsOfLevel"],
              (std::vector<int>{62, 16}));
    expectValidMesh(box);
}

TEST(BlockRefine, refinesBlocksOfBlockMeshDictAndShorthands) {
    const TemporaryCase box;
    box.write(
        "system/blockInitDict",
        "cylinder { point1 (0 0 0); point2 (0 0 1); radius 1; cells (2 8 2); }\n"
        "refinement { regions { a { type sphere; centre (1 0 0); radius 0.1; level 2; } } }\n");
    ASSERT_EQ(box.run("blockInit -json r.json").status, 0);
    EXPECT_EQ(nlohmann::json::parse(box.read("r.json"))["cellsOfLevel"].size(), 3);
    expectValidMesh(box);
    // Only the refinement here, the blocks as OpenFOAM has them.
    box.write(
        "system/blockInitDict",
        "refinement { regions { a { type sphere; centre (1 0 0); radius 0.1; level 1; } } }\n");
    box.write(
        "system/blockMeshDict",
        "vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));\n"
        "blocks (hex (0 1 2 3 4 5 6 7) (2 2 2) simpleGrading (1 1 1)); edges (); boundary ();\n");
    const ProgramResult result = box.run("blockInit -json r.json");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(nlohmann::json::parse(box.read("r.json"))["cellsOfLevel"], (std::vector<int>{7, 8}));
    expectValidMesh(box);
}

TEST(BlockRefine, refusesWrongDictionariesByPlace) {
    expectRefused("{ surface { } }", {"blockInitDict:3", "surface", "surfaces"});
    expectRefused("{ surfaces { part.obj { levl 2; } } }", {"blockInitDict:3", "levl", "level"});
    expectRefused("{ surfaces { part.obj { level -1; } } }", {"blockInitDict:3: level", "-1"});
    expectRefused("{ surfaces { part.obj { level 99; } } }", {"blockInitDict:3: level", "11"});
    expectRefused("{ surfaces { part.obj { levels ((1 2 3)); } } }", {"blockInitDict:3: levels"});
    expectRefused("{ surfaces { part.obj { levels ((-1 2)); } } }", {"blockInitDict:3: levels"});
    expectRefused("{ surfaces { part.obj { levels (); } } }", {"blockInitDict:3: levels", "pair"});
    expectRefused("{ surfaces { part.obj { level nan; } } }", {"blockInitDict:3: level", "nan"});
    expectRefused("{ surfaces { part.obj { } } }", {"blockInitDict:3: part.obj: says nothing"});
    expectRefused("{ surfaces { part.obj { regions { part { } } } } }",
                  {"blockInitDict:3: part: says nothing", "level, levels"});
    expectRefused("{ surfaces {\n gone.obj { level 1; } } }", {"blockInitDict:4", "gone.obj"});
    expectRefused("{ surfaces { part.obj { regions { prt { level 1; } } } } }",
                  {"blockInitDict:3", "prt", "nearest is 'part'"});
    expectRefused("{ surfaces { part.obj { curvature { cellsPerRadius 0; level 1; } } } }",
                  {"blockInitDict:3: cellsPerRadius", "positive"});
    expectRefused("{ surfaces { part.obj { features { angle 200; level 1; } } } }",
                  {"blockInitDict:3: angle", "180"});
    expectRefused("{ surfaces { part.obj { gaps { cells 3; } } } }", {"blockInitDict:3", "level"});
    expectRefused("{ regions { a { type bax; level 1; } } }", {"blockInitDict:3: type", "box"});
    expectRefused("{ regions { a { type box; min (0 0 0); max (1 0 1); level 1; } } }",
                  {"blockInitDict:3: max"});
    expectRefused("{ regions { a { type sphere; centre (0 0 0); radius -1; level 1; } } }",
                  {"blockInitDict:3: radius"});
    expectRefused("{ regions { a { type box; mode inner; level 1; min (0 0 0); max (1 1 1); } } }",
                  {"blockInitDict:3: mode", "inside"});
    expectRefused("{ regions { a { type surface; file open.obj; level 1; } } }",
                  {"blockInitDict:3: file", "closed surface; 3 edges"});
    expectRefused("{ cellSets { gone { level 1; } } }", {"blockInitDict:3", "gone"});
    expectRefused("{ nCellsBetweenLevels 0; }", {"blockInitDict:3: nCellsBetweenLevels"});
    expectRefused("{ regions 5; }", {"blockInitDict:3", "regions"});
    expectRefused("7;", {"blockInitDict:2", "refinement"});
}

TEST(BlockRefine, refusesWrongOptions) {
    const TemporaryCase box;
    box.write("part.obj", tetrahedron);
    const std::string surface = "blockInit -surface part.obj -cellSize 0.5 ";
    for (const std::string wrong : {"-level 1.5",
                                    "-level -1",
                                    "-level 12",
                                    "-levels '(1 2 3)'",
                                    "-levels '(-1 2)'",
                                    "-curvature '(1)'",
                                    "-curvature '(0 2)'",
                                    "-level 1 -nCellsBetweenLevels 0"}) {
        const ProgramResult result = box.run(surface + wrong);
        EXPECT_EQ(result.status, 2) << wrong;
        EXPECT_NE(result.err.find("option -"), std::string::npos) << result.err;
    }
}

} // namespace polymesh::tools
