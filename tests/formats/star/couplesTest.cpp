// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/cells3.h"
#include "tests/formats/star/starTestSupport.h"

#include <set>

namespace polymesh::star {

namespace {

using namespace test;

/// A cube of side 2 beside four of side 1: their faces tile one of its own. Vertices 1 to 18 are
/// those of the small ones, of which 10 to 18 are at x = 1; 19 to 22 the others of the big one.
Texts refinement() {
    std::string vertices;
    int number = 1;
    for (const int x : {0, 1})
        for (const int z : {0, 1, 2})
            for (const int y : {0, 1, 2})
                vertices += fmt::format("{} {}. {}. {}.\n", number++, x, y, z);
    for (const int z : {0, 2})
        for (const int y : {0, 2})
            vertices += fmt::format("{} 3. {}. {}.\n", number++, y, z);
    const auto at = [](int x, int y, int z) { return 1 + y + 3 * z + 9 * x; };
    std::string cells;
    for (const int z : {0, 1})
        for (const int y : {0, 1})
            cells += fmt::format("{} {} {} {} {} {} {} {} {} 1 1\n",
                                 1 + y + 2 * z,
                                 at(0, y, z),
                                 at(1, y, z),
                                 at(1, y + 1, z),
                                 at(0, y + 1, z),
                                 at(0, y, z + 1),
                                 at(1, y, z + 1),
                                 at(1, y + 1, z + 1),
                                 at(0, y + 1, z + 1));
    cells += "5 10 19 20 12 16 21 22 18 1 1\n";
    // Face 5 of the big cell is at its lowest x, face 6 of a small one at its highest.
    return {{".vrt", vertices}, {".cel", cells}, {".cpl", "1 5 1 5 5\n 1 6 2 6\n 3 6 4 6\n"}};
}

std::string failureWith(const std::string& couples) {
    Texts texts = refinement();
    texts[".cpl"] = couples;
    return failureOf(texts, Version::v3);
}

} // namespace

TEST(StarCouples, joinFacesThatTileAnother) {
    const StarMesh read = readTexts(refinement(), Version::v3);
    EXPECT_TRUE(read.notes.empty());
    EXPECT_TRUE(validate(read.mesh).empty());
    EXPECT_EQ(read.mesh.cellCount, 5);
    EXPECT_EQ(read.mesh.internalFaceCount(), 4 + 4);
    EXPECT_NEAR(volumeOf(read.mesh), 4 + 8, 1e-12);
    // As the mesh with hanging nodes that has the same geometry: five corners on four faces.
    std::multiset<Label> sizes;
    for (Label f = 0; f < read.mesh.faceCount(); ++f)
        sizes.insert(read.mesh.faces.rowSize(f));
    EXPECT_EQ(sizes.count(5), 4);
}

TEST(StarCouples, withoutThemTheFacesAreBoundary) {
    Texts texts = refinement();
    texts.erase(".cpl");
    EXPECT_EQ(readTexts(texts, Version::v3).mesh.internalFaceCount(), 4);
    texts[".cpl"] = "1 5 2 5 5 1 6 2 6 3 6 4 6\n2 2 1 5 5 1 6\n";
    const StarMesh read = readTexts(texts, Version::v3);
    EXPECT_EQ(read.mesh.internalFaceCount(), 4);
    ASSERT_EQ(read.notes.size(), 1);
    EXPECT_NE(read.notes[0].find("2 couples are not integral"), std::string::npos);
}

TEST(StarCouples, countFacesOfRotatedCellsFromTheirRotation) {
    // All rotations are different, and opposite faces stay opposite.
    std::set<std::vector<Label>> rotations;
    for (Label r = 0; r < rotationCount; ++r) {
        std::vector<Label> faces;
        for (Label f = 1; f <= 6; ++f)
            faces.push_back(unrotatedFace(r, f));
        rotations.insert(faces);
        for (std::size_t f = 0; f < 6; f += 2)
            EXPECT_EQ((faces[f] - 1) / 2, (faces[f + 1] - 1) / 2);
    }
    EXPECT_EQ(toLabel(rotations.size()), rotationCount);
}

TEST(StarCouples, refuseHostileFiles) {
    EXPECT_EQ(failureWith("1 5 1 5 5 1 6 2 6 3 6 4"),
              "m.cpl:1: the file ends where the number of a face should be");
    EXPECT_EQ(failureWith("1 5 1 5 5\n1 6 9 6 3 6 4 6\n"), "m.cpl:1: there is no cell 9");
    EXPECT_EQ(failureWith("1 5 1 5 7\n1 6 2 6 3 6 4 6\n"), "m.cpl:1: cell 5 has no face 7");
    EXPECT_TRUE(failureWith("1 -5 1 5 5\n").starts_with("m.cpl:1: the number of entries"));
    EXPECT_TRUE(failureWith("1 2000000000 1 5 5\n1 6\n").starts_with("m.cpl:2: the file ends"));
    EXPECT_EQ(failureWith("1 5 1 5 5 1 6 2 6 3 6 4 6\n2 5 1 5 5 1 6 2 6 3 6 4 6\n"),
              "m.cpl:2: couple 2: another couple replaces the same face");
}

} // namespace polymesh::star
