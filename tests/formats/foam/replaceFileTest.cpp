// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/replaceFile.h"

#include "foamTestSupport.h"
#include "libpolymesh/base/error.h"

#include <gtest/gtest.h>

namespace polymesh::foam {
namespace {

TEST(ReplaceFile, makesTheFoldersAndReplacesWhatIsThere) {
    const test::TemporaryDirectory directory;
    const auto path = directory.path() / "a/b/text";
    for (const char* text : {"one", "two"}) {
        replaceFile(path, [&](OutputFile& file) { file.write(text); });
        EXPECT_EQ(test::readText(path), text);
    }
}

TEST(ReplaceFile, leavesTheOldOneAloneWhenWritingFails) {
    const test::TemporaryDirectory directory;
    const auto path = directory.path() / "text";
    test::writeText(path, "old");
    const auto fail = [](OutputFile& file) {
        file.write("half of the n");
        throw WorkError("no more");
    };
    EXPECT_THROW(replaceFile(path, fail), WorkError);
    EXPECT_EQ(test::readText(path), "old");
    const auto files = std::filesystem::directory_iterator(directory.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

} // namespace
} // namespace polymesh::foam
