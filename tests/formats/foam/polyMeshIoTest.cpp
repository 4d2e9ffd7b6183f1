// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/polyMeshIo.h"

#include "foamTestSupport.h"
#include "formats/foam/polyMeshWriter.h"
#include "libpolymesh/base/parallel.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>

namespace polymesh::foam {
namespace {

namespace fs = std::filesystem;
using test::inputError;
using test::readText;
using test::TemporaryDirectory;
using test::twoCubes;
using test::writeText;

struct NamedFormat {
    const char* name;
    WriteFormat format;
};

const NamedFormat allFormats[] = {{"ascii", {Format::ascii, WriteFormat::exact, false}},
                                  {"asciiGz", {Format::ascii, WriteFormat::exact, true}},
                                  {"binary", {Format::binary, WriteFormat::exact, false}},
                                  {"binaryGz", {Format::binary, WriteFormat::exact, true}}};

class EachFormat : public testing::TestWithParam<NamedFormat> {};

INSTANTIATE_TEST_SUITE_P(WritePolyMesh,
                         EachFormat,
                         testing::ValuesIn(allFormats),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(EachFormat, comesBackAsItWas) {
    const TemporaryDirectory directory;
    const fs::path path = directory.path() / "constant/polyMesh";
    writePolyMesh(twoCubes(), path, GetParam().format);
    EXPECT_EQ(readPolyMesh(path), twoCubes());
    EXPECT_EQ(fs::exists(path / "points.gz"), GetParam().format.compress);
    EXPECT_TRUE(fs::exists(path / "boundary")) << "boundary is never compressed";
}

TEST_P(EachFormat, carriesAMeshWithoutInternalFacesAndAnEmptyOne) {
    const TemporaryDirectory directory;
    PolyMesh mesh = twoCubes();
    mesh.neighbour.clear();
    mesh.owner.assign(mesh.owner.size(), 0);
    mesh.cellCount = 1;
    mesh.patches.front().start = 0;
    mesh.patches.front().size = 2;
    mesh.cellZones.clear();
    writePolyMesh(mesh, directory.path() / "one", GetParam().format);
    EXPECT_EQ(readPolyMesh(directory.path() / "one"), mesh);
    writePolyMesh({}, directory.path() / "empty", GetParam().format);
    EXPECT_EQ(readPolyMesh(directory.path() / "empty"), PolyMesh{});
}

} // namespace
} // namespace polymesh::foam
