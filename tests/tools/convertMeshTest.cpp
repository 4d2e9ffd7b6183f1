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
