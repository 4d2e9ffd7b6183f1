// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Both ways on surfaces of the packages openfoam-examples and libcgal-demo.

#include "formats/surfaceIo.h"
#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/surface/orient.h"
#include "tests/libpolymesh/trimCell/bothWays.h"
#include "tests/support/temporaryDirectory.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace polymesh::test {
namespace {

namespace fs = std::filesystem;

const fs::path examples = "/usr/share/doc/openfoam-examples/examples/resources/geometry";
const fs::path cgalData = "/usr/share/doc/libcgal-dev/data.tar.gz";

/// A box of about `cells` cells round the surface; `margin` in cell sizes.
PolyMesh boxOf(const TriSurface& surface, double cells, double margin) {
    const Box bounds = boundingBox(surface.points);
    const Vec3 size = bounds.size();
    const double cellSize = std::cbrt(size.x * size.y * size.z / cells);
    return cartesianMesh(boxAround(bounds, cellSize, margin * cellSize));
}

/// Plain, with warped cells, and with grid planes on the surface's bounding box.
void expectSameInThreeMeshes(TriSurface surface, const std::string& name) {
    orientSurface(surface);
    const PolyMesh mesh = boxOf(surface, 500, 0.25);
    const Vec3 size = boundingBox(surface.points).size();
    const double cellSize = std::cbrt(size.x * size.y * size.z / 500);
    expectSameCut(mesh, surface, name);
    expectSameCut(jittered(mesh, 0.15 * cellSize), surface, name + ", warped");
    const Box bounds = boundingBox(surface.points);
    expectSameCut(cartesianMesh({bounds, {7, 8, 9}}), surface, name + ", on grid planes");
}

TEST(CutByCells, givesTheSameCutOfOpenfoamExamples) {
    bool isAny = false;
    for (const char* name : {"flange.stl.gz", "NACA0012.obj.gz"}) {
        if (!fs::exists(examples / name)) continue;
        isAny = true;
        expectSameInThreeMeshes(readSurface(examples / name), name);
    }
    if (!isAny) GTEST_SKIP() << "openfoam-examples is not installed";
}

TEST(CutByCells, givesTheSameCutOfCgalDemo) {
    if (!fs::exists(cgalData)) GTEST_SKIP() << "libcgal-demo is not installed";
    const TemporaryDirectory folder;
    for (const std::string name : {"elephant", "couplingdown", "joint", "knot1"}) {
        const std::string file = "data/meshes/" + name + ".off";
        const std::string command =
            "tar xzf " + cgalData.string() + " -C " + folder.path().string() + " " + file;
        ASSERT_EQ(std::system(command.c_str()), 0);
        expectSameInThreeMeshes(readSurface(folder.path() / file), name);
    }
}

} // namespace
} // namespace polymesh::test
