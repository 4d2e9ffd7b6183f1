// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/reference/tetgen.h"

#include "libpolymesh/mesh/topology.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <numeric>

namespace polymesh {
namespace {

class Tetgen : public testing::Test {
protected:
    void SetUp() override {
        if (!hasTetgen()) GTEST_SKIP() << "built without TetGen";
    }
};

std::vector<std::optional<double>> volumes(const PolyMesh& mesh) {
    std::vector<Label> cells(index(mesh.cellCount));
    std::iota(cells.begin(), cells.end(), Label{0});
    return tetgenVolumes(mesh, cellFaces(mesh), cells);
}

TEST_F(Tetgen, measuresEveryShape) {
    EXPECT_NEAR(volumes(test::unitCube())[0].value(), 1, 1e-14);
    EXPECT_NEAR(volumes(test::pyramid())[0].value(), 1.0 / 3, 1e-14);
    EXPECT_NEAR(volumes(test::lShapedCell())[0].value(), 3, 1e-14);
    EXPECT_NEAR(volumes(test::hangingNodes())[4].value(), 8, 1e-13);
    EXPECT_EQ(volumes(test::prismFan(9)).size(), 9U);
}

TEST_F(Tetgen, failsOnOpenCellsAndGoesOn) {
    PolyMesh mesh = test::box(3, 1, 1);
    mesh.points[1] = mesh.points[2]; // collapses faces of cells 0 and 1
    const auto found = volumes(mesh);
    ASSERT_EQ(found.size(), 3U);
    EXPECT_NEAR(found[2].value(), 1.0 / 3, 1e-14);
    EXPECT_FALSE(volumes(test::openCell())[0].has_value());
}

TEST_F(Tetgen, measuresASurface) {
    EXPECT_NEAR(tetgenVolume(test::cuboid({0, 0, 0}, {1, 2, 3})).value(), 6, 1e-13);
}

TEST_F(Tetgen, fillsASurfaceAndLeavesItsTriangles) {
    const auto fill = tetgenTetrahedraliser();
    const TriSurface box = test::cuboid({0, 0, 0}, {1, 2, 3});
    for (int i = 0; i < 2; ++i) {
        const auto tets = fill(box);
        ASSERT_TRUE(tets.has_value());
        double volume = 0;
        for (const auto& t : tets->tetrahedra) {
            std::array<Vec3, 4> p;
            for (std::size_t k = 0; k < 4; ++k)
                p[k] = t[k] < box.pointCount() ? box.points[index(t[k])]
                                               : tets->newPoints[index(t[k] - box.pointCount())];
            volume += std::abs(dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0]))) / 6;
        }
        EXPECT_NEAR(volume, 6, 1e-13);
        TriSurface open = box; // in between: TetGen fails, and is asked again
        open.triangles.pop_back();
        EXPECT_FALSE(fill(open).has_value());
    }
}

TEST_F(Tetgen, leavesOutCavities) {
    TriSurface outer = test::cuboid({0, 0, 0}, {3, 3, 3});
    const TriSurface inner = test::cuboid({1, 1, 1}, {2, 2, 2});
    const Label offset = outer.pointCount();
    outer.points.insert(outer.points.end(), inner.points.begin(), inner.points.end());
    for (const auto& t : inner.triangles) {
        outer.triangles.push_back({t[0] + offset, t[2] + offset, t[1] + offset});
        outer.region.push_back(0);
    }
    EXPECT_NEAR(tetgenVolume(outer).value(), 26, 1e-12);
}

TEST_F(Tetgen, failsOnOverlappingPartsWithoutHarm) {
    TriSurface surface = test::cuboid({0, 0, 0}, {2, 2, 2});
    const TriSurface other = test::cuboid({1, 1, 1}, {3, 3, 3});
    const Label offset = surface.pointCount();
    surface.points.insert(surface.points.end(), other.points.begin(), other.points.end());
    for (const auto& t : other.triangles) {
        surface.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
        surface.region.push_back(0);
    }
    EXPECT_FALSE(tetgenVolume(surface).has_value());
}

} // namespace
} // namespace polymesh
