// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// blockInit on the shorthands of system/blockInitDict.

#include "formats/foam/polyMeshIo.h"
#include "libpolymesh/mesh/validate.h"
#include "tests/tools/program.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polymesh::tools {

namespace {

constexpr const char* cylinder = "cylinder { point1 (0 0 0); point2 (0 0 2); radius 1;\n"
                                 "cells (3 16 4); grading (0.5 ((1 1 2) (1 1 -2))); }\n";

PolyMesh meshOf(const TemporaryCase& box) {
    return foam::readPolyMesh(box.dir() / "constant/polyMesh");
}

} // namespace

TEST(Shorthands, makeBlocks) {
    const TemporaryCase box;
    const std::vector<std::pair<std::string, Label>> shorthands{
        {cylinder, (3 * 16 + 16) * 4},
        {"cylinder { point1 (0 0 0); point2 (0 0 2); radius 1; holeRadius 0.5; cells (3 16 4); }",
         3 * 16 * 4},
        {"cylinder { point1 (0 0 0); point2 (0 0 2); radius 1; angle 5; cells (3 1 4); }", 3 * 4},
        {"sphere { centre (1 2 3); radius 2; cells (3 4); }", 6 * 3 * 16 + 64},
        {"cartesian { min (0 0 0); max (1 2 3); cells (2 3 4); grading (2 1 -2); }", 24},
        {"extrude { points ((0 0 0) (1 0 0) (1 1 0) (0 1 0)); quads ((0 1 2 3)); vector (0 0 1);\n"
         "cells (2 3); layers 4; grading 2; }",
         24},
        {"cartesian { min (-1 -1 2); max (1 1 4); cells (1 1 1); }\n"
         "extrude { points ((-1 -1 4) (1 -1 4) (1 1 4) (-1 1 4)); quads ((0 1 2 3)); "
         "vector (1 0 1); }",
         2},
        {"parts ( cartesian { min (0 0 0); max (1 1 1); cells (2 2 2); }\n"
         "cartesian { min (1 0 0); max (2 1 1); cells (2 2 2); } );",
         16}};
    for (const auto& [text, cells] : shorthands) {
        box.write("system/blockInitDict", text);
        const ProgramResult result = box.run("blockInit");
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(meshOf(box).cellCount, cells) << text;
        EXPECT_TRUE(validate(meshOf(box)).empty()) << text;
    }
}

TEST(Shorthands, optionsWin) {
    const TemporaryCase box;
    box.write("system/blockInitDict", cylinder);
    ASSERT_EQ(box.run("blockInit -box '(0 0 0) (1 1 1)' -cells '(1 1 1)'").status, 0);
    EXPECT_EQ(meshOf(box).cellCount, 1);
}

