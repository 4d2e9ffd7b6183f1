// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/threadLimit.h"
#include "tests/formats/star/starTestSupport.h"

namespace polymesh::star {

namespace {

using namespace test;

constexpr const char* numbers = "4000 0 0 0 0 0 0 0\n";

std::string vertexHeader() {
    return std::string("PROSTAR_VERTEX\n") + numbers;
}

std::string cellHeader() {
    return std::string("PROSTAR_CELL\n") + numbers;
}

std::string boundaryHeader() {
    return std::string("PROSTAR_BOUNDARY\n") + numbers;
}

/// Two unit cubes beside each other: cells 7 and 9, vertices 11 ... 22.
Texts twoCubes() {
    std::string vertices = vertexHeader();
    int number = 11;
    for (int x = 0; x < 3; ++x)
        for (const char* yz : {"0. 0.", "1. 0.", "1. 1.", "0. 1."})
            vertices += fmt::format("{} {}. {}\n", number++, x, yz);
    return {{".vrt", vertices},
            {".cel",
             cellHeader() + "7 11 8 1 1\n  7 11 12 13 14 15 16 17 18\n9 11 8 1 1\n"
                            "  9 15 16 17 18 19 20 21 22\n"},
            {".bnd", boundaryHeader() + "1 7 1 3 0 INLE\n2 9 2 1 0 WALL\n3 7 3 1 0 WALL\n"}};
}

Texts changed(const std::string& ending, std::string_view from, std::string_view to) {
    Texts texts = twoCubes();
    texts[ending] = replaced(texts[ending], from, to);
    return texts;
}

Label patchSize(const PolyMesh& mesh, const std::string& name) {
    for (const Patch& patch : mesh.patches)
        if (patch.name == name) return patch.size;
    return -1;
}

} // namespace

TEST(Star4, readsBackWhatItWrote) {
    for (const auto& [name, mesh] : meshesOfAllKinds()) {
        SCOPED_TRACE(name);
        const TemporaryDirectory dir;
        EXPECT_TRUE(write(mesh, dir / "m", Version::v4, 1000).empty());
        EXPECT_EQ(versionOf(dir / "m"), Version::v4);
        const StarMesh read = star::read(dir / "m", Version::v4, 0.001);
        EXPECT_TRUE(read.notes.empty());
        expectSameMesh(mesh, read.mesh, 1e-15);
    }
}

TEST(Star4, keepsEveryBitOfCoordinatesWithoutScale) {
    const PolyMesh mesh = jittered(box(5, 5, 5), 0.05);
    const TemporaryDirectory dir;
    write(mesh, dir / "m", Version::v4, 1);
    EXPECT_EQ(star::read(dir / "m", Version::v4, 1).mesh.points, mesh.points);
}

TEST(Star4, keepsNamesTypesAndZones) {
    PolyMesh mesh = box(4, 3, 2);
    mesh.patches[0].type = "wall";
    mesh.patches[1].type = "symmetryPlane";
    mesh.patches[1].entries = {{"inGroups", "1(symmetryPlane)"}};
    mesh.patches[2].type = "empty";
    mesh.patches[3].type = "cyclic";
    mesh.patches[3].entries = {{"neighbourPatch", "other"}, {"transform", "unknown"}};
    mesh.patches[4].entries = {{"physicalType", "inle"}};
    mesh.cellZones = {{"rotor", {1, 2, 5}, {}}, {"stator", {3, 4, 20}, {}}};
    const TemporaryDirectory dir;
    EXPECT_TRUE(write(mesh, dir / "m", Version::v4, 1).empty());
    expectSameMesh(mesh, star::read(dir / "m", Version::v4, 1).mesh, 0);
}

TEST(Star4, saysWhatItLeavesOut) {
    PolyMesh mesh = box(2, 2, 2);
    mesh.cellZones = {{"a", {0, 1}, {}}, {"b", {1, 2}, {}}, {"none", {}, {}}};
    mesh.faceZones = {{"inner", {0}, {false}}};
    mesh.pointZones = {{"corner", {0, 1}, {}}};
    const TemporaryDirectory dir;
    writeText(dir / "m.cpl", "");
    const std::vector<std::string> notes = write(mesh, dir / "m", Version::v4, 1);
    ASSERT_EQ(notes.size(), 5);
    EXPECT_TRUE(notes[0].starts_with("cell zone b: 1 of its 2 cells")) << notes[0];
    EXPECT_TRUE(notes[1].starts_with("cell zone none has no cells")) << notes[1];
    EXPECT_TRUE(notes[2].starts_with("face zone inner (1 faces)")) << notes[2];
    EXPECT_TRUE(notes[3].starts_with("point zone corner (2 points)")) << notes[3];
    EXPECT_FALSE(std::filesystem::exists(dir / "m.cpl"));
    const std::vector<Zone> zones = star::read(dir / "m", Version::v4, 1).mesh.cellZones;
    EXPECT_EQ(zones, (std::vector<Zone>{{"a", {0, 1}, {}}, {"b", {2}, {}}}));
}

TEST(Star4, writesTheSameBytesWithAnyNumberOfThreads) {
    const PolyMesh mesh = jittered(box(20, 20, 20), 0.01);
    const TemporaryDirectory dir;
    write(mesh, dir / "all", Version::v4, 1000);
    const StarMesh read = star::read(dir / "all", Version::v4, 0.001);
    const ThreadLimit one(1);
    write(mesh, dir / "one", Version::v4, 1000);
    for (const char* ending : {".vrt", ".cel", ".bnd"})
        EXPECT_EQ(readText(dir / (std::string("one") + ending)),
                  readText(dir / (std::string("all") + ending)));
    EXPECT_EQ(star::read(dir / "all", Version::v4, 0.001).mesh, read.mesh);
}

TEST(Star4, acceptsGapsInNumberingAndNamesPatchesAsOpenFoamDoes) {
    const StarMesh read = readTexts(twoCubes(), Version::v4);
    EXPECT_EQ(read.mesh.cellCount, 2);
    EXPECT_EQ(patchSize(read.mesh, "wall_1"), 2);
    EXPECT_EQ(patchSize(read.mesh, "inle_3"), 1);
    EXPECT_EQ(patchSize(read.mesh, "Default_Boundary_Region"), 7);
    EXPECT_TRUE(read.mesh.cellZones.empty());
    EXPECT_NEAR(volumeOf(read.mesh), 2, 1e-12);
    EXPECT_TRUE(validate(read.mesh).empty());
}

TEST(Star4, acceptsWhatOtherProgramsWrite) {
    EXPECT_EQ(failureOf(changed(".vrt", "22 2. 0. 1.\n", "22 2. 0. 1."), Version::v4), "");
    EXPECT_EQ(failureOf(changed(".vrt", "12 0. 1. 0.", "  12   -0.1E+00-1.E-01+.0"), Version::v4),
              "");
    EXPECT_EQ(failureOf(changed(".cel", "7 11 8 1 1\n", "   7    11   8\t1 1 \r\n"), Version::v4),
              "");
    EXPECT_EQ(failureOf(changed(".bnd", "0 WALL\n3", "0 \n\n3"), Version::v4), "");
    Texts sparse = twoCubes();
    for (const char* ending : {".vrt", ".cel"})
        for (std::string& text = sparse[ending]; text.find("22") != std::string::npos;)
            text = replaced(text, "22", "999999999");
    EXPECT_EQ(failureOf(sparse, Version::v4), "");
    Texts bare = twoCubes();
    bare.erase(".bnd");
    EXPECT_EQ(patchSize(readTexts(bare, Version::v4).mesh, "Default_Boundary_Region"), 10);
}

TEST(Star4, takesAnyNumberOfRegionsAndOfBaffleRegions) {
    // Region 0 is no region; star4ToFoam has room for 1000 regions, and for one of baffles.
    const StarMesh numbered =
        readTexts(changed(".bnd", "1 7 1 3", "9 7 4 0 0 WALL\n1 7 1 99999999"), Version::v4);
    EXPECT_EQ(patchSize(numbered.mesh, "inle_99999999"), 1);
    EXPECT_EQ(patchSize(numbered.mesh, "Default_Boundary_Region"), 7);
    const TemporaryDirectory dir;
    write(box(3, 1, 1), dir / "m", Version::v4, 1);
    Texts texts;
    for (const char* ending : {".vrt", ".cel"})
        texts[ending] = readText(dir / (std::string("m") + ending));
    texts[".cel"] += "8 3 4 5 3\n  8 2 6 14 10\n9 3 4 6 3\n  9 3 7 15 11\n";
    const PolyMesh mesh = readTexts(texts, Version::v4).mesh;
    EXPECT_EQ(patchSize(mesh, "baffle_5"), 2);
    EXPECT_EQ(patchSize(mesh, "baffle_6"), 2);
    EXPECT_EQ(mesh.internalFaceCount(), 0);
}

TEST(Star4, collapsesRepeatedVertices) {
    // The second cube becomes a prism, its edges at x = 2 one.
    Texts texts = changed(".cel", "19 20 21 22", "19 19 22 22");
    texts.erase(".bnd");
    const StarMesh read = readTexts(texts, Version::v4);
    EXPECT_NEAR(volumeOf(read.mesh), 1.5, 1e-12);
    EXPECT_EQ(read.notes.size(), 1) << "two vertices are not used";
}

TEST(Star4, turnsCellsThatAreInsideOut) {
    Texts texts = changed(".cel", "15 16 17 18 19 20 21 22", "19 20 21 22 15 16 17 18");
    texts.erase(".bnd");
    const StarMesh one = readTexts(texts, Version::v4);
    EXPECT_NEAR(volumeOf(one.mesh), 2, 1e-12);
    EXPECT_EQ(one.notes, std::vector<std::string>{"1 cells were inside out and have been turned"});
    texts[".cel"] = replaced(texts[".cel"], "11 12 13 14 15 16 17 18", "15 16 17 18 11 12 13 14");
    const StarMesh both = readTexts(texts, Version::v4);
    EXPECT_NEAR(volumeOf(both.mesh), 2, 1e-12);
    EXPECT_EQ(both.notes, std::vector<std::string>{"2 cells were inside out and have been turned"});
    EXPECT_TRUE(validate(both.mesh).empty());
}

TEST(Star4, makesZonesOfTheCellTable) {
    Texts texts = changed(".cel", "9 11 8 1 1", "9 11 8 4 2");
    const StarMesh unnamed = readTexts(texts, Version::v4);
    EXPECT_EQ(unnamed.mesh.cellZones,
              (std::vector<Zone>{{"cellTable_1", {0}, {}}, {"cellTable_4", {1}, {}}}));
    ASSERT_EQ(unnamed.notes.size(), 1);
    EXPECT_TRUE(unnamed.notes[0].starts_with("1 solid cells")) << unnamed.notes[0];
    texts[".inp"] = "*ask something\nCTNAME,4,hot plate\nRNAM 1 side walls\nrdef,3,inlet\n";
    const StarMesh named = readTexts(texts, Version::v4);
    EXPECT_EQ(named.mesh.cellZones[1].name, "hotplate");
    EXPECT_EQ(patchSize(named.mesh, "sidewalls"), 2);
}

TEST(Star4, doesNotLetNamesSpoilDictionaries) {
    Texts texts = twoCubes();
    texts[".inp"] = "rname 1 ()\nrname 3 a;b {c}\n! polymesh region 1 type wall;}\n"
                    "! polymesh region 1 entry inGroups 1(a)\n! polymesh region 1 entry a 1; b 2\n"
                    "! polymesh region 1 entry a )(\n! polymesh region 1 entry a { b 2; }\n";
    const PolyMesh mesh = readTexts(texts, Version::v4).mesh;
    EXPECT_FALSE(mesh.patches[0].name.empty());
    EXPECT_EQ(mesh.patches[1].name, "abc");
    EXPECT_EQ(mesh.patches[0].type, "wall");
    EXPECT_EQ(mesh.patches[0].entries,
              (std::vector<std::pair<std::string, std::string>>{{"inGroups", "1(a)"},
                                                                {"a", "{ b 2; }"}}));
}

TEST(Star4, partsCellsAtBafflesAndLeavesOutShells) {
    Texts texts = twoCubes();
    texts[".cel"] +=
        "20 3 4 6 3\n  20 18 17 16 15\n21 3 3 1 4\n  21 11 12 13\n22 2 2 1 5\n  22 11 12\n";
    const StarMesh read = readTexts(texts, Version::v4);
    EXPECT_EQ(read.mesh.internalFaceCount(), 0);
    EXPECT_EQ(patchSize(read.mesh, "baffle_6"), 2);
    EXPECT_EQ(read.notes.size(), 2);
    texts[".bnd"] += "4 20 1 5 0 BAFF\n5 20 2 5 0 BAFF\n";
    const PolyMesh named = readTexts(texts, Version::v4).mesh;
    EXPECT_EQ(patchSize(named, "baff_5"), 2);
    const TemporaryDirectory dir; // and there and back
    write(named, dir / "m", Version::v4, 1);
    expectSameMesh(named, star::read(dir / "m", Version::v4, 1).mesh, 0);
}

TEST(Star4, refusesHostileVertices) {
    const auto failure = [](std::string_view from, std::string_view to) {
        return failureOf(changed(".vrt", from, to), Version::v4);
    };
    EXPECT_EQ(failure("PROSTAR_VERTEX", "PROSTAR_CELL"),
              "m.vrt:1: expected 'PROSTAR_VERTEX', found 'PROSTAR_CELL'");
    EXPECT_TRUE(failure("4000", "3000").starts_with("m.vrt:2: the version '3000'"));
    EXPECT_EQ(failure("12 0. 1. 0.", "12 0. 1."),
              "m.vrt:4: '12 0. 1.': expected a positive vertex number and three coordinates");
    EXPECT_TRUE(failure("12 0. 1. 0.", "-12 0. 1. 0.").starts_with("m.vrt:4:"));
    EXPECT_TRUE(failure("12 0. 1. 0.", "12 0. nan 0.").starts_with("m.vrt:4:"));
    EXPECT_TRUE(failure("12 0. 1. 0.", "99999999999 0. 1. 0.").starts_with("m.vrt:4:"));
    EXPECT_EQ(failure("12 0. 1. 0.", "11 0. 1. 0."), "m.vrt:4: vertex 11 is there already");
}

TEST(Star4, refusesHostileCells) {
    const auto failure = [](std::string_view from, std::string_view to) {
        return failureOf(changed(".cel", from, to), Version::v4);
    };
    EXPECT_EQ(failure(" 21 22\n", " 21"),
              "m.cel:6: the file ends where a label of a cell should be");
    EXPECT_TRUE(
        failure("9 11 8", "9 17 8").starts_with("m.cel:5: cell 9: unknown shape 17; known"));
    EXPECT_EQ(failure("9 11 8 1 1\n  9 15", "9 11 7 1 1\n  9"),
              "m.cel:5: cell 9: a hexahedron has 8 vertices, not 7");
    EXPECT_TRUE(
        failure("9 11 8", "9 11 -8").starts_with("m.cel:5: the number of labels of a cell '-8'"));
    EXPECT_TRUE(failure("7 11 8", "-7 11 8").starts_with("m.cel:3: the number of a cell '-7'"));
    EXPECT_EQ(failure("  9 15", "  8 15"),
              "m.cel:6: expected a line with labels of cell 9, found one of cell 8");
    EXPECT_TRUE(failure("21 22", "21 99").starts_with("m.cel:5: cell 9: there is no vertex 99 in"));
    EXPECT_EQ(failure("9 11 8 1 1\n  9", "7 11 8 1 1\n  7"), "m.cel:5: cell 7 is there already");
    EXPECT_TRUE(failure("15 16 17 18 19 20 21 22", "15 17 16 18 19 15 21 22")
                    .starts_with("m.cel:5: cell 9: face"));
    EXPECT_EQ(failure("15 16 17 18 19 20 21 22", "15 15 15 15 19 20 21 22").substr(0, 9), "");
    EXPECT_TRUE(failure("15 16 17 18 19 20 21 22", "15 15 15 15 19 19 19 19")
                    .starts_with("m.cel:5: cell 9: only 0 of its faces"));
    Texts empty = twoCubes();
    empty[".cel"] = cellHeader();
    EXPECT_EQ(failureOf(empty, Version::v4), "m.cel: no cells");
    empty[".cel"] = "";
    EXPECT_TRUE(failureOf(empty, Version::v4).starts_with("m.cel:1: expected 'PROSTAR_CELL'"));
}

TEST(Star4, refusesCellsThatMeetWrongly) {
    Texts texts = twoCubes();
    texts[".vrt"] += "30 5. 5. 5.\n31 5. 5. 6.\n32 4. 5. 6.\n33 4. 5. 5.\n";
    texts[".cel"] += "10 11 8 1 1\n  10 15 16 17 18 30 31 32 33\n";
    EXPECT_EQ(failureOf(texts, Version::v4),
              "m.cel:3: cell 7, face 2: more than two cells have this face");
    Texts overlap = changed(".cel", "15 16 17 18 19 20 21 22", "30 31 32 33 15 16 17 18");
    overlap[".vrt"] += "30 .5 0. 0.\n31 .5 1. 0.\n32 .5 1. 1.\n33 .5 0. 1.\n";
    EXPECT_EQ(failureOf(overlap, Version::v4),
              "m.cel:3: cell 7, face 2: cell 9 lies on the same side of this face");
}

TEST(Star4, refusesHostilePolyhedra) {
    const std::string good = "1 255 17 1 1\n  1 5 8 11 14 17 11 13 12\n"
                             "  1 11 12 15 12 13 15 13 11\n  1 15\n";
    const auto failure = [&](std::string_view from, std::string_view to) {
        Texts texts = twoCubes();
        texts.erase(".bnd");
        texts[".cel"] = cellHeader() + (from.empty() ? good : replaced(good, from, to));
        return failureOf(texts, Version::v4);
    };
    EXPECT_EQ(failure("", ""), "");
    EXPECT_TRUE(failure("  1 5 8", "  1 0 8").starts_with("m.cel:3: cell 1: -1 faces"));
    EXPECT_TRUE(failure("  1 5 8", "  1 99 8").starts_with("m.cel:3: cell 1: 98 faces"));
    EXPECT_TRUE(failure("8 11 14", "11 8 14").starts_with("m.cel:3: cell 1: its index of faces"));
    EXPECT_TRUE(failure("14 17", "14 99").starts_with("m.cel:3: cell 1: its index of faces"));
    EXPECT_TRUE(
        failure("17 11 13 12", "17 11 12 13").starts_with("m.cel:3: cell 1: it is not closed"));
    EXPECT_TRUE(failure("17 1 1", "2000000000 1 1").starts_with("m.cel:6: the file ends"));
}

TEST(Star4, refusesHostileBoundaries) {
    const auto failure = [](std::string_view from, std::string_view to) {
        return failureOf(changed(".bnd", from, to), Version::v4);
    };
    EXPECT_EQ(failure("1 7 1 3", "1 8 1 3"), "m.bnd:3: there is no cell 8");
    EXPECT_EQ(failure("1 7 1 3", "1 7 7 3"), "m.bnd:3: cell 7 has no face 7");
    EXPECT_EQ(failure("1 7 1 3", "1 7 0 3"), "m.bnd:3: cell 7 has no face 0");
    EXPECT_TRUE(failure("1 7 1 3", "1 7 1 -3").starts_with("m.bnd:3: the number of a region '-3'"));
    EXPECT_TRUE(failure("3 7 3 1 0 WALL\n", "3 7").starts_with("m.bnd:5: the file ends"));
}

TEST(Star4, saysWhichBoundaryRecordsItLeavesOut) {
    const StarMesh inside = readTexts(changed(".bnd", "1 7 1 3", "1 7 2 3"), Version::v4);
    ASSERT_EQ(inside.notes.size(), 1);
    EXPECT_NE(inside.notes[0].find("1 records lie between two cells"), std::string::npos);
    const StarMesh twice = readTexts(changed(".bnd", "3 7 3", "3 7 1"), Version::v4);
    ASSERT_EQ(twice.notes.size(), 1);
    EXPECT_NE(twice.notes[0].find("1 records name a face that an earlier"), std::string::npos);
}

TEST(Star4, refusesTwoMillionBafflesThatLieNowhere) {
    Texts texts = twoCubes();
    std::string& cells = texts[".cel"];
    for (int i = 0; i < 2'000'000; ++i)
        fmt::format_to(std::back_inserter(cells), "{0} 3 4 6 3\n  {0} 11 12 16 17\n", 10 + i);
    const std::string failure = failureOf(texts, Version::v4);
    EXPECT_TRUE(failure.starts_with("m.cel:")) << failure;
    EXPECT_NE(failure.find("another baffle has the same vertices"), std::string::npos) << failure;
    texts = twoCubes();
    texts[".cel"] += "20 3 4 6 3\n  20 11 12 13 14\n";
    EXPECT_EQ(failureOf(texts, Version::v4),
              "m.cel:7: baffle 20: no two cells have the face between them that its vertices make");
}

} // namespace polymesh::star
