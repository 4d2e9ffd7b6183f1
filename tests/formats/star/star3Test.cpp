// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/cellRecords.h"
#include "formats/star/cells3.h"
#include "libpolymesh/shapes/catalogue.h"
#include "tests/formats/star/starTestSupport.h"
#include "tests/libpolymesh/shapes/polyhedra.h"

#include <set>

namespace polymesh::star {

namespace {

using namespace test;

/// Corners of the unit cube in the order of a hexahedron's vertices.
const std::array<Vec3, 8> cube{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

/// The edges of the cube that a trimmed cell of each type has cut, by slot.
const std::map<Label, std::map<std::size_t, std::array<std::size_t, 2>>> cutEdges{
    {1, {{9, {0, 1}}, {11, {0, 3}}, {12, {0, 4}}}},
    {2, {{10, {1, 2}}, {11, {0, 3}}, {12, {0, 4}}, {13, {1, 5}}}},
    {7, {{8, {4, 5}}, {9, {1, 5}}, {10, {2, 6}}, {11, {3, 7}}, {12, {4, 7}}}},
    {8, {{8, {1, 2}}, {9, {2, 3}}, {10, {3, 7}}, {11, {4, 7}}, {12, {4, 5}}, {13, {1, 5}}}},
    {85,
     {{8, {0, 4}},
      {9, {1, 5}},
      {10, {1, 2}},
      {11, {0, 3}},
      {12, {4, 7}},
      {13, {5, 6}},
      {14, {2, 6}},
      {15, {3, 7}}}}};

/// Where the vertices of a base shape are in the unit cube.
std::vector<Vec3> verticesOf(BaseShape base) {
    const TrimmedForm* form = formOf(base);
    std::vector<Vec3> points;
    if (form == nullptr) {
        std::vector<Label> numbers(tableOf(base).pointCount);
        std::iota(numbers.begin(), numbers.end(), 0);
        const std::array<Label, 8> slots = regularSlots(base, numbers);
        for (const Label v : numbers)
            points.push_back(
                cube[static_cast<std::size_t>(std::ranges::find(slots, v) - slots.begin())]);
        return points;
    }
    for (const std::uint8_t slot : form->slots) {
        if (slot < 8) {
            points.push_back(cube[slot]);
            continue;
        }
        const auto& [a, b] = cutEdges.at(form->type).at(slot);
        points.push_back((cube[a] + cube[b]) / 2);
    }
    return points;
}

/// A mesh of one cell.
PolyMesh meshOfShape(const CatalogueShape& shape) {
    const Polyhedron cell = shapeCell(shape);
    const std::vector<Vec3> all = verticesOf(shape.base);
    std::map<Label, Label> newLabel;
    std::vector<Vec3> points;
    for (const Label p : pointsOf(cell)) {
        newLabel[p] = toLabel(points.size());
        points.push_back(all[index(p)]);
    }
    Polyhedron numbered = cell;
    for (Polygon& loop : numbered)
        for (Label& p : loop)
            p = newLabel[p];
    return meshOf(points, {numbered});
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

Texts written(const PolyMesh& mesh) {
    const TemporaryDirectory dir;
    write(mesh, dir / "m", Version::v3, 1);
    Texts texts;
    for (const char* ending : {".vrt", ".cel", ".bnd", ".inp"})
        texts[ending] = readText(dir / (std::string("m") + ending));
    return texts;
}

/// The polyhedron that OpenFOAM's star3ToFoam makes of a regular cell: it knows six ways in which
/// vertices may be equal, and takes the first that fits.
Polyhedron asStar3ToFoamReads(const std::array<Label, 8>& s) {
    const bool hasApex = s[4] == s[5] && s[5] == s[6] && s[6] == s[7];
    std::vector<std::size_t> model{0, 1, 2, 3, 4, 5, 6, 7};
    std::vector<std::vector<std::size_t>> faces;
    if (s[2] == s[3] && hasApex) {
        model = {0, 1, 2, 4};
        faces = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    } else if (hasApex) {
        model = {0, 1, 2, 3, 4};
        faces = {{0, 3, 2, 1}, {0, 4, 3}, {3, 4, 2}, {1, 2, 4}, {0, 1, 4}};
    } else if (s[2] == s[3] && s[4] == s[5] && s[6] == s[7]) {
        model = {0, 1, 2, 4, 6};
        faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 4, 2}, {1, 2, 4, 3}};
    } else if (s[2] == s[3] && s[6] == s[7]) {
        model = {0, 1, 2, 4, 5, 6};
        faces = {{0, 2, 1}, {3, 4, 5}, {0, 3, 5, 2}, {1, 2, 5, 4}, {0, 1, 4, 3}};
    } else if (s[4] == s[7]) {
        model = {7, 6, 5, 3, 2, 1, 0};
        faces = {{0, 2, 1}, {3, 4, 5, 6}, {0, 3, 6}, {1, 2, 5, 4}, {0, 1, 4, 3}, {0, 6, 5, 2}};
    } else {
        faces = {
            {0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};
    }
    Polyhedron cell;
    for (const auto& face : faces) {
        Polygon loop;
        for (const std::size_t v : face)
            if (std::ranges::find(loop, s[model[v]]) == loop.end()) loop.push_back(s[model[v]]);
        cell.push_back(loop);
    }
    return cell;
}

constexpr const char* cubeVertices = "1 0. 0. 0.\n2 1. 0. 0.\n3 1. 1. 0.\n4 0. 1. 0.\n"
                                     "5 0. 0. 1.\n6 1. 0. 1.\n7 1. 1. 1.\n8 0. 1. 1.\n";

Texts oneCube(const std::string& cell = "1 1 2 3 4 5 6 7 8 1 1\n",
              const std::string& boundary = "") {
    return {{".vrt", cubeVertices}, {".cel", cell}, {".bnd", boundary}};
}

} // namespace

TEST(Star3, readsBackEveryShapeOfTheCatalogue) {
    for (const CatalogueShape& shape : Catalogue::instance().shapes()) {
        SCOPED_TRACE(shape.name);
        const PolyMesh mesh = meshOfShape(shape);
        const Texts texts = written(mesh);
        const bool isTrimmed = formOf(shape.base) != nullptr;
        EXPECT_EQ(linesOf(texts.at(".cel")).size(), isTrimmed ? 3 : 1);
        const StarMesh read = readTexts(texts, Version::v3);
        EXPECT_TRUE(faceKeys(mesh) == faceKeys(read.mesh));
        EXPECT_EQ(mesh.points, read.mesh.points);
        EXPECT_EQ(mesh.patches, read.mesh.patches);
        EXPECT_TRUE(read.notes.empty());
    }
}

TEST(Star3, readsBackMeshesOfManyCells) {
    for (auto& [name, mesh] : meshesOfAllKinds()) {
        if (name == "hanging nodes" || name == "concave cell") continue;
        SCOPED_TRACE(name);
        if (mesh.cellCount > 6) mesh.cellZones = {{"some", {1, 3, 5}, {}}};
        const TemporaryDirectory dir;
        EXPECT_TRUE(write(mesh, dir / "m", Version::v3, 1).empty());
        EXPECT_EQ(versionOf(dir / "m"), Version::v3);
        expectSameMesh(mesh, star::read(dir / "m", Version::v3, 1).mesh, 1e-11);
    }
}

TEST(Star3, writesCellsInTheColumnsOfProStar) {
    PolyMesh mesh = meshOfShape(Catalogue::instance().shapes().front());
    for (const CatalogueShape& shape : Catalogue::instance().shapes())
        if (shape.base == BaseShape::sammTrim1 && shape.collapsed.empty())
            mesh = meshOfShape(shape);
    mesh.patches[0].type = "wall";
    const Texts texts = written(mesh);
    for (const std::string& line : linesOf(texts.at(".cel"))) {
        EXPECT_EQ(line.size(), 101) << line;
        EXPECT_EQ(line.substr(0, 15), "        1      ") << line;
        EXPECT_EQ(line.substr(87, 9), "        1") << "cell table";
    }
    const std::vector<std::string> cells = linesOf(texts.at(".cel"));
    EXPECT_EQ(cells[0].substr(96), "   -1");
    EXPECT_EQ(cells[1].substr(96), "    0");
    EXPECT_EQ(cells[2].substr(96), "    0");
    EXPECT_EQ(cells[0].substr(15, 9), "        0") << "corner 0 is cut away";
    EXPECT_EQ(cells[2].substr(15 + 5 * 9, 27), "        1        0        0")
        << "type, -, rotation";
    const std::string boundary = linesOf(texts.at(".bnd")).front();
    EXPECT_EQ(boundary.substr(0, 14), "       1      ");
    EXPECT_EQ(boundary.substr(50), "      1      0      WALL");
}

TEST(Star3, writesVerticesInColumnsThatDoNotTouch) {
    PolyMesh mesh = box(1, 1, 1);
    mesh.points[0] = {-1.0 / 3e5, 12345.678901234567, 0};
    const std::string vertex = linesOf(written(mesh)[".vrt"]).front();
    EXPECT_EQ(vertex.size(), 63) << vertex;
    EXPECT_EQ(vertex.substr(0, 15), "        1      ");
    EXPECT_NEAR(std::stod(vertex.substr(15, 16)), -1.0 / 3e5, 1e-14);
    EXPECT_NEAR(std::stod(vertex.substr(31, 16)), 12345.678901234567, 1e-8);
    EXPECT_EQ(vertex.substr(47, 16), "             0.0");
}

TEST(Star3, trimmedFacesLieOnTheSidesThatTheirNumbersSay) {
    // Outward directions of the faces 1 to 6 of STAR's hexahedron.
    const std::array<Vec3, 6> outward{
        {{0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}}};
    for (const BaseShape base : allBaseShapes()) {
        const TrimmedForm* form = formOf(base);
        if (form == nullptr && base != BaseShape::hexahedron) continue;
        const auto numbers = form == nullptr ? regularFaceNumbers(base) : form->faceNumbers;
        const std::vector<Vec3> points = verticesOf(base);
        std::set<int> used;
        for (std::size_t f = 0; f < numbers.size(); ++f) {
            EXPECT_TRUE(used.insert(numbers[f]).second) << tableOf(base).name;
            if (numbers[f] > 6) continue;
            const Vec3 n = outward[numbers[f] - std::size_t{1}];
            for (const ShapeVertex v : tableOf(base).faces[f])
                EXPECT_EQ(dot(n, points[v] - Vec3{0.5, 0.5, 0.5}), 0.5) << tableOf(base).name;
        }
    }
}

TEST(Star3, writesRegularCellsAsStar3ToFoamKnowsThem) {
    for (const CatalogueShape& shape : Catalogue::instance().shapes()) {
        if (formOf(shape.base) != nullptr) continue;
        SCOPED_TRACE(shape.name);
        std::vector<Label> vertices(tableOf(shape.base).pointCount);
        std::iota(vertices.begin(), vertices.end(), 0);
        for (const ShapeEdge& edge : shape.collapsed)
            std::ranges::replace(vertices, vertices[edge[1]], Label{vertices[edge[0]]});
        const Polyhedron theirs = asStar3ToFoamReads(regularSlots(shape.base, vertices));
        EXPECT_TRUE(loopSet(theirs) == loopSet(shapeCell(shape)));
    }
}

TEST(Star3, acceptsAnyCollapseOfAHexahedron) {
    // Prisms that lie the other way, a wedge, a tetrahedron with its apex first.
    const std::map<std::string, double> volumes{{"1 2 3 1 5 6 7 5", 1. / 2},
                                                {"1 2 2 4 5 6 6 8", 1. / 2},
                                                {"1 2 3 4 5 6 3 4", 1. / 2},
                                                {"1 1 3 4 5 5 7 8", 1. / 2},
                                                {"1 2 3 4 5 6 7 5", 3. / 4},
                                                {"5 5 5 5 1 2 3 4", 1. / 3},
                                                {"5 5 5 5 1 2 3 3", 1. / 6}};
    for (const auto& [vertices, volume] : volumes) {
        const StarMesh read = readTexts(oneCube("1 " + vertices + " 1 1\n"), Version::v3);
        EXPECT_NEAR(volumeOf(read.mesh), volume, 1e-12) << vertices;
        EXPECT_TRUE(validate(read.mesh).empty()) << vertices;
    }
    EXPECT_EQ(failureOf(oneCube("4 1 2 1 4 5 6 7 8 1 1\n"), Version::v3),
              "m.cel:1: cell 4: face 1 has a vertex twice");
}

TEST(Star3, readsNumbersThatTouchByTheirColumns) {
    Texts texts = oneCube();
    texts[".vrt"] = "        1                   0.0             0.0             0.0\n"
                    "        2       1.2345678901234-0.123456789E-02-0.123456789E-02\n"
                    "        3      1.123456789012341.123456789012340.00000000000000\n"
                    "123456789      0.12345678901234 1.123456789D+00             0.0\n"
                    "        5                   0.0             0.0             1.0\n"
                    "        6                   1.0             0.0             1.0\n"
                    "        7                   1.0             1.0             1.0\n"
                    "        8                   0.0             1.0             1.0";
    texts[".cel"] = "        1              1        2        3123456789        5        6"
                    "        7        8        1    1";
    texts[".bnd"] = "       1              1        2        3123456789      2      0      WALL";
    const StarMesh read = readTexts(texts, Version::v3);
    EXPECT_EQ(read.mesh.points[1], (Vec3{1.2345678901234, -0.00123456789, -0.00123456789}));
    EXPECT_EQ(read.mesh.points[2], (Vec3{1.12345678901234, 1.12345678901234, 0}));
    EXPECT_EQ(read.mesh.points[3], (Vec3{0.12345678901234, 1.123456789, 0}));
    EXPECT_EQ(read.mesh.patches[0].name, "WALL2");
    EXPECT_EQ(read.mesh.patches[0].size, 1);
}

TEST(Star3, acceptsWhatOtherProgramsWrite) {
    Texts texts;
    // Numbers with gaps and in no order, text behind what counts, empty lines, other ends of lines.
    texts[".vrt"] = "\n900 0 0 0 7 x\r\n800   1. 0. 0.\r\n\n7 +1.E+00 1.D0 0.\n6 0 1 -0.\n"
                    "        5                   0.0             0.0             1.0 behind\n"
                    "400 1. 0. 1.\n300 1. 1. 1.\n99999999 0. 1. 1.";
    texts[".cel"] = "  12 900 800 7 6 5 400 300 99999999 3 1 7 8 9 and more\r\n\n";
    texts[".bnd"] = "1 900 800 7 6 123456 0 cycl behind\n\n7 5 400 300 99999999 12 0\r\n"
                    "8 900 6 99999999 5 0 0 WALL\n9 900 800 400 400 5 0 SYMPLANE";
    for (const char* ending : {"", "\n"}) {
        Texts ended = texts;
        for (auto& [name, text] : ended)
            text += ending;
        const StarMesh read = readTexts(ended, Version::v3);
        EXPECT_NEAR(volumeOf(read.mesh), 1, 1e-12);
        ASSERT_EQ(read.mesh.patches.size(), 4);
        EXPECT_EQ(read.mesh.patches[0].type, "symmetry"); // in the order of their numbers
        EXPECT_EQ(read.mesh.patches[0].size, 1);          // a triangle names a quadrilateral too
        EXPECT_EQ(read.mesh.patches[1].size, 1);          // without a type
        EXPECT_EQ(read.mesh.patches[2].size, 1);          // a number beyond OpenFOAM's thousand
        EXPECT_EQ(read.mesh.patches[3].name, "Default_Boundary_Region"); // region 0 is no region
        EXPECT_EQ(read.mesh.patches[3].size, 3);
    }
}

TEST(Star3, saysThatFilesOfMasksAreNotRead) {
    const std::string message =
        failureOf(oneCube("1 0 2 3 4 5 6 7 8 1 -1\n1 1 1 1 0 0 0 0 0 1 1\n"), Version::v3);
    EXPECT_NE(
        message.find("m.cel:2: expected a line of trimmed cell 1 with type flag 0, found cell "
                     "1 with flag 1"),
        std::string::npos);
    EXPECT_NE(message.find("masks of removed corners"), std::string::npos) << message;
}

TEST(Star3, findsFacesByFourOfTheirVertices) {
    PolyMesh mesh;
    for (const CatalogueShape& shape : Catalogue::instance().shapes())
        if (shape.base == BaseShape::sammTrim4 && shape.collapsed.empty())
            mesh = meshOfShape(shape);
    Texts texts = written(mesh);
    EXPECT_EQ(linesOf(texts[".bnd"]).size(), 7);
    EXPECT_EQ(readTexts(texts, Version::v3).mesh.patches[0].size, 7);
    // A triangle record fits the quadrilateral that has its vertices, when there is no triangle.
    const StarMesh quad = readTexts(oneCube("1 1 2 3 4 5 6 7 8 1 1\n",
                                            "1 1 2 3 3 1 0 INLE\n"
                                            "2 5 6 7 0 2 0 OUTL\n"),
                                    Version::v3);
    EXPECT_EQ(quad.mesh.patches[0].name, "INLE1");
    EXPECT_EQ(quad.mesh.patches[0].size, 1);
    EXPECT_EQ(quad.mesh.patches[1].size, 1);
    const StarMesh none = readTexts(oneCube("1 1 2 3 4 5 6 7 8 1 1\n",
                                            "1 1 2 3 5 1 0 INLE\n2 1 2 3 4 1 0 INLE\n"
                                            "3 4 3 2 1 2 0 INLE\n"),
                                    Version::v3);
    ASSERT_EQ(none.notes.size(), 2);
    EXPECT_NE(none.notes[0].find("1 records fit no boundary face"), std::string::npos);
    EXPECT_NE(none.notes[1].find("1 records name a face that an earlier"), std::string::npos);
}

TEST(Star3, tellsTheSidesOfABaffleApartByTheirSense) {
    Texts texts;
    texts[".vrt"] =
        std::string(cubeVertices) + "9 2. 0. 0.\n10 2. 1. 0.\n11 2. 0. 1.\n12 2. 1. 1.\n";
    texts[".cel"] = "1 1 2 3 4 5 6 7 8 1 1\n2 2 9 10 3 6 11 12 7 1 1\n3 2 3 7 6 0 0 0 0 4 3\n"
                    "4 1 2 3 0 0 0 0 0 4 4\n";
    EXPECT_EQ(readTexts(texts, Version::v3).mesh.patches[0].name, "baffle_4");
    texts[".bnd"] = "1 2 6 7 3 1 0 LEFT\n2 2 3 7 6 2 0 RIGH\n";
    const StarMesh read = readTexts(texts, Version::v3);
    ASSERT_EQ(read.mesh.patches.size(), 3);
    EXPECT_EQ(read.mesh.owner[index(read.mesh.patches[0].start)], 1) << read.mesh.patches[0].name;
    EXPECT_EQ(read.mesh.owner[index(read.mesh.patches[1].start)], 0);
    // Written as two faces with the same vertices, and read back so.
    expectSameMesh(read.mesh, readTexts(written(read.mesh), Version::v3).mesh, 0);
}

TEST(Star3, refusesToWriteCellsOutsideTheCatalogue) {
    const TemporaryDirectory dir;
    try {
        write(hangingNodes(), dir / "m", Version::v3, 1);
        FAIL();
    } catch (const WorkError& error) {
        EXPECT_STREQ(error.what(),
                     "1 of 5 cells are no shape that STAR-CD version 3 has; divide them with "
                     "classifyCells -split, or write version 4 (-to star4)");
    }
    EXPECT_TRUE(std::filesystem::is_empty(dir.path())) << "nothing half-written";
}

TEST(Star3, refusesHostileCells) {
    const auto failure = [](const std::string& cells) {
        return failureOf(oneCube(cells), Version::v3);
    };
    EXPECT_TRUE(failure("1 1 2 3 4 5 6 7 8 1\n").starts_with("m.cel:1: expected 11 whole numbers"));
    EXPECT_TRUE(failure("1 1 2 3 4 5 6 7 x 1 1\n").starts_with("m.cel:1: expected 11 whole"));
    EXPECT_TRUE(failure("1 1 2 3 4 5 6 7 99999999999 1 1\n").starts_with("m.cel:1: expected 11"));
    EXPECT_TRUE(failure("\n1 1 2 3 4 5 6 7 9 1 1\n")
                    .starts_with("m.cel:2: cell 1: there is no vertex 9 in"));
    EXPECT_TRUE(
        failure("1 1 2 3 4 5 6 7 -8 1 1\n").starts_with("m.cel:1: cell 1: there is no vertex -8"));
    EXPECT_EQ(failure("-1 1 2 3 4 5 6 7 8 1 1\n"),
              "m.cel:1: the number of a cell must be positive");
    EXPECT_TRUE(
        failure("1 1 2 3 4 5 6 7 8 1 0\n").starts_with("m.cel:1: cell 1: type flag 0 begins"));
    EXPECT_EQ(failure("1 1 2 3 4 5 6 7 0 1 1\n"),
              "m.cel:1: cell 1: one of its eight vertices is 0");
    EXPECT_EQ(failure("1 1 2 3 4 5 6 7 8 1 1\n1 1 2 3 4 5 6 7 8 1 1\n"),
              "m.cel:2: cell 1 is there already");
    EXPECT_TRUE(failure("PROSTAR_CELL\n4000\n").starts_with("m.cel:1: the header of version 4"));
    EXPECT_EQ(failure(""), "m.cel: no cells");
}

TEST(Star3, refusesHostileTrimmedCells) {
    const std::string first = "1 0 2 3 4 5 6 7 8 1 -1\n";
    const auto failure = [&](const std::string& more) {
        return failureOf(oneCube(first + more), Version::v3);
    };
    const std::string second = "1 0 1 0 1 1 0 0 0 1 0\n";
    EXPECT_EQ(failure(""), "m.cel:1: the file ends within the three lines of trimmed cell 1");
    EXPECT_EQ(failure(second), "m.cel:2: the file ends within the three lines of trimmed cell 1");
    EXPECT_EQ(
        failure("2 0 1 0 1 1 0 0 0 1 0\n"),
        "m.cel:2: expected a line of trimmed cell 1 with type flag 0, found cell 2 with flag 0");
    EXPECT_TRUE(
        failure(second + "1 0 0 0 0 0 3 0 0 1 0\n").starts_with("m.cel:1: cell 1: unknown type 3"));
    EXPECT_EQ(failure(second + "1 0 0 0 0 0 1 0 24 1 0\n"),
              "m.cel:1: cell 1: rotation 24: expected one in [0, 23]");
    EXPECT_EQ(failure("1 0 0 0 1 1 0 0 0 1 0\n1 0 0 0 0 0 1 0 0 1 0\n"),
              "m.cel:1: cell 1: label 10 is 0, where a trimmed cell of type 1 has a vertex");
}

TEST(Star3, refusesHostileBoundaries) {
    const auto failure = [](const std::string& boundary) {
        return failureOf(oneCube("1 1 2 3 4 5 6 7 8 1 1\n", boundary), Version::v3);
    };
    EXPECT_TRUE(failure("1 1 2 3\n").starts_with("m.bnd:1: expected 7 whole numbers"));
    EXPECT_TRUE(failure("1 1 2 3 9 1 0 WALL\n").starts_with("m.bnd:1: there is no vertex 9 in"));
    EXPECT_EQ(failure("1 1 2 2 2 1 0 WALL\n"), "m.bnd:1: fewer than three different vertices");
    EXPECT_EQ(failure("\n1 1 2 3 4 -1 0 WALL"), "m.bnd:2: region -1 is negative");
}

} // namespace polymesh::star
