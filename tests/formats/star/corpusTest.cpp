// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/fileTexts.h"
#include "tests/formats/star/starTestSupport.h"
#include "tests/fuzz/starFuzz.h"

#include <random>

namespace polymesh::star {

TEST(StarCorpus, isReadOrRefusedAsItsNamesSay) {
    int count = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(POLYMESH_CORPUS) / "star")) {
        const std::string name = entry.path().filename();
        SCOPED_TRACE(name);
        const bool isVersion4 = entry.path().extension() == ".star4";
        const auto parts = fuzz::partsOf(test::readText(entry.path()));
        test::Texts texts;
        std::size_t i = 0;
        for (const char* ending : {".vrt", ".cel", ".bnd", ".inp", ".cpl"})
            texts[ending] = parts[i++];
        if (isVersion4 && texts[".bnd"].empty()) texts.erase(".bnd");
        const std::string failure = test::failureOf(texts, isVersion4 ? Version::v4 : Version::v3);
        EXPECT_TRUE(!name.starts_with("bad-") || !failure.empty());
        EXPECT_TRUE(!name.starts_with("odd-") || failure.empty()) << failure;
        ++count;
    }
    EXPECT_GE(count, 4);
}

/// What a fuzzer does, a little of it and always the same: bytes of the files are changed, taken
/// away, doubled and swapped.
TEST(StarCorpus, withAnyChangeIsReadOrRefused) {
    std::mt19937 random(1);
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(POLYMESH_CORPUS) / "star")) {
        ++files;
        const bool isVersion4 = entry.path().extension() == ".star4";
        const std::string given = test::readText(entry.path());
        for (int i = 0; i < 500; ++i) {
            std::string text = given;
            for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
                const std::size_t at = random() % text.size();
                const std::size_t size = 1 + random() % 12;
                const std::string other = text.substr(random() % text.size(), size);
                constexpr std::string_view bytes = "0123456789-+. \n\fe{";
                if (random() % 2 == 0)
                    text[at] = bytes[random() % bytes.size()];
                else
                    text.replace(at, random() % 2 == 0 ? size : 0, other);
            }
            // Ends the program when a law is broken.
            fuzz::testStar(reinterpret_cast<const std::uint8_t*>(text.data()),
                           text.size(),
                           isVersion4 ? Version::v4 : Version::v3);
        }
    }
    EXPECT_GT(files, 0);
}

} // namespace polymesh::star
