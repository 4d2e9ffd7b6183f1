// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/fileTexts.h"
#include "tests/formats/star/starTestSupport.h"
#include "tests/fuzz/starFuzz.h"

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

} // namespace polymesh::star
