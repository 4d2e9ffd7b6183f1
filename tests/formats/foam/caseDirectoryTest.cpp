// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/caseDirectory.h"

#include "foamTestSupport.h"

#include <gtest/gtest.h>

namespace polymesh::foam {
namespace {

using test::inputError;
using test::TemporaryDirectory;
using test::writeText;

WriteFormat formatOf(const std::string& controlDict,
                     const std::optional<std::string>& option = std::nullopt) {
    const TemporaryDirectory directory;
    writeText(directory.path() / "system/controlDict", controlDict);
    return writeFormat({directory.path(), ""}, option);
}

TEST(CaseDirectory, knowsWhereARegionsFilesAre) {
    const CaseDirectory plain{"case", ""};
    EXPECT_EQ(plain.polyMesh(), "case/constant/polyMesh");
    EXPECT_EQ(plain.system("blockInitDict"), "case/system/blockInitDict");
    const CaseDirectory region{"case", "fluid"};
    EXPECT_EQ(region.polyMesh(), "case/constant/fluid/polyMesh");
    EXPECT_EQ(region.system("blockInitDict"), "case/system/fluid/blockInitDict");
    EXPECT_EQ(region.controlDict(), "case/system/controlDict");
    EXPECT_EQ(region.triSurface(), "case/constant/triSurface");
}

TEST(WriteFormat, isBinaryWhenNothingIsAsked) {
    const TemporaryDirectory directory;
    EXPECT_EQ(writeFormat({directory.path(), ""}), WriteFormat{});
    EXPECT_EQ(formatOf("application x;"), WriteFormat{});
}

TEST(WriteFormat, followsControlDict) {
    EXPECT_EQ(formatOf("writeFormat ascii; writePrecision 12; writeCompression on;"),
              (WriteFormat{Format::ascii, 12, true}));
    EXPECT_EQ(formatOf("writeFormat ascii; writePrecision 6; writeCompression uncompressed;"),
              (WriteFormat{Format::ascii, 10, false}))
        << "points keep at least ten digits";
    EXPECT_EQ(formatOf("writeFormat binary; writeCompression compressed;"),
              (WriteFormat{Format::binary, WriteFormat::exact, false}))
        << "OpenFOAM does not compress binary";
}

TEST(WriteFormat, optionWins) {
    EXPECT_EQ(formatOf("writeFormat ascii; writeCompression on;", "binary"), WriteFormat{});
    EXPECT_EQ(formatOf("writePrecision 12;", "ascii.gz"), (WriteFormat{Format::ascii, 12, true}));
    EXPECT_EQ(formatOf("", "binary.gz"), (WriteFormat{Format::binary, WriteFormat::exact, true}));
}

TEST(WriteFormat, refusesWhatItDoesNotKnow) {
    EXPECT_EQ(inputError([] { formatOf("", "text"); }),
              "-format text: expected ascii, binary, ascii.gz or binary.gz");
    EXPECT_NE(inputError([] {
                  formatOf("writeFormat xml;");
              }).find("controlDict:1: writeFormat: found xml, expected ascii or binary"),
              std::string::npos);
}

TEST(WriteFormat, seesPastWhatOnlyOpenFoamCanEvaluate) {
    EXPECT_EQ(formatOf("endTime #calc \"2*$x\"; functions { #includeFunc residuals(p, U)\n }\n"
                       "#includeEtc \"x\"\nwriteFormat ascii;")
                  .format,
              Format::ascii);
}

} // namespace
} // namespace polymesh::foam
