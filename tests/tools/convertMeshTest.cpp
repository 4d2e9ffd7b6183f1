// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/polyMeshIo.h"
#include "formats/surfaceIo.h"
#include "libpolymesh/mesh/validate.h"
#include "tests/formats/star/starTestSupport.h"
#include "tests/support/surfaces.h"
#include "tests/tools/program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace polymesh::tools {

namespace {

namespace fs = std::filesystem;

constexpr const char* controlDict =
    "FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }\n"
    "application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;\n"
    "writeControl timeStep; writeInterval 1; writeFormat binary;\n";

/// Several cases and STAR-CD files side by side.
class Workshop : public TemporaryCase {
public:
    void addCase(const std::string& name, const PolyMesh& mesh) const {
        addEmptyCase(name);
        foam::writePolyMesh(mesh, dir() / name / "constant/polyMesh", {});
    }

    void addEmptyCase(const std::string& name) const {
        write(fs::path(name) / "system/controlDict", controlDict);
        for (const char* file : {"fvSchemes", "fvSolution"})
            write(fs::path(name) / "system" / file,
                  "FoamFile { version 2.0; format ascii; class dictionary; object fv; }\n"
                  "gradSchemes {} divSchemes {} laplacianSchemes {}\n");
    }

    /// A case with the mesh that trimming a box by a sphere gives: cells of many kinds.
    PolyMesh addTrimmedCase(const std::string& name) const {
        addEmptyCase(name);
        fs::create_directories(dir() / name / "constant/triSurface");
        writeSurface(test::sphere(3, 0.4, {0.5, 0.5, 0.5}),
                     dir() / name / "constant/triSurface/ball.obj");
        const ProgramResult result =
            run("blockInit -case " + name + " -box '0 0 0 1 1 1' -cells '9 9 9' -quiet && " +
                "trimSurface -case " + name + " -surface ball.obj -quiet");
        EXPECT_EQ(result.status, 0) << result.err;
        return meshOf(name);
    }

    PolyMesh meshOf(const std::string& name) const {
        return foam::readPolyMesh(dir() / name / "constant/polyMesh");
    }

    void expectSuccess(const std::string& command) const {
        const ProgramResult result = run(command);
        EXPECT_EQ(result.status, 0) << command << "\n" << result.out << result.err;
    }

    /// What OpenFOAM's checkMesh says of a case, from the counts on, without names of patches.
    std::string verdict(const std::string& name) const {
        run("WM_PROJECT_DIR=/usr/share/openfoam /usr/bin/checkMesh -allTopology -case " + name +
            " | sed -n '/^Mesh stats/,/^End/p' | sed 's/^ *[a-z_0-9]* *\\([0-9]* *[0-9]* "
            "*ok\\)/\\1/'");
        return read(".out");
    }
};

bool hasOpenFoam() {
    return fs::exists("/usr/bin/star4ToFoam") && fs::exists("/usr/bin/foamToStarMesh");
}

constexpr const char* openFoam = "WM_PROJECT_DIR=/usr/share/openfoam /usr/bin/";

/// The same cells, faces and patches, whatever the names and types of the patches are.
void expectSameButForNames(const PolyMesh& a, PolyMesh b, double tolerance) {
    ASSERT_EQ(a.patches.size(), b.patches.size());
    for (std::size_t p = 0; p < a.patches.size(); ++p) {
        b.patches[p].name = a.patches[p].name;
        b.patches[p].type = a.patches[p].type;
        b.patches[p].entries = a.patches[p].entries;
    }
    b.cellZones = a.cellZones;
    star::test::expectSameMesh(a, b, tolerance);
}

bool isOneLine(const std::string& text) {
    return std::ranges::count(text, '\n') == 1;
}

} // namespace

TEST(ConvertMesh, takesAMeshThroughBothVersionsAndBack) {
    const Workshop shop;
    PolyMesh mesh = test::jittered(test::box(5, 4, 3, {0.5, 0.4, 0.3}), 0.02);
    mesh.patches[0].name = "inlet";
    mesh.patches[1].type = "wall";
    mesh.patches[2].type = "symmetryPlane";
    mesh.cellZones = {{"rotor", {0, 7, 8}, {}}, {"heater", {20, 21}, {}}};
    shop.addCase("first", mesh);
    shop.expectSuccess("convertMesh first part4 && convertMesh part4 second && "
                       "convertMesh second part3 -to star3 && convertMesh part3 third");
    star::test::expectSameMesh(mesh, shop.meshOf("second"), 1e-15);
    star::test::expectSameMesh(mesh, shop.meshOf("third"), 1e-11);
    EXPECT_NEAR(test::volumeOf(shop.meshOf("third")), test::volumeOf(mesh), 1e-11);
}

