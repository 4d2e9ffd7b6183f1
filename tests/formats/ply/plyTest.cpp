// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/ply/ply.h"

#include "tests/formats/surfaceFilesTest.h"

namespace polymesh {

namespace {

using Triangles = std::vector<std::array<Label, 3>>;

TriSurface readCorpus(const std::string& name) {
    return readSurface(test::corpusFile("ply", name));
}

TEST(PlyReader, handlesItsCorpus) {
    test::expectCorpusIsHandled("ply");
}

TEST(PlyReader, readsBothByteOrders) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (const char* name : {"odd-bigEndian.ply", "odd-littleEndianWindowsHeader.ply"}) {
        EXPECT_EQ(readCorpus(name).points, points) << name;
        EXPECT_EQ(readCorpus(name).triangles, (Triangles{{0, 1, 2}, {0, 2, 3}})) << name;
    }
}

TEST(PlyReader, beginsTheBodyRightAfterTheHeadersLineEnd) {
    const TriSurface surface = readCorpus("odd-bodyBeginsWithLineEnd.ply");
    EXPECT_EQ(surface.points[0], (Vec3{0x1.001414p0, 0, 0}));
    EXPECT_EQ(surface.triangleCount(), 2);
}

TEST(PlyReader, passesOverOtherElementsAndProperties) {
    const TriSurface surface = readCorpus("odd-otherElements.ply");
    EXPECT_EQ(surface.points, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(surface.triangles, (Triangles{{0, 1, 2}}));
}

TEST(PlyReader, namesTheLineOrTheByte) {
    EXPECT_NE(test::messageOf(test::corpusFile("ply", "bad-indexTooHigh.ply"))
                  .find("bad-indexTooHigh.ply:16: a face has vertex 4, of 0 ... 3"),
              std::string::npos);
    EXPECT_NE(test::messageOf(test::corpusFile("ply", "bad-binaryCut.ply")).find("at byte "),
              std::string::npos);
}

} // namespace

} // namespace polymesh
