// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/polyMeshIo.h"
#include "libpolymesh/initial/cartesian.h"
#include "tests/tools/program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace polymesh::tools {

namespace {

constexpr const char* tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                    "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
constexpr const char* unitBox = "blockInit -box '(0 0 0) (1 2 3)' -cells '(2 3 4)'";

} // namespace

TEST(BlockInit, writesTheBoxThatIsGiven) {
    const TemporaryCase box;
    const ProgramResult result = box.run(unitBox);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(foam::readPolyMesh(box.dir() / "constant/polyMesh"),
              cartesianMesh({{{0, 0, 0}, {1, 2, 3}}, {2, 3, 4}}));
}

TEST(BlockInit, putsABoxRoundASurface) {
    const TemporaryCase box;
    box.write("constant/triSurface/part.obj", tetrahedron);
    EXPECT_EQ(box.run("blockInit -surface part.obj -cellSize 0.25").status, 0);
    const PolyMesh mesh = foam::readPolyMesh(box.dir() / "constant/polyMesh");
    EXPECT_EQ(mesh, cartesianMesh(boxAround({{0, 0, 0}, {1, 1, 1}}, 0.25, defaultMargin(0.25))));
}

TEST(BlockInit, leavesOutWhatIsOutsideOfTheSurface) {
    const TemporaryCase box;
    box.write("constant/triSurface/part.obj", tetrahedron);
    ASSERT_EQ(box.run("blockInit -surface part.obj -cellSize 0.05").status, 0);
    const Label whole = foam::readPolyMesh(box.dir() / "constant/polyMesh").cellCount;
    const ProgramResult result =
        box.run("blockInit -surface part.obj -cellSize 0.05 -inside -json r");
    ASSERT_EQ(result.status, 0) << result.err;
    const PolyMesh mesh = foam::readPolyMesh(box.dir() / "constant/polyMesh");
    EXPECT_LT(mesh.cellCount, whole / 2); // the part is a sixth of its box
    EXPECT_EQ(mesh.patches.back().name, "outside");
    const auto report = nlohmann::json::parse(box.read("r"));
    EXPECT_EQ(report["leftOut"], whole - mesh.cellCount);
    EXPECT_EQ(report["cells"], mesh.cellCount);
    EXPECT_EQ(box.run("checkMesh -allTopology").status, 0);
}

TEST(BlockInit, refusesInsideWithoutASurfaceOrWithRefinement) {
    const TemporaryCase box;
    box.write("constant/triSurface/part.obj", tetrahedron);
    for (const char* command : {"blockInit -box '(0 0 0) (1 2 3)' -cells '(2 3 4)' -inside",
                                "blockInit -surface part.obj -cellSize 0.2 -level 1 -inside"}) {
        const ProgramResult result = box.run(command);
        EXPECT_EQ(result.status, 2) << command;
        EXPECT_NE(result.err.find("-inside: is for a box of equal cells"), std::string::npos)
            << result.err;
    }
}

TEST(BlockInit, readsItsDictionaryAndOptionsWin) {
    const TemporaryCase box;
    box.write("system/blockInitDict",
              "FoamFile { format ascii; class dictionary; }\nn 3;\n#remove n\n"
              "box ((0 0 0) (1 2 3)); // [m]\ncells (2 3 4);\n");
    ASSERT_EQ(box.run("blockInit").status, 0);
    EXPECT_EQ(foam::readPolyMesh(box.dir() / "constant/polyMesh"),
              cartesianMesh({{{0, 0, 0}, {1, 2, 3}}, {2, 3, 4}}));
    ASSERT_EQ(box.run("blockInit -cells '(1 1 1)'").status, 0);
    EXPECT_EQ(foam::readPolyMesh(box.dir() / "constant/polyMesh").cellCount, 1);
    box.write("constant/triSurface/part.obj", tetrahedron);
    ASSERT_EQ(box.run("blockInit -surface part.obj -cellSize 1").status, 0);
    EXPECT_EQ(foam::readPolyMesh(box.dir() / "constant/polyMesh").cellCount, 8);
}

