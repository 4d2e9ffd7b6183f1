// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/off/off.h"

#include "tests/formats/surfaceFilesTest.h"

namespace polymesh {

namespace {

using Triangles = std::vector<std::array<Label, 3>>;

TriSurface readCorpus(const std::string& name) {
    return readSurface(test::corpusFile("off", name));
}

TEST(OffReader, handlesItsCorpus) {
    test::expectCorpusIsHandled("off");
}

TEST(OffReader, passesOverCommentsColoursAndFacesOfTwoCorners) {
    const Triangles expected{{0, 1, 2}, {0, 2, 3}};
    EXPECT_EQ(readCorpus("odd-commentsAndBlankLines.off").triangles, expected);
    EXPECT_EQ(readCorpus("odd-colours.off").triangles, expected);
    EXPECT_EQ(readCorpus("odd-countsOnFirstLine.off").triangles, expected);
    EXPECT_EQ(readCorpus("odd-lineFaces.off").triangles, (Triangles{{0, 1, 2}}));
}

TEST(OffReader, namesTheLine) {
    EXPECT_NE(test::messageOf(test::corpusFile("off", "bad-indexNegative.off"))
                  .find("bad-indexNegative.off:7: a face has vertex -1, of 0 ... 3"),
              std::string::npos);
}

} // namespace

} // namespace polymesh
