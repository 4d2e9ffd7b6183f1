// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Our reader and writer against OpenFOAM's own programs.

#include "foamTestSupport.h"
#include "formats/foam/caseDirectory.h"
#include "formats/foam/dictionary.h"
#include "formats/foam/polyMeshIo.h"
#include "formats/foam/sets.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace polymesh::foam {
namespace {

namespace fs = std::filesystem;
using test::readText;
using test::TemporaryDirectory;
using test::writeText;

std::string header(const std::string& object) {
    return "FoamFile { version 2.0; format ascii; class dictionary; object " + object + "; }\n";
}

constexpr const char* blockMeshDict = R"(
scale 1;
vertices ((0 0 0) (2 0 0) (2 1 0) (0 1 0) (0 0 1) (2 0 1) (2 1 1) (0 1 1));
blocks (hex (0 1 2 3 4 5 6 7) block (4 3 2) simpleGrading (1 3 1));
edges ();
boundary ( in { type patch; inGroups (a b); faces ((0 4 7 3)); }
    walls { type wall; faces ((1 2 6 5) (0 1 5 4) (3 7 6 2)); } );
)";

constexpr const char* topoSetDict = R"(
actions (
    { name c; type cellSet; action new; source boxToCell; box (0 0 0) (1 1 1); }
    { name cz; type cellZoneSet; action new; source setToCellZone; set c; }
    { name f; type faceSet; action new; source boxToFace; box (0.4 0 0) (0.6 1 1); }
    { name fz; type faceZoneSet; action new; source setsToFaceZone; faceSet f; cellSet c; }
    { name p; type pointSet; action new; source boxToPoint; box (0 0 0) (0.1 1 1); }
    { name pz; type pointZoneSet; action new; source setToPointZone; set p; } );
)";

/// A case with OpenFOAM's dictionaries, in the format that `control` asks for.
class OpenFoam : public testing::Test {
protected:
    void SetUp() override {
        if (!fs::exists("/usr/bin/blockMesh")) GTEST_SKIP() << "OpenFOAM is not installed";
        setenv("WM_PROJECT_DIR", "/usr/share/openfoam", 0);
        ask("writeFormat ascii; writePrecision 12; writeCompression off;");
        writeText(root_ / "system/blockMeshDict", header("blockMeshDict") + blockMeshDict);
        writeText(root_ / "system/topoSetDict", header("topoSetDict") + topoSetDict);
        for (const char* name : {"fvSchemes", "fvSolution"})
            writeText(root_ / "system" / name,
                      header(name) + "ddtSchemes{} gradSchemes{} divSchemes{} laplacianSchemes{} "
                                     "interpolationSchemes{} snGradSchemes{}");
    }

    void ask(const std::string& format) {
        writeText(root_ / "system/controlDict",
                  header("controlDict") +
                      "application none; startFrom startTime; startTime 0; stopAt endTime; endTime "
                      "1; deltaT 1; writeControl timeStep; writeInterval 1; " +
                      format);
    }

    /// Runs an OpenFOAM program in the case; its output.
    std::string run(const std::string& program) {
        const fs::path log = root_ / "log";
        const std::string command =
            "/usr/bin/" + program + " -case " + root_.string() + " > " + log.string() + " 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0) << program << "\n" << readText(log);
        return readText(log);
    }

    fs::path mesh() const { return root_ / "constant/polyMesh"; }

    TemporaryDirectory directory_;
    fs::path root_ = directory_.path();
};

std::string summary(const PolyMesh& mesh) {
    std::string text;
    for (const Patch& patch : mesh.patches)
        text += fmt::format("{} {} {} {}; ", patch.name, patch.type, patch.start, patch.size);
    return text;
}

/// Leaves differences of rounding out, and of spelling in the further entries of patches.
void expectSame(const PolyMesh& a, const PolyMesh& b) {
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i)
        EXPECT_LT(norm(a.points[i] - b.points[i]), 1e-11);
    EXPECT_EQ(a.faces.offsets, b.faces.offsets);
    EXPECT_EQ(a.faces.values, b.faces.values);
    EXPECT_EQ(a.owner, b.owner);
    EXPECT_EQ(a.neighbour, b.neighbour);
    EXPECT_EQ(summary(a), summary(b));
    EXPECT_EQ(a.cellCount, b.cellCount);
    EXPECT_EQ(a.pointZones, b.pointZones);
    EXPECT_EQ(a.faceZones, b.faceZones);
    EXPECT_EQ(a.cellZones, b.cellZones);
}

TEST_F(OpenFoam, itsMeshIsTheSameFromEveryFormat) {
    run("blockMesh");
    run("topoSet");
    const PolyMesh text = readPolyMesh(mesh());
    EXPECT_EQ(text.cellCount, 24);
    EXPECT_EQ(text.patches.size(), 3U);
    EXPECT_EQ(text.patches[0].entries,
              (std::vector<std::pair<std::string, std::string>>{{"inGroups", "2(a b)"}}));
    ASSERT_EQ(text.cellZones.size(), 2U);
    EXPECT_EQ(text.cellZones[1].labels.size(), 12U);
    ASSERT_EQ(text.faceZones.size(), 1U);
    EXPECT_EQ(text.faceZones[0].labels, readSet(mesh(), SetKind::face, "f"));
    EXPECT_EQ(text.pointZones.at(0).labels, readSet(mesh(), SetKind::point, "p"));
    for (const char* format : {"writeFormat ascii; writePrecision 12; writeCompression on;",
                               "writeFormat binary; writeCompression off;"}) {
        ask(format);
        fs::remove_all(mesh());
        run("blockMesh");
        run("topoSet");
        expectSame(text, readPolyMesh(mesh()));
    }
}

TEST_F(OpenFoam, readsEveryFormatThatWeWrite) {
    run("blockMesh");
    run("topoSet");
    const PolyMesh original = readPolyMesh(mesh());
    for (const char* format : {"ascii", "binary", "ascii.gz", "binary.gz"}) {
        writePolyMesh(original, mesh(), writeFormat({root_, ""}, format));
        writeSet(mesh(), SetKind::cell, "marked", std::vector<Label>{1, 5});
        const std::string report = run("checkMesh -allTopology");
        EXPECT_NE(report.find("Mesh OK."), std::string::npos) << format << report;
        EXPECT_NE(report.find("cellZone"), std::string::npos) << report;
        run("foamFormatConvert"); // reads and writes all of it
        expectSame(original, readPolyMesh(mesh()));
    }
}

TEST_F(OpenFoam, itsDictionariesAreRead) {
    const fs::path examples = "/usr/share/doc/openfoam-examples/examples";
    if (!fs::exists(examples)) GTEST_SKIP() << "openfoam-examples is not installed";
    int count = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(examples)) {
        const std::string name = entry.path().filename().string();
        if (name != "controlDict" && name != "blockMeshDict") continue;
        if (!entry.is_regular_file()) continue;
        EXPECT_NO_THROW(readDictionary(entry.path(), Directives::skip)) << entry.path();
        ++count;
    }
    EXPECT_GT(count, 100);
}

} // namespace
} // namespace polymesh::foam