TEST(BlockInit, wrongDictionaryEntryNamesFileLineAndNearest) {
    const TemporaryCase box;
    box.write("system/blockInitDict", "box ((0 0 0) (1 1 1));\ncels (1 1 1);\n");
    const ProgramResult misspelt = box.run("blockInit");
    EXPECT_EQ(misspelt.status, 2);
    EXPECT_NE(misspelt.err.find("blockInitDict:2: cels"), std::string::npos) << misspelt.err;
    EXPECT_NE(misspelt.err.find("nearest is cells"), std::string::npos) << misspelt.err;
    box.write("other", "box ((0 0 0) (1 1 1));\n\ncells (1 1 x);\n");
    const ProgramResult wrong = box.run("blockInit -dict other");
    EXPECT_EQ(wrong.status, 2);
    EXPECT_NE(wrong.err.find("other:3: cells: 'x' is not"), std::string::npos) << wrong.err;
    EXPECT_EQ(box.run("blockInit -dict missing").status, 2);
}

TEST(BlockInit, writesWhatControlDictAsksForUnlessTold) {
    const TemporaryCase box;
    box.write("system/controlDict", "writeFormat ascii; writeCompression on;");
    ASSERT_EQ(box.run(unitBox).status, 0);
    EXPECT_TRUE(std::filesystem::exists(box.dir() / "constant/polyMesh/points.gz"));
    ASSERT_EQ(box.run(std::string(unitBox) + " -format binary").status, 0);
    EXPECT_NE(box.read("constant/polyMesh/points").find("binary"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(box.dir() / "constant/polyMesh/points.gz"));
}

TEST(BlockInit, reportsInJson) {
    const TemporaryCase box;
    EXPECT_EQ(box.run(std::string(unitBox) + " -json report.json -quiet").out, "");
    const auto report = nlohmann::json::parse(box.read("report.json"));
    EXPECT_EQ(report["cells"], 24);
    EXPECT_GT(report["peakMemoryBytes"], 100000);
    EXPECT_GE(report["wallSeconds"], report["stages"][0]["seconds"]);
}

TEST(BlockInit, writesTheSameBytesWithAnyNumberOfThreads) {
    const TemporaryCase box;
    const auto sumOfFiles = [&](const char* format, int threads) {
        return box.run(fmt::format("blockInit -box '0 0 0 1 1 1' -cells '(50 60 70)' -quiet "
                                   "-format {} -threads {} && cat constant/polyMesh/* | cksum",
                                   format,
                                   threads));
    };
    for (const char* format : {"binary", "ascii"}) {
        const ProgramResult one = sumOfFiles(format, 1);
        EXPECT_EQ(one.status, 0) << one.err;
        EXPECT_EQ(one.out, sumOfFiles(format, 2).out);
        EXPECT_EQ(one.out, sumOfFiles(format, 8).out);
    }
}

TEST(BlockInit, wrongUseIsStatus2WithOneLineAndKeepsTheOldMesh) {
    const TemporaryCase box;
    box.write("notASurface.stl", "nonsense");
    ASSERT_EQ(box.run(unitBox).status, 0);
    const PolyMesh old = foam::readPolyMesh(box.dir() / "constant/polyMesh");
    for (const char* command : {"blockInit",
                                "blockInit -surface missing.stl -cellSize 1",
                                "blockInit -surface notASurface.stl -cellSize 1",
                                "blockInit -box '(0 0 0) (1 1 1)'",
                                "blockInit -box '(0 0 0) (1 1 0)' -cells '(1 1 1)'",
                                "blockInit -box '(0 0 0) (1 1 1)' -cells '(1 1 0)'",
                                "blockInit -box '(0 0 0) (1 1 1)' -cells '(1 1 1.5)'",
                                "blockInit -box '(0 0 0) (1 1 1)' -cells '(1e9 1e9 1e9)'",
                                "blockInit -case nowhere -box '0 0 0 1 1 1' -cells '1 1 1'",
                                "blockInit -box '0 0 0 1 1 1' -cells '1 1 1' -format asci",
                                "blockInit -box '0 0 0 1 1 1' -cells '1 1 1' -threads 0",
                                "blockInit -cels '(1 1 1)'"}) {
        const ProgramResult result = box.run(command);
        EXPECT_EQ(result.status, 2) << command;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        EXPECT_TRUE(result.err.starts_with("blockInit: ")) << result.err;
    }
    EXPECT_EQ(foam::readPolyMesh(box.dir() / "constant/polyMesh"), old);
}

TEST(BlockInit, fullDiskIsStatus1) {
    const TemporaryCase box;
    const ProgramResult result = box.run(std::string(unitBox) + " -json /dev/full/x");
    EXPECT_EQ(result.status, 1);
    EXPECT_TRUE(result.err.starts_with("blockInit: ")) << result.err;
    EXPECT_EQ(box.run(std::string(unitBox) + " > /dev/full").status, 1);
}

} // namespace polymesh::tools