TEST(ConvertMesh, takesATrimmedAndSplitMeshThroughBothVersions) {
    const Workshop shop;
    shop.addTrimmedCase("first");
    shop.expectSuccess("classifyCells -case first -split && convertMesh first part4 && "
                       "convertMesh part4 second && convertMesh second part3 -to star3 && "
                       "convertMesh part3 third");
    const PolyMesh mesh = shop.meshOf("first");
    const PolyMesh third = shop.meshOf("third");
    EXPECT_EQ(test::differenceOf(mesh, shop.meshOf("second"), 1e-15), "");
    EXPECT_EQ(test::differenceOf(mesh, third, 1e-9), "");
    EXPECT_EQ(mesh.patches, third.patches);
    EXPECT_NEAR(test::volumeOf(mesh), test::volumeOf(third), 1e-9);
    EXPECT_NE(shop.read("part3.cel").find("   -1\n"), std::string::npos) << "trimmed cells";
}

TEST(ConvertMesh, reportsWhatItDid) {
    const Workshop shop;
    PolyMesh mesh = test::box(2, 2, 2);
    mesh.faceZones = {{"inner", {0}, {false}}};
    shop.addCase("a", mesh);
    shop.write("a/constant/polyMesh/sets/some", "");
    const ProgramResult result = shop.run("convertMesh a part.cel -json report.json");
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.out.find("written    part (star4)"), std::string::npos) << result.out;
    EXPECT_NE(result.err.find("convertMesh: note: face zone inner (1 faces) is left out"),
              std::string::npos)
        << result.err;
    const auto report = nlohmann::json::parse(shop.read("report.json"));
    EXPECT_EQ(report["cells"], 8);
    EXPECT_EQ(report["scale"], 1000);
    EXPECT_EQ(report["notes"].size(), 2);
}

TEST(ConvertMesh, scalesAsAskedAndConvertsBetweenVersions) {
    const Workshop shop;
    shop.addCase("a", test::box(2, 2, 2));
    shop.expectSuccess("convertMesh a part -scale 2 && convertMesh part part3 -to star3 && "
                       "convertMesh -in part3 -out b -from star3 -to foam");
    EXPECT_NEAR(test::volumeOf(shop.meshOf("b")), 8e-9, 1e-20) << "version 4 is in mm";
    shop.expectSuccess("convertMesh a c -to foam -scale 3 && convertMesh part again -to star4");
    EXPECT_NEAR(test::volumeOf(shop.meshOf("c")), 27, 1e-12);
    EXPECT_EQ(shop.read("part.cel"), shop.read("again.cel"));
    EXPECT_EQ(shop.read("part.vrt"), shop.read("again.vrt"));
}

TEST(ConvertMesh, star4ToFoamReadsOurFiles) {
    if (!hasOpenFoam()) GTEST_SKIP() << "OpenFOAM is not installed";
    const Workshop shop;
    const PolyMesh mesh = shop.addTrimmedCase("ours");
    shop.addEmptyCase("theirs");
    // star4ToFoam of v1912 has an option -scale, but takes the coordinates as they are.
    shop.expectSuccess("convertMesh ours part -scale 1 && " + std::string(openFoam) +
                       "star4ToFoam -case theirs part");
    expectSameButForNames(mesh, shop.meshOf("theirs"), 0);
    const std::string verdict = shop.verdict("ours");
    EXPECT_NE(verdict.find("Mesh OK."), std::string::npos) << verdict;
    EXPECT_EQ(verdict, shop.verdict("theirs"));
}

TEST(ConvertMesh, readsTheFilesOfFoamToStarMesh) {
    if (!hasOpenFoam()) GTEST_SKIP() << "OpenFOAM is not installed";
    const Workshop shop;
    PolyMesh mesh = shop.addTrimmedCase("ours");
    shop.expectSuccess("cd ours && " + std::string(openFoam) + "foamToStarMesh && cd .. && " +
                       "convertMesh ours/meshExport back");
    expectSameButForNames(mesh, shop.meshOf("back"), 1e-9); // it writes ten digits
    EXPECT_TRUE(shop.meshOf("back").cellZones.empty());
    mesh.cellZones = {{"some", {1, 2, 3}, {}}};
    shop.addCase("zoned", mesh);
    shop.expectSuccess("cd zoned && " + std::string(openFoam) + "foamToStarMesh && cd .. && " +
                       "convertMesh zoned/meshExport zonedBack");
    const PolyMesh back = shop.meshOf("zonedBack");
    ASSERT_EQ(back.cellZones.size(), 2) << "foamToStarMesh numbers the rest as a zone, too";
    EXPECT_EQ(back.cellZones[0].labels, mesh.cellZones[0].labels);
}

