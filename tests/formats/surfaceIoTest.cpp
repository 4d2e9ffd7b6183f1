// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/surfaceIo.h"

#include "libpolymesh/surface/edges.h"
#include "libpolymesh/surface/measure.h"
#include "tests/formats/surfaceFilesTest.h"
#include "tests/support/surfaces.h"

#include <cstdlib>
#include <fstream>

namespace polymesh {

namespace {

using Names = std::vector<std::string>;

const std::filesystem::path examples = "/usr/share/doc/openfoam-examples/examples";
const std::filesystem::path cgalData = "/usr/share/doc/libcgal-dev/data.tar.gz";

/// A sphere with coordinates of all digits and three regions that take turns.
TriSurface threeRegions() {
    TriSurface surface = test::sphere(3, 0.123456789, {1.0 / 3, -2.0 / 7, 1e-9});
    surface.regionNames = {"inlet", "outlet:1", "walls"};
    for (std::size_t t = 0; t < surface.region.size(); ++t)
        surface.region[t] = toLabel((t / 5) % 3);
    return surface;
}

TEST(SurfaceIo, givesBackEveryBitOfTextFormats) {
    const test::TemporaryDirectory folder;
    const TriSurface surface = threeRegions();
    for (const char* name : {"part.stl", "part.obj", "part.stl.gz", "part.obj.gz", "PART.OBJ"}) {
        writeSurface(surface, folder / name);
        EXPECT_EQ(test::contentOf(readSurface(folder / name)), test::contentOf(surface)) << name;
    }
}

TEST(SurfaceIo, givesBackEverythingButTheRegionsOfOffAndPly) {
    const test::TemporaryDirectory folder;
    TriSurface surface = threeRegions();
    for (const char* name : {"part.off", "part.ply", "part.off.gz", "part.ply.gz"}) {
        writeSurface(surface, folder / name);
        const TriSurface read = readSurface(folder / name);
        EXPECT_EQ(read.regionNames, Names{"part"}) << name;
        EXPECT_EQ(read.points, surface.points) << name;
        EXPECT_EQ(read.triangles, surface.triangles) << name;
    }
}

TEST(SurfaceIo, roundsBinaryStlTo32BitsAndNumbersItsRegions) {
    const test::TemporaryDirectory folder;
    TriSurface surface = threeRegions();
    writeSurface(surface, folder / "part.stlb");
    const TriSurface read = readSurface(folder / "part.stlb");
    EXPECT_EQ(read.regionNames, (Names{"zone0", "zone1", "zone2"}));
    EXPECT_EQ(read.region, surface.region);
    ASSERT_EQ(read.triangleCount(), surface.triangleCount());
    for (Label t = 0; t < read.triangleCount(); ++t)
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_EQ(read.corner(t, 1)[axis],
                      static_cast<double>(static_cast<float>(surface.corner(t, 1)[axis])));
}

TEST(SurfaceIo, readsThePackedFileWhenThePlainOneIsMissing) {
    const test::TemporaryDirectory folder;
    writeSurface(test::cuboid(), folder / "part.stl.gz");
    EXPECT_EQ(readSurface(folder / "part.stl").triangleCount(), 12);
}

TEST(SurfaceIo, saysWhichFileCannotBeRead) {
    const test::TemporaryDirectory folder;
    EXPECT_NE(test::messageOf(folder / "none.stl").find("none.stl: no such file"),
              std::string::npos);
    EXPECT_NE(test::messageOf(folder / "part.step").find("part.step: unknown surface format"),
              std::string::npos);
    std::filesystem::create_directory(folder / "part.stl");
    EXPECT_NE(test::messageOf(folder / "part.stl").find("is a folder"), std::string::npos);
    EXPECT_THROW(writeSurface(test::cuboid(), folder / "part.step"), InputError);
}

TEST(SurfaceIo, leavesTheOldFileAndNoOtherWhenItCannotWrite) {
    const test::TemporaryDirectory folder;
    EXPECT_THROW(writeSurface(test::cuboid(), folder / "none/part.stl"), WorkError);
    std::filesystem::create_directories(folder / "part.stl/full"); // cannot be replaced by a file
    EXPECT_THROW(writeSurface(test::cuboid(), folder / "part.stl"), WorkError);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(SurfaceIo, saysWhenTheDiskIsFull) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    const test::TemporaryDirectory folder;
    // The temporary sibling's name is known: let it lead to the full device.
    const auto temporary = folder / fmt::format("part.stl.{}.tmp", getpid());
    std::filesystem::create_symlink("/dev/full", temporary);
    EXPECT_THROW(writeSurface(threeRegions(), folder / "part.stl"), WorkError);
    EXPECT_FALSE(std::filesystem::exists(folder / "part.stl"));
}

TEST(SurfaceIo, readsTheFlangeOfOpenFoam) {
    const auto file = examples / "resources/geometry/flange.stl.gz";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "openfoam-examples is not installed";
    const TriSurface surface = readSurface(file);
    EXPECT_EQ(surface.regionNames, (Names{"patch1", "patch2", "patch3", "patch4"}));
    EXPECT_EQ(surface.triangleCount(), 6468);
    EXPECT_EQ(surface.pointCount(), 3228);
    EXPECT_EQ(pairEdges(surface).edges.size(), 9702U);
}

TEST(SurfaceIo, readsTheGroupsOfTheMotorBike) {
    const auto file = examples / "resources/geometry/motorBike.obj.gz";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "openfoam-examples is not installed";
    const TriSurface surface = readSurface(file);
    EXPECT_EQ(surface.triangleCount(), 331653);
    EXPECT_EQ(surface.regionNames.size(), 67U);
    EXPECT_EQ(surface.regionNames.front(), "frt-fairing:001%1");
}

TEST(SurfaceIo, readsTheMeshesOfCgal) {
    if (!std::filesystem::exists(cgalData)) GTEST_SKIP() << "libcgal-demo is not installed";
    const test::TemporaryDirectory folder;
    const std::string command =
        fmt::format("tar -xzf {} -C {} data/meshes/joint.off data/meshes/spool.off",
                    cgalData.string(),
                    folder.path().string());
    ASSERT_EQ(std::system(command.c_str()), 0);
    const TriSurface joint = readSurface(folder / "data/meshes/joint.off");
    EXPECT_EQ(joint.triangleCount(), 446);
    EXPECT_EQ(joint.pointCount(), 221);
    EXPECT_NEAR(measure(joint).volume, 0.3595, 5e-5);
    EXPECT_EQ(readSurface(folder / "data/meshes/spool.off").triangleCount(), 1294);
}

} // namespace

} // namespace polymesh
