// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/compareSurface.h"

#include "libpolymesh/base/error.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

namespace polymesh {
namespace {

TEST(CompareSurface, findsNoDifferenceBetweenABoxAndItself) {
    const SurfaceComparison c =
        compareSurface(test::box(3, 4, 5, {3, 2, 1}), test::cuboid({0, 0, 0}, {3, 2, 1}));
    EXPECT_NEAR(c.volumeError(), 0, 1e-15);
    EXPECT_NEAR(c.areaError(), 0, 1e-15);
    EXPECT_NEAR(c.maxDistance(), 0, 1e-15);
    EXPECT_NEAR(c.volume, 6, 1e-14);
    EXPECT_EQ(c.missing, std::vector<std::string>{"walls"});
}

TEST(CompareSurface, seesDistancesBothWays) {
    // The surface is larger by 0.1 on one side: its corners are 0.1 from the mesh and vice versa.
    const SurfaceComparison c =
        compareSurface(test::box(2, 2, 2), test::cuboid({0, 0, 0}, {1.1, 1, 1}));
    EXPECT_NEAR(c.meshToSurface.max, 0.1, 1e-15);
    EXPECT_NEAR(c.surfaceToMesh.max, 0.1, 1e-15);
    EXPECT_NEAR(c.meshToSurface.mean, 0.1 / 6, 1e-15);
    EXPECT_NEAR(c.meshToSurface.where.x, 1, 1e-15);
    EXPECT_NEAR(c.volumeError(), 1 / 1.1 - 1, 1e-14);
}

/// A cube of 3 x 3 x 3 cells without the middle one, whose faces are the patch `part`.
PolyMesh boxAroundPart() {
    const PolyMesh grid = test::box(3, 3, 3, {3, 3, 3});
    const auto at = [](Label i, Label j, Label k) { return i + 4 * (j + 4 * k); };
    std::vector<test::Polyhedron> cells;
    for (Label k = 0; k < 3; ++k)
        for (Label j = 0; j < 3; ++j)
            for (Label i = 0; i < 3; ++i)
                if (i != 1 || j != 1 || k != 1)
                    cells.push_back(test::hexahedron({at(i, j, k),
                                                      at(i + 1, j, k),
                                                      at(i + 1, j + 1, k),
                                                      at(i, j + 1, k),
                                                      at(i, j, k + 1),
                                                      at(i + 1, j, k + 1),
                                                      at(i + 1, j + 1, k + 1),
                                                      at(i, j + 1, k + 1)}));
    return test::meshOf(grid.points, cells, [](const Vec3& c) {
        return norm(c - Vec3{1.5, 1.5, 1.5}) < 0.6 ? std::string("part") : std::string("box");
    });
}

TEST(CompareSurface, comparesThePartAloneInAnExternalMesh) {
    const SurfaceComparison c =
        compareSurface(boxAroundPart(), test::cuboid({1, 1, 1}, {2, 2, 2}, "part"));
    EXPECT_NEAR(c.volume, 1, 1e-14);
    EXPECT_NEAR(c.area, 6, 1e-14);
    EXPECT_NEAR(c.maxDistance(), 0, 1e-15);
    ASSERT_EQ(c.patches.size(), 1U);
    EXPECT_EQ(c.patches[0].name, "part");
    EXPECT_NEAR(c.patches[0].surfaceArea, 6, 1e-14);
    EXPECT_TRUE(c.missing.empty());
}

TEST(CompareSurface, refusesASurfaceWithoutTriangles) {
    EXPECT_THROW(compareSurface(test::unitCube(), TriSurface{}), InputError);
    EXPECT_THROW(compareSurface(PolyMesh{}, test::cuboid()), InputError);
}

} // namespace
} // namespace polymesh