TEST(ConvertMesh, refusesVersion3ForCellsThatItHasNot) {
    const Workshop shop;
    shop.addCase("a", test::hangingNodes());
    shop.write("part.cel", "old");
    const ProgramResult result = shop.run("convertMesh a part -to star3");
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err,
              "convertMesh: 1 of 5 cells are no shape that STAR-CD version 3 has; divide them with "
              "classifyCells -split, or write version 4 (-to star4)\n");
    EXPECT_EQ(shop.read("part.cel"), "old");
    EXPECT_FALSE(fs::exists(shop.dir() / "part.vrt"));
}

TEST(ConvertMesh, refusesWhatItCannotRead) {
    const Workshop shop;
    shop.addCase("a", test::box(1, 1, 1));
    shop.addCase("open", test::openCell());
    shop.addEmptyCase("empty");
    shop.expectSuccess(
        "convertMesh a part && cp part.vrt cut.vrt && head -c 55 part.cel > cut.cel");
    const std::map<std::string, std::string> failures{
        {"convertMesh", "convertMesh: two names are needed: convertMesh IN OUT"},
        {"convertMesh a", "convertMesh: two names are needed"},
        {"convertMesh a b c", "convertMesh: unexpected word 'c'"},
        {"convertMesh nowhere b", "convertMesh: option -in: nowhere: neither a case directory nor"},
        {"convertMesh empty b", "convertMesh: empty/constant/polyMesh"},
        {"convertMesh a b -to star5", "convertMesh: option -to: 'star5': expected one of foam"},
        {"convertMesh a b -scale 0", "convertMesh: option -scale: 0 is out of range"},
        {"convertMesh part b -from star3", "convertMesh: part.vrt:1: the header of version 4"},
        {"convertMesh cut b", "convertMesh: cut.cel:4: "},
        {"convertMesh open b -to star4", "convertMesh: open: cell 0 is open"}};
    for (const auto& [command, message] : failures) {
        const ProgramResult result = shop.run(command);
        EXPECT_EQ(result.status, 2) << command << result.err;
        EXPECT_TRUE(result.err.starts_with(message)) << command << "\n" << result.err;
        EXPECT_TRUE(isOneLine(result.err)) << result.err;
    }
    EXPECT_FALSE(fs::exists(shop.dir() / "b"));
    EXPECT_FALSE(fs::exists(shop.dir() / "b.cel"));
}

/// A set of files in which one line is another, and what convertMesh says of it.
struct HostileFile {
    std::string name;
    std::size_t line = 0; // from 1; 0: after the last one
    std::string text;     // in place of the line
    std::string message;
};

std::string withLine(const std::string& text, std::size_t line, const std::string& other) {
    if (line == 0) return text + other;
    std::size_t first = 0;
    for (std::size_t i = 1; i < line; ++i)
        first = text.find('\n', first) + 1;
    return text.substr(0, first) + other + text.substr(text.find('\n', first));
}

void expectRefused(const Workshop& shop, const HostileFile& hostile) {
    const std::string before = shop.read(hostile.name);
    shop.write(hostile.name, withLine(before, hostile.line, hostile.text));
    const ProgramResult result = shop.run("convertMesh " + hostile.name.substr(0, 2) + " b");
    EXPECT_EQ(result.status, 2) << hostile.message;
    EXPECT_TRUE(result.err.starts_with("convertMesh: " + hostile.message)) << result.err;
    EXPECT_TRUE(isOneLine(result.err)) << result.err;
    EXPECT_FALSE(fs::exists(shop.dir() / "b"));
    shop.write(hostile.name, before);
}

TEST(ConvertMesh, refusesHostileFilesOfVersion4InOneLine) {
    const Workshop shop;
    shop.addCase("a", test::box(2, 1, 1));
    shop.expectSuccess("convertMesh a p4");
    std::string baffles;
    for (int i = 3; i < 2'000'003; ++i)
        fmt::format_to(std::back_inserter(baffles), "{0} 3 4 1 3\n {0} 2 5 11 8\n", i);
    const std::vector<HostileFile> hostile{
        {"p4.vrt", 1, "PROSTAR_CELL", "p4.vrt:1: expected 'PROSTAR_VERTEX', found 'PROSTAR_CELL'"},
        {"p4.vrt",
         6,
         "4 0.0 1000.0",
         "p4.vrt:6: '4 0.0 1000.0': expected a positive vertex number"},
        {"p4.cel", 4, "  1 2 1 7 8", "p4.cel:3: cell 1: face 4 has a vertex twice"},
        {"p4.cel", 6, "  2 3 2 8 9", "p4.cel:6: the file ends where a label of a cell should be"},
        {"p4.cel", 3, "1 17 8 1 1", "p4.cel:3: cell 1: unknown shape 17; known"},
        {"p4.cel", 3, "1 11 -8 1 1", "p4.cel:3: the number of labels of a cell '-8'"},
        {"p4.cel",
         3,
         "1 11 2000000000 1 1",
         "p4.cel:5: expected a line with labels of cell 1, found one of cell 2"},
        {"p4.cel", 3, "-1 11 8 1 1", "p4.cel:3: the number of a cell '-1'"},
        {"p4.cel",
         4,
         "  1 99 1 7 8 5 4 10 11",
         "p4.cel:3: cell 1: there is no vertex 99 in p4.vrt"},
        {"p4.cel", 0, baffles, "p4.cel:9: baffle 4: another baffle has the same vertices"},
        {"p4.bnd", 3, "1 9 6 1 0 patch", "p4.bnd:3: there is no cell 9"},
        {"p4.bnd", 3, "1 1 7 1 0 patch", "p4.bnd:3: cell 1 has no face 7"},
        {"p4.bnd", 3, "1 1 6 -1 0 patch", "p4.bnd:3: the number of a region '-1'"},
        {"p4.bnd", 12, "10 2", "p4.bnd:12: the file ends where"}};
    for (const HostileFile& file : hostile)
        expectRefused(shop, file);
    shop.expectSuccess("convertMesh p4 b"); // it was for these that it was refused
}