TEST(Shorthands, whatIsWrongIsSaidWithFileAndLine) {
    const std::string begin = "cylinder { point1 (0 0 0); point2 (0 0 2); radius 1;\n";
    const std::string sheet = "extrude { points ((0 0 0) (1 0 0) (1 1 0) (0 1 0));\n";
    const std::vector<std::pair<std::string, std::string>> wrong{
        {begin + "cels (3 16 4); }", "Dict:2: unknown key 'cels'; did you mean 'cells'?"},
        {begin + "cells (3 16); }", "Dict:2: cells: found (3 16), expected three numbers"},
        {begin + "cells (3 15 4); }", "Dict:2: cells: found 15 around, expected a multiple of 4"},
        {begin + "cells (0 16 4); }", "Dict:2: cells: found 0, expected a number of cells"},
        {begin + "cells (3 16 4); holeRadius 1; }", "Dict:2: holeRadius: found 1, expected"},
        {begin + "cells (3 16 4); angle 360; }", "Dict:2: angle: found 360, expected a number"},
        {begin + "cells (3 16 4); grading (0 1); }", "Dict:2: grading: found 0, expected an"},
        {"sphere { centre (0 0 0); radius -1; cells (1 1); }", "Dict:1: radius: found -1"},
        {"sphere { centre (0 0 0); cells (1 1); }", "Dict:1: sphere.radius is missing"},
        {"cartesian { min (0 0 0); max (1 1 0); cells (1 1 1); }", "Dict:1: max: found (1 1 0)"},
        {begin + "cells (3 16 4); patches { sides pipe; } }", "Dict:2: patches: there is no patch"},
        {std::string(cylinder) + cylinder, "Dict:3: there is another cylinder at line 1; several"},
        {std::string(cylinder) + "sphre { }", "Dict:3: unknown entry sphre; did you mean sphere?"},
        {std::string(cylinder) + "refinemnt { }", "Dict:3: unknown entry refinemnt; did you mean"},
        {"spere { centre (0 0 0); }", "Dict:1: spere: unknown entry; the nearest is sphere"},
        {"parts ( cylinder { } );", "is missing"},
        {"parts ( box { } );", "Dict:1: parts: found box, expected one of: cartesian, cylinder"},
        {"parts ( );", "Dict:1: parts: the list is empty"},
        {std::string(cylinder) + "cartesian { min (0 0 1); max (1 1 2); cells (1 1 1); }",
         "Dict:3: overlaps the part at"},
        {sheet + "quads ((0 1 2 3)); vector (0 0 0); }", "Dict:2: vector: found (0 0 0), expected"},
        {sheet + "quads ((0 1 2 4)); vector (0 0 1); }",
         "Dict:2: quads: found 4, expected a point"},
        {sheet + "quads ((0 1 2)); vector (0 0 1); }",
         "Dict:2: quads: found (0 1 2), expected four"},
        {sheet + "quads ((0 2 1 3)); vector (0 0 1); }",
         "Dict:2: the quadrilateral (0 2 1 3) near"},
        {sheet + "quads ((0 1 2 3)); }", "extrude.vector is missing"},
        {sheet + "quads ((0 1 2 3)); vector (0 0 1); layers 0; }", "Dict:2: layers: found 0"},
        {sheet + "quads ((0 1 2 3)); vector (0 0 1); grading 0; }", "Dict:2: grading: found 0"},
        {sheet + "patch xMin; vector (0 0 1); }", "Dict:1: extrude: found 2 sheets, expected one"},
        {"cylinder 1;", "Dict:1: cylinder: found a value, expected a dictionary"}};
    const TemporaryCase box;
    for (const auto& [text, message] : wrong) {
        box.write("system/blockInitDict", text);
        const ProgramResult result = box.run("blockInit");
        EXPECT_EQ(result.status, 2) << text;
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    }
}

TEST(Shorthands, givePatchesOtherNamesAndTypesAndCellsAZone) {
    const TemporaryCase box;
    box.write("system/blockInitDict",
              "cartesian { min (0 0 0); max (1 1 1); cells (2 2 2); zone middle;\n"
              "patches { xMin xMax; xMax { name xMin; type wall; } yMin rest; yMax rest; } }");
    ASSERT_EQ(box.run("blockInit").status, 0);
    const PolyMesh mesh = meshOf(box);
    std::vector<std::string> names;
    for (const Patch& patch : mesh.patches)
        names.push_back(patch.type + " " + patch.name);
    EXPECT_EQ(names,
              (std::vector<std::string>{
                  "patch xMax", "wall xMin", "patch rest", "patch zMin", "patch zMax"}));
    EXPECT_EQ(mesh.points[index(mesh.faces[mesh.patches[0].start][0])].x, 0);
    EXPECT_EQ(mesh.patches[2].size, 8);
    ASSERT_EQ(mesh.cellZones.size(), 1U);
    EXPECT_EQ(mesh.cellZones[0].labels.size(), 8U);
}

TEST(Shorthands, extrudePatchesAndSurfacesOfQuadrilaterals) {
    const TemporaryCase box;
    ASSERT_EQ(box.run("blockInit -box '(0 0 0) (1 1 1)' -cells '(2 3 4)'").status, 0);
    box.write("system/blockInitDict", "extrude { patch zMax; vector (0 1 1); layers 5; }");
    ASSERT_EQ(box.run("blockInit").status, 0);
    EXPECT_EQ(meshOf(box).cellCount, 2 * 3 * 5);
    EXPECT_TRUE(validate(meshOf(box)).empty());
    const ProgramResult unknown = box.run("blockInit");
    EXPECT_EQ(unknown.status, 2);
    EXPECT_NE(unknown.err.find("Dict:1: patch: found zMax, expected a patch of"), std::string::npos)
        << unknown.err;

    box.write("constant/triSurface/sheet.obj",
              "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5\n");
    box.write("system/blockInitDict", "extrude { surface sheet.obj; vector (0 0 1); layers 2; }");
    ASSERT_EQ(box.run("blockInit").status, 0);
    EXPECT_EQ(meshOf(box).cellCount, 4);
    box.write("constant/triSurface/sheet.obj",
              "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 4\nf 2 3 4\n");
    const ProgramResult triangles = box.run("blockInit");
    EXPECT_EQ(triangles.status, 2);
    EXPECT_NE(triangles.err.find("face 0: is no quadrilateral"), std::string::npos)
        << triangles.err;
}

} // namespace polymesh::tools
