// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/stl/stl.h"

#include "tests/formats/surfaceFilesTest.h"

namespace polymesh {

namespace {

using Names = std::vector<std::string>;

TriSurface readCorpus(const std::string& name) {
    return readSurface(test::corpusFile("stl", name));
}

TEST(StlReader, handlesItsCorpus) {
    test::expectCorpusIsHandled("stl");
}

TEST(StlReader, tellsBinaryFilesByTheirSizeNotByTheWordSolid) {
    const TriSurface surface = readCorpus("odd-solidBinary.stl");
    EXPECT_EQ(surface.triangleCount(), 2);
    EXPECT_EQ(surface.regionNames, Names{"odd-solidBinary"});
}

TEST(StlReader, makesRegionsOfDifferentAttributesInTheOrderOfTheFile) {
    const TriSurface surface = readCorpus("odd-binaryZones.stl");
    EXPECT_EQ(surface.regionNames, (Names{"zone0", "zone1"}));
    EXPECT_EQ(surface.region, (std::vector<Label>{0, 1}));
}

TEST(StlReader, makesWordsOfSolidsNames) {
    EXPECT_EQ(readCorpus("odd-strangeNames.stl").regionNames,
              (Names{"myfirstpart1", "_12", "odd-strangeNames"}));
}

TEST(StlReader, takesTwoSolidsOfOneNameForOneRegion) {
    const TriSurface surface = readCorpus("odd-oneSolidTwice.stl");
    EXPECT_EQ(surface.regionNames, Names{"a"});
    EXPECT_EQ(surface.triangleCount(), 2);
}

TEST(StlReader, dropsFacetsWithEqualCorners) {
    EXPECT_EQ(readCorpus("odd-degenerateFacet.stl").triangleCount(), 1);
}

TEST(StlReader, readsNumbersCorrectlyRounded) {
    const std::string text = "solid a\nfacet normal 0 0 0\nouter loop\n"
                             "vertex 0.1 9007199254740993 1.7976931348623157e308\n"
                             "vertex +1e-5 4.9e-324 -2.2250738585072011e-308\n"
                             "vertex 3 1e23 123456789.123456789\n"
                             "endloop\nendfacet\nendsolid a\n";
    const TriSurface surface = stl::read(text, "x.stl", "x");
    EXPECT_EQ(surface.points[0], (Vec3{0.1, 9007199254740992, 1.7976931348623157e308}));
    EXPECT_EQ(surface.points[1], (Vec3{1e-5, 5e-324, -2.2250738585072011e-308}));
    EXPECT_EQ(surface.points[2], (Vec3{3, 1e23, 123456789.123456789}));
}

TEST(StlReader, namesTheLine) {
    EXPECT_NE(test::messageOf(test::corpusFile("stl", "bad-nanVertex.stl"))
                  .find("bad-nanVertex.stl:5: expected a finite number, found 'nan'"),
              std::string::npos);
    EXPECT_NE(test::messageOf(test::corpusFile("stl", "bad-wrongWord.stl"))
                  .find("stl:7: expected 'endloop', found 'endlop'"),
              std::string::npos);
}

TEST(StlReader, namesTheByte) {
    EXPECT_NE(test::messageOf(test::corpusFile("stl", "bad-binaryNan.stl")).find("at byte 108"),
              std::string::npos);
    EXPECT_NE(test::messageOf(test::corpusFile("stl", "bad-binaryCountLies.stl"))
                  .find("promises 214748364834 bytes, the file has 134"),
              std::string::npos);
}

TEST(StlReader, saysThatAPackedFileIsDamaged) {
    EXPECT_NE(test::messageOf(test::corpusFile("stl", "bad-gzipCut.stl.gz")).find("cut short"),
              std::string::npos);
    EXPECT_NE(
        test::messageOf(test::corpusFile("stl", "bad-notGzip.stl.gz")).find("not a gzip file"),
        std::string::npos);
}

} // namespace

} // namespace polymesh