TEST(ConvertMesh, refusesHostileFilesOfVersion3InOneLine) {
    const Workshop shop;
    shop.addCase("a", test::box(2, 1, 1));
    shop.expectSuccess("convertMesh a p3 -to star3");
    shop.write("p3.cpl", "");
    std::string baffles;
    for (int i = 3; i < 2'000'003; ++i)
        fmt::format_to(std::back_inserter(baffles), "{} 2 5 11 8 0 0 0 0 1 3\n", i);
    const std::vector<HostileFile> hostile{
        {"p3.vrt", 2, "2 0.0 x 0.0", "p3.vrt:2: '2 0.0 x 0.0': expected a positive vertex number"},
        {"p3.vrt", 2, "1 0. 0. 0.", "p3.vrt:2: vertex 1 is there already"},
        {"p3.cel", 2, "2 3 2 8 9", "p3.cel:2: expected 11 whole numbers: cell, 8 vertices"},
        {"p3.cel",
         2,
         "2 3 2 8 9 6 5 11 99 1 1",
         "p3.cel:2: cell 2: there is no vertex 99 in p3.vrt"},
        {"p3.cel", 2, "2 3 2 8 9 6 5 11 -12 1 1", "p3.cel:2: cell 2: there is no vertex -12 in"},
        {"p3.cel",
         2,
         "-2 3 2 8 9 6 5 11 12 1 1",
         "p3.cel:2: the number of a cell must be positive"},
        {"p3.cel", 2, "2 3 2 8 9 6 5 11 12 1 -1", "p3.cel:2: the file ends within the three lines"},
        {"p3.cel",
         2,
         "2 3 2 8 9 6 5 11 12 1 -1\n2 1 0 0 0 0 0 0 0 1 0\n2 0 0 0 0 0 3 0 0 1 0",
         "p3.cel:2: cell 2: unknown type 3 of a trimmed cell; known are 1, 2, 7, 8 and 85"},
        {"p3.cel", 0, baffles, "p3.cel:4: baffle 4: another baffle has the same vertices"},
        {"p3.bnd", 1, "1 1 7 10 99 1 0 WALL", "p3.bnd:1: there is no vertex 99 in p3.vrt"},
        {"p3.bnd", 1, "1 1 7 10 4 -1 0 WALL", "p3.bnd:1: region -1 is negative"},
        {"p3.bnd", 10, "10 8 9", "p3.bnd:10: expected 7 whole numbers"},
        {"p3.cpl", 0, "1 2 1 1 9 2 1\n", "p3.cpl:1: cell 1 has no face 9"},
        {"p3.cpl", 0, "1 2 1 1 2\n", "p3.cpl:1: the file ends where the number of a cell"},
        {"p3.cpl", 0, "1 -2 1 1 2 2 1\n", "p3.cpl:1: the number of entries"}};
    for (const HostileFile& file : hostile)
        expectRefused(shop, file);
    shop.expectSuccess("convertMesh p3 b");
}

TEST(ConvertMesh, leavesTheOldMeshWhenItFails) {
    const Workshop shop;
    const PolyMesh mesh = test::box(3, 2, 1);
    shop.addCase("a", mesh);
    shop.expectSuccess("convertMesh a part && sed -i '4s/$/ x/' part.cel");
    EXPECT_EQ(shop.run("convertMesh part a").status, 2);
    EXPECT_EQ(shop.meshOf("a"), mesh);
    EXPECT_EQ(shop.run("convertMesh a nowhere/part").status, 1);
}

} // namespace polymesh::tools
