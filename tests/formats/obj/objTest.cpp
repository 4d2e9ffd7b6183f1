// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/obj/obj.h"

#include "tests/formats/surfaceFilesTest.h"

namespace polymesh {

namespace {

using Names = std::vector<std::string>;
using Triangles = std::vector<std::array<Label, 3>>;

TriSurface readCorpus(const std::string& name) {
    return readSurface(test::corpusFile("obj", name));
}

TEST(ObjReader, handlesItsCorpus) {
    test::expectCorpusIsHandled("obj");
}

TEST(ObjReader, countsNegativeIndicesFromTheLastVertexBack) {
    EXPECT_EQ(readCorpus("odd-negative.obj").triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ObjReader, passesOverTexturesAndNormals) {
    EXPECT_EQ(readCorpus("odd-texturesAndNormals.obj").triangles,
              (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}}));
}

TEST(ObjReader, followsBackslashesToTheNextLine) {
    EXPECT_EQ(readCorpus("odd-continued.obj").triangles,
              (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
}

TEST(ObjReader, makesRegionsOfGroupsFirst) {
    const TriSurface surface = readCorpus("odd-groups.obj");
    EXPECT_EQ(surface.regionNames, (Names{"odd-groups", "first", "third"}));
    EXPECT_EQ(surface.region, (std::vector<Label>{1, 0, 2}));
}

TEST(ObjReader, makesRegionsOfObjectsWhenThereAreNoGroups) {
    EXPECT_EQ(readCorpus("odd-objects.obj").regionNames, (Names{"one", "two"}));
}

TEST(ObjReader, makesRegionsOfMaterialsWhenThereIsNothingElse) {
    EXPECT_EQ(readCorpus("odd-materials.obj").regionNames, (Names{"steel", "glass"}));
}

TEST(ObjReader, namesTheLine) {
    EXPECT_NE(test::messageOf(test::corpusFile("obj", "bad-indexTooHigh.obj"))
                  .find("bad-indexTooHigh.obj:5: a face has vertex 5, of 4 so far"),
              std::string::npos);
}

} // namespace

} // namespace polymesh
