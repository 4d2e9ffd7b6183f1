// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/sets.h"

#include "foamTestSupport.h"

#include <gtest/gtest.h>

namespace polymesh::foam {
namespace {

using test::inputError;
using test::readText;
using test::TemporaryDirectory;
using test::writeText;

TEST(Sets, comeBackAscending) {
    const TemporaryDirectory directory;
    const std::vector<Label> labels{7, 3, 3, 100};
    for (const SetKind kind : {SetKind::point, SetKind::face, SetKind::cell}) {
        writeSet(directory.path(), kind, "bad", labels);
        EXPECT_EQ(readSet(directory.path(), kind, "bad"), (std::vector<Label>{3, 7, 100}));
    }
    writeSet(directory.path(), SetKind::cell, "none", {});
    EXPECT_TRUE(readSet(directory.path(), SetKind::cell, "none").empty());
}

TEST(Sets, areTextOfTheRightClassAndLeaveNothingElse) {
    const TemporaryDirectory directory;
    writeSet(directory.path(), SetKind::face, "bad", std::vector<Label>{1});
    const std::string text = readText(directory.path() / "sets/bad");
    EXPECT_NE(text.find("class       faceSet;"), std::string::npos);
    EXPECT_NE(text.find("format      ascii;"), std::string::npos);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory.path() / "sets"), {}), 1);
}

TEST(Sets, ofAnotherKindOrMissingAreRefused) {
    const TemporaryDirectory directory;
    writeSet(directory.path(), SetKind::face, "bad", std::vector<Label>{1});
    EXPECT_NE(inputError([&] {
                  readSet(directory.path(), SetKind::cell, "bad");
              }).find("class 'faceSet': expected cellSet"),
              std::string::npos);
    EXPECT_NE(
        inputError([&] { readSet(directory.path(), SetKind::cell, "gone"); }).find("no such file"),
        std::string::npos);
}

TEST(Sets, asOpenFoamWritesThemAreTextUnderABinaryHeader) {
    const TemporaryDirectory directory;
    writeText(
        directory.path() / "sets/c",
        "FoamFile { version 2.0; format binary; class cellSet; object c; }\n\n3\n(\n8\n1\n4\n)\n");
    EXPECT_EQ(readSet(directory.path(), SetKind::cell, "c"), (std::vector<Label>{1, 4, 8}));
}

} // namespace
} // namespace polymesh::foam
