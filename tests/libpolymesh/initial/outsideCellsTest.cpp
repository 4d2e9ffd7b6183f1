// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/outsideCells.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/trim/trim.h"
#include "tests/support/sameMesh.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <random>

namespace polymesh {
namespace {

CartesianBox boxOf(double half, Label n) {
    return {{{-half, -half, -half}, {half, half, half}}, {n, n, n}};
}

Vec3 middleOf(const CartesianBox& box, Label cell) {
    const auto& [nx, ny, nz] = box.cells;
    const std::array<Label, 3> ijk{cell % nx, cell / nx % ny, cell / nx / ny};
    Vec3 middle;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const double step = box.box.size()[axis] / static_cast<double>(box.cells[a]);
        middle[axis] = box.box.min[axis] + step * (static_cast<double>(ijk[a]) + 0.5);
    }
    return middle;
}

TEST(OutsideCells, areAwayFromABallAndAllThatAreFarAway) {
    const CartesianBox box = boxOf(2, 40); // cells of 0.1
    const std::vector<std::uint8_t> outside = outsideCells(box, test::sphere(3));
    for (Label c = 0; c < 40 * 40 * 40; ++c) {
        const double radius = norm(middleOf(box, c));
        if (outside[index(c)] != 0) {
            EXPECT_GT(radius, 1.05);
        } else {
            EXPECT_LT(radius, 1.5);
        }
    }
}

TEST(OutsideCells, doNotComeFromHowTrianglesAreTurned) {
    const CartesianBox box = boxOf(1.5, 24);
    EXPECT_EQ(outsideCells(box, test::sphere(2)),
              outsideCells(box, test::inverted(test::sphere(2))));
}

TEST(OutsideCells, areNoCavities) {
    const CartesianBox box = boxOf(1.5, 30);
    const TriSurface hollow = test::join(test::sphere(3), test::inverted(test::sphere(3, 0.6)));
    const std::vector<std::uint8_t> outside = outsideCells(box, hollow);
    for (Label c = 0; c < 30 * 30 * 30; ++c)
        EXPECT_FALSE(norm(middleOf(box, c)) < 1 && outside[index(c)] != 0);
    EXPECT_EQ(outside.front(), 1);
}

TEST(OutsideCells, leaveAValidMeshWhateverIsLeftOut) {
    std::mt19937 random(3);
    for (int i = 0; i < 30; ++i) {
        const CartesianBox box{{{0, 0, 0}, {3, 4, 5}}, {6, 5, 4}};
        std::vector<std::uint8_t> flags(120); // one for each cell
        for (std::uint8_t& flag : flags)
            flag = random() % 10 < static_cast<unsigned>(i % 10) ? 1 : 0;
        const auto left = std::ranges::count(flags, std::uint8_t{0});
        const PolyMesh mesh = cartesianMeshWithout(box, flags);
        EXPECT_EQ(mesh.cellCount, left);
        EXPECT_TRUE(validate(mesh).empty());
        EXPECT_NEAR(boundedVolume(mesh), static_cast<double>(left) * 0.5, 1e-9);
    }
}

TEST(OutsideCells, leaveTheWholeBoxWhenNoneIsFlagged) {
    const CartesianBox box{{{0, 0, 0}, {3, 4, 5}}, {3, 2, 4}};
    EXPECT_EQ(test::differenceOf(cartesianMeshWithout(box, std::vector<std::uint8_t>(24, 0)),
                                 cartesianMesh(box),
                                 0),
              "");
}

TEST(OutsideCells, cannotBeAll) {
    EXPECT_THROW(cartesianMeshWithout(boxOf(1, 2), std::vector<std::uint8_t>(8, 1)), InputError);
}

TEST(OutsideCells, makeNoDifferenceToTheTrimmedMesh) {
    const CartesianBox box = boxOf(1.6, 20);
    for (const TriSurface& surface : {test::sphere(2),
                                      test::cylinder(24, 1.3),
                                      test::cuboid({-0.93, -0.51, -1.2}, {0.7, 1.1, 0.3})}) {
        const Trimmed whole = trim(cartesianMesh(box), surface, {});
        const Trimmed part =
            trim(cartesianMeshWithout(box, outsideCells(box, surface)), surface, {});
        EXPECT_EQ(test::differenceOf(part.mesh, whole.mesh, 0), "")
            << surface.triangleCount() << " triangles";
    }
}

} // namespace
} // namespace polymesh
