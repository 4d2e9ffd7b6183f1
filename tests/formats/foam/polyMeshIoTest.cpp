// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/polyMeshIo.h"

#include "foamTestSupport.h"
#include "formats/foam/polyMeshWriter.h"
#include "libpolymesh/base/threadLimit.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

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

/// Puts a list file with the given class and body into the mesh.
void replaceFile(const fs::path& mesh,
                 const std::string& name,
                 const std::string& className,
                 const std::string& body) {
    fs::remove(mesh / name);
    writeText(mesh / name,
              "FoamFile { version 2.0; format ascii; class " + className + "; object " + name +
                  "; }\n" + body);
}

/// An ascii mesh of two cubes in a fresh directory.
struct MeshOnDisk {
    MeshOnDisk() : path(directory.path() / "constant/polyMesh") {
        writePolyMesh(twoCubes(), path, {Format::ascii, WriteFormat::exact, false});
    }

    TemporaryDirectory directory;
    fs::path path;
};

std::vector<fs::path> corpus() {
    std::vector<fs::path> found;
    const fs::path folder = fs::path(POLYMESH_CORPUS) / "foam/polyMesh";
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

class HostileMesh : public testing::TestWithParam<fs::path> {};

INSTANTIATE_TEST_SUITE_P(ReadPolyMesh,
                         HostileMesh,
                         testing::ValuesIn(corpus()),
                         [](const auto& test) { return test.param.filename().string(); });

TEST_P(HostileMesh, isRefusedWithItsMessage) {
    const MeshOnDisk mesh;
    for (const fs::directory_entry& entry : fs::directory_iterator(GetParam())) {
        fs::remove(mesh.path / entry.path().stem()); // a .gz comes after the plain file
        fs::copy_file(entry.path(),
                      mesh.path / entry.path().filename(),
                      fs::copy_options::overwrite_existing);
    }
    std::string expected = readText(GetParam() / "message");
    expected.pop_back();
    const std::string message = inputError([&] { (void)readPolyMesh(mesh.path); });
    EXPECT_NE(message.find(expected), std::string::npos)
        << "found:    " << message << "\nexpected: " << expected;
    EXPECT_TRUE(message.starts_with(mesh.path.string())) << message;
}

TEST(ReadPolyMesh, saysWhatIsMissing) {
    const MeshOnDisk mesh;
    EXPECT_EQ(inputError([&] { (void)readPolyMesh(mesh.path / "no"); }),
              (mesh.path / "no").string() +
                  ": no such directory; it should hold a mesh (points, faces, owner, ...)");
    for (const char* name : {"points", "faces", "owner", "neighbour", "boundary"}) {
        const MeshOnDisk incomplete;
        fs::remove(incomplete.path / name);
        EXPECT_EQ(inputError([&] { (void)readPolyMesh(incomplete.path); }),
                  (incomplete.path / name).string() + ": no such file, and no " + name +
                      ".gz either");
    }
}

TEST(ReadPolyMesh, takesThePlainFileBeforeTheCompressedOne) {
    const MeshOnDisk mesh;
    writeText(mesh.path / "points.gz", "nonsense");
    EXPECT_EQ(readPolyMesh(mesh.path), twoCubes());
}

TEST(ReadPolyMesh, acceptsEverySpellingOfLists) {
    const MeshOnDisk mesh;
    replaceFile(
        mesh.path, "owner", "labelList", "// all\n/* of */ (0 0 1 0 0 0 0 +1 1 1 1) // end");
    replaceFile(mesh.path, "neighbour", "labelList", "\r\n1 /* one ( */ { 1 }\r\n");
    EXPECT_EQ(readPolyMesh(mesh.path), twoCubes());
    replaceFile(mesh.path, "neighbour", "labelList", "11(1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1)");
    EXPECT_EQ(readPolyMesh(mesh.path), twoCubes()) << "filled up with -1 as in old meshes";
}

TEST(ReadPolyMesh, acceptsCompactFacesAsText) {
    const MeshOnDisk mesh;
    const Rows<Label> faces = twoCubes().faces;
    std::string text = fmt::format("{} ({}) {} ({})",
                                   faces.offsets.size(),
                                   fmt::join(faces.offsets, " "),
                                   faces.values.size(),
                                   fmt::join(faces.values, "\n"));
    replaceFile(mesh.path, "faces", "faceCompactList", text);
    EXPECT_EQ(readPolyMesh(mesh.path), twoCubes());
    text = "(";
    for (Label face = 0; face < faces.size(); ++face)
        text += fmt::format("({})/**/", fmt::join(faces[face], " "));
    replaceFile(mesh.path, "faces", "faceList", text + ")");
    EXPECT_EQ(readPolyMesh(mesh.path), twoCubes()) << "without counts";
}

template<class T>
std::string rawBytes(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

void replaceBinaryFile(const fs::path& mesh,
                       const std::string& name,
                       const std::string& className,
                       const std::string& body) {
    writeText(mesh / name,
              "FoamFile { version 2.0; format binary; class " + className +
                  "; arch \"LSB;label=64;scalar=32\"; object " + name + "; }\n" + body);
}

TEST(ReadPolyMesh, acceptsOtherLabelAndScalarSizes) {
    const MeshOnDisk disk;
    PolyMesh mesh = twoCubes();
    std::vector<float> coordinates;
    for (Vec3& p : mesh.points)
        for (int axis = 0; axis < 3; ++axis) {
            coordinates.push_back(static_cast<float>(p[axis]));
            p[axis] = static_cast<double>(coordinates.back());
        }
    replaceBinaryFile(disk.path, "points", "vectorField", "12(" + rawBytes(coordinates) + ")");
    std::string faces = "\n11\n(";
    for (Label face = 0; face < mesh.faceCount(); ++face) {
        const std::vector<std::int64_t> wide(mesh.faces[face].begin(), mesh.faces[face].end());
        faces += fmt::format("\n{}\n(", wide.size()) + rawBytes(wide) + ")";
    }
    replaceBinaryFile(disk.path, "faces", "faceList", faces + ")");
    const std::vector<std::int64_t> owner(mesh.owner.begin(), mesh.owner.end());
    replaceBinaryFile(disk.path, "owner", "labelList", "\n11\n(" + rawBytes(owner) + ")\n");
    EXPECT_EQ(readPolyMesh(disk.path), mesh);
}

TEST(ReadPolyMesh, readsTextLongerThanItsWindow) {
    const MeshOnDisk disk;
    PolyMesh mesh = twoCubes();
    std::string text = "// " + std::string(600000, 'x') + "\n12(";
    for (const Vec3& p : mesh.points)
        text += std::string(100000, ' ') + fmt::format("({} {} {})", p.x, p.y, p.z);
    replaceFile(disk.path, "points", "vectorField", text + ")");
    EXPECT_EQ(readPolyMesh(disk.path), mesh);
    text.resize(text.size() - 3);
    replaceFile(disk.path, "points", "vectorField", "\n\n" + text + "x x)");
    EXPECT_NE(inputError([&] { (void)readPolyMesh(disk.path); }).find("points:5: "),
              std::string::npos);
}

TEST(ReadPolyMesh, sortsZonesAndTakesTheFlipsAlong) {
    const MeshOnDisk disk;
    replaceFile(disk.path,
                "faceZones",
                "ZoneMesh",
                "1 (z { note \"a;}\"; type faceZone; flipMap List<bool> 4(1 0 true off);\n"
                "faceLabels List<label> 4(7 3 9 3); extra { a (1 2); } })");
    const PolyMesh mesh = readPolyMesh(disk.path);
    ASSERT_EQ(mesh.faceZones.size(), 1U);
    EXPECT_EQ(mesh.faceZones[0], (Zone{"z", {3, 7, 9}, {false, true, true}}));
}

TEST(WritePolyMesh, roundsToThePrecisionThatIsAskedFor) {
    const TemporaryDirectory directory;
    PolyMesh mesh = twoCubes();
    writePolyMesh(mesh, directory.path() / "m", {Format::ascii, 10, false});
    EXPECT_NE(readText(directory.path() / "m/points").find("(0 0.3333333333 0)"),
              std::string::npos);
    EXPECT_NEAR(readPolyMesh(directory.path() / "m").points[3].y, 1.0 / 3, 1e-10);
}

TEST(WritePolyMesh, notesCountsInOwnerAndNeighbour) {
    const TemporaryDirectory directory;
    const fs::path path = directory.path() / "case/constant/fluid/polyMesh";
    writePolyMesh(twoCubes(), path, {});
    for (const char* name : {"owner", "neighbour"}) {
        const std::string text = readText(path / name);
        EXPECT_NE(text.find("note        \"nPoints:12  nCells:2  nFaces:11  nInternalFaces:1\""),
                  std::string::npos);
        EXPECT_NE(text.find("location    \"constant/fluid/polyMesh\""), std::string::npos);
    }
}

TEST_P(EachFormat, isTheSameForAnyNumberOfThreadsAndWhenStreamed) {
    const TemporaryDirectory directory;
    constexpr Label pointCount = 600000; // several blocks and batches
    constexpr Label faceCount = 100000;
    PolyMesh mesh;
    for (Label i = 0; i < pointCount; ++i)
        mesh.points.push_back({i * 0.1, i / 3.0, -1.0 * i});
    for (Label i = 0; i < faceCount; ++i) {
        mesh.faces.add(std::array{i, i + 1, i + 2, i + 3});
        mesh.owner.push_back(i / 6);
    }
    mesh.patches = {{"all", "patch", 0, faceCount, {}}};
    mesh.cellCount = mesh.owner.back() + 1;
    const auto pathOf = [&](const char* name) {
        return directory.path() / name / "constant/polyMesh"; // the headers hold the last part
    };
    for (const auto& [name, threads] : {std::pair("one", 1U), std::pair("four", 4U)}) {
        const ThreadLimit limit(threads);
        writePolyMesh(mesh, pathOf(name), GetParam().format);
        EXPECT_EQ(readPolyMesh(pathOf(name)), mesh);
    }
    PolyMeshWriter writer(
        pathOf("streamed"), GetParam().format, {pointCount, mesh.cellCount, faceCount, 0});
    writer.writePoints([&](Label first, std::span<Vec3> block) {
        for (Vec3& p : block)
            p = mesh.points[index(first++)];
    });
    writer.writeQuads([](Label first, std::span<Quad> block) {
        for (Quad& quad : block) {
            quad = {first, first + 1, first + 2, first + 3};
            ++first;
        }
    });
    writer.writeOwner([](Label first, std::span<Label> block) {
        for (Label& cell : block)
            cell = first++ / 6;
    });
    writer.writeNeighbour([](Label, std::span<Label>) {});
    writer.writePatches(mesh.patches);
    writer.commit();
    for (const fs::directory_entry& entry : fs::directory_iterator(pathOf("one"))) {
        const fs::path name = entry.path().filename();
        const std::string bytes = readText(entry.path());
        EXPECT_TRUE(readText(pathOf("four") / name) == bytes) << name;
        EXPECT_TRUE(readText(pathOf("streamed") / name) == bytes) << name;
    }
}

} // namespace
} // namespace polymesh::foam
