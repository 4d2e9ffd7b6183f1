// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/polyMeshIo.h"
#include "formats/foam/sets.h"
#include "formats/surfaceIo.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"
#include "tests/tools/program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace polymesh::tools {

namespace {

class MeshCase : public TemporaryCase {
public:
    explicit MeshCase(const PolyMesh& mesh) { foam::writePolyMesh(mesh, meshDir(), {}); }

    std::filesystem::path meshDir() const { return dir() / "constant/polyMesh"; }

    nlohmann::json report() const { return nlohmann::json::parse(read("report.json")); }
};

bool endsWith(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

} // namespace

TEST(ClassifyCells, listsTheCatalogueWithoutACase) {
    const TemporaryCase empty;
    const ProgramResult result = empty.run("classifyCells -listShapes");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(endsWith(result.out, "\ntotal 118\n")) << result.out;
    EXPECT_NE(result.out.find("\nvariants of hexagonalPrism           72\n"), std::string::npos);
}

TEST(ClassifyCells, countsAndLeavesTheMeshAlone) {
    const MeshCase hexes(test::twoHexes());
    const PolyMesh before = foam::readPolyMesh(hexes.meshDir());
    const ProgramResult result = hexes.run("classifyCells -json report.json");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out, "hexahedron 2\nunrecognised 0\n");
    EXPECT_EQ(hexes.report()["shapes"]["hexahedron"], 2);
    EXPECT_EQ(hexes.report()["unrecognised"], 0);
    EXPECT_EQ(foam::readPolyMesh(hexes.meshDir()), before);
}

TEST(ClassifyCells, saysWhatKeepsCellsFromBeingAcceptable) {
    const MeshCase one(test::hangingNodes());
    const ProgramResult result = one.run("classifyCells -noFields -json report.json");
    EXPECT_EQ(result.out, "hexahedron 4\nunrecognised 1\n  manyFaces 1\n");
    EXPECT_EQ(one.report()["obstacles"]["manyFaces"], 1);
}

TEST(ClassifyCells, writesFieldsThatParaViewCanColour) {
    const MeshCase hexes(test::twoHexes());
    EXPECT_EQ(hexes.run("classifyCells -quiet -format ascii").status, 0);
    const std::string field = hexes.read("0/cellBaseShape");
    EXPECT_NE(field.find("class       volScalarField;"), std::string::npos) << field;
    EXPECT_NE(field.find("nonuniform List<scalar> 2\n(\n3\n3\n)"), std::string::npos) << field;
    EXPECT_NE(field.find("zeroGradient"), std::string::npos) << field;
    EXPECT_TRUE(std::filesystem::exists(hexes.dir() / "0/cellShape"));
    const MeshCase quiet(test::twoHexes());
    EXPECT_EQ(quiet.run("classifyCells -quiet -noFields").status, 0);
    EXPECT_FALSE(std::filesystem::exists(quiet.dir() / "0"));
}

TEST(ClassifyCells, splitsATrimmedMesh) {
    const TemporaryCase part;
    const ProgramResult result = part.run(
        "S=/usr/share/doc/openfoam-examples/examples/resources/geometry/flange.stl.gz && "
        "blockInit -surface $S -cellSize 0.002 -quiet && trimSurface -surface $S -quiet && "
        "classifyCells -json before.json && classifyCells -split -json after.json");
    ASSERT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_TRUE(endsWith(result.out, "\nunrecognised 0\n")) << result.out;
    const auto before = nlohmann::json::parse(part.read("before.json"));
    const auto after = nlohmann::json::parse(part.read("after.json"));
    EXPECT_GT(before["unrecognised"], 0);
    EXPECT_EQ(after["unrecognised"], 0);
    EXPECT_EQ(after["splitCells"], before["unrecognised"]);
    EXPECT_NEAR(after["volumeError"], 0, 1e-12);
    EXPECT_TRUE(
        foam::readSet(part.dir() / "constant/polyMesh", foam::SetKind::cell, "unrecognisedCells")
            .empty());
    const ProgramResult again = part.run("classifyCells -split -json again.json");
    EXPECT_EQ(nlohmann::json::parse(part.read("again.json"))["newCells"], 0);
}

TEST(ClassifyCells, refusesToSplitAnInvalidMeshAndKeepsIt) {
    const MeshCase open(test::openCell());
    const PolyMesh before = foam::readPolyMesh(open.meshDir());
    const ProgramResult result = open.run("classifyCells -split");
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("checkMesh"), std::string::npos) << result.err;
    EXPECT_EQ(foam::readPolyMesh(open.meshDir()), before);
    EXPECT_EQ(open.run("classifyCells -quiet -json report.json").status, 0);
    EXPECT_EQ(open.report()["unrecognised"], 1);
}

} // namespace polymesh::tools
