// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// blockInit on the shorthands of system/blockInitDict.

#include "formats/foam/polyMeshIo.h"
#include "libpolymesh/mesh/validate.h"
#include "tests/tools/program.h"

#include <gtest/gtest.h>

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
        {"cartesian { min (0 0 0); max (1 2 3); cells (2 3 4); grading (2 1 -2); }", 24}};
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
        {std::string(cylinder) + "sphere { }", "Dict:3: cylinder and sphere together are not"},
        {"cylinder 1;", "Dict:1: cylinder: found a value, expected a dictionary"}};
    const TemporaryCase box;
    for (const auto& [text, message] : wrong) {
        box.write("system/blockInitDict", text);
        const ProgramResult result = box.run("blockInit");
        EXPECT_EQ(result.status, 2) << text;
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    }
}

} // namespace polymesh::tools
