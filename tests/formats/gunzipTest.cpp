// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gunzip.h"

#include "formats/fileBytes.h"
#include "libpolymesh/base/error.h"
#include "tests/support/temporaryDirectory.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace polymesh {

namespace {

std::string packed(const std::string& content) {
    const test::TemporaryDirectory folder;
    writeBytes(folder / "file.gz", content);
    std::ifstream file(folder / "file.gz", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A text that packs well, so that its size cannot be guessed from that of the packed one.
std::string longText() {
    std::string text;
    for (int i = 0; i < 20000; ++i)
        text += "vertex 0 0 " + std::to_string(i % 7) + '\n';
    return text;
}

TEST(Gunzip, givesTheContentBack) {
    for (const std::string& content : {std::string(), std::string("a"), longText()})
        EXPECT_EQ(gunzip(packed(content), "file.gz"), content);
}

TEST(Gunzip, joinsMembersWhateverTheSizeOfTheLast) {
    const std::string text = longText();
    EXPECT_EQ(gunzip(packed(text) + packed("end"), "file.gz"), text + "end");
    EXPECT_EQ(gunzip(packed("") + packed(text) + packed(text) + packed(""), "file.gz"),
              text + text);
}

TEST(Gunzip, ignoresWhatFollowsTheLastMember) {
    EXPECT_EQ(gunzip(packed("text") + std::string(1024, '\0'), "file.gz"), "text");
    EXPECT_EQ(gunzip(packed("text") + std::string(8, '\xff'), "file.gz"), "text")
        << "not four gigabytes of it";
}

TEST(Gunzip, refusesWhatIsCutOrDamagedAnywhere) {
    const std::string whole = packed(longText());
    for (std::size_t size = 0; size < whole.size(); size += size < 40 ? 1 : 97)
        EXPECT_THROW(gunzip(whole.substr(0, size), "file.gz"), InputError) << size;
    for (std::size_t i = 0; i < whole.size(); i += 53) {
        if (i >= 4 && i < 10) continue; // time and system: they say nothing about the content
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
        EXPECT_THROW(gunzip(damaged, "file.gz"), InputError) << i;
    }
    EXPECT_THROW(gunzip(packed("text") + whole.substr(0, whole.size() / 2), "file.gz"), InputError);
}

} // namespace

} // namespace polymesh
