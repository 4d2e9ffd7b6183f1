// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/flatSides.h"

#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polymesh::test {
namespace {

double clearanceOf(const CartesianBox& box, int axis, double flat) {
    const double h =
        box.box.size()[axis] / static_cast<double>(box.cells[static_cast<std::size_t>(axis)]);
    const double place = (flat - box.box.min[axis]) / h;
    return std::abs(place - std::round(place));
}

TEST(FlatSides, ofACuboidAreItsSides) {
    const auto flats = flatSides(cuboid({0, 1, 2}, {3, 5, 7}), 0.1);
    EXPECT_EQ(flats[0], (std::vector<double>{0, 3}));
    EXPECT_EQ(flats[1], (std::vector<double>{1, 5}));
    EXPECT_EQ(flats[2], (std::vector<double>{2, 7}));
}

TEST(FlatSides, smallerThanHalfACellFaceDoNotCount) {
    const auto flats = flatSides(cuboid({0, 0, 0}, {1, 1, 1}), 1.5);
    for (const auto& axis : flats)
        EXPECT_TRUE(axis.empty());
}

TEST(FlatSides, ofASphereAreNone) {
    for (const auto& axis : flatSides(sphere(4), 0.2))
        EXPECT_TRUE(axis.empty());
}

TEST(ClearOfFlatSides, movesPlanesOffASideAndKeepsTheMargin) {
    const Box bounds{{0, 0, 0}, {1, 1, 1}};
    const double h = 0.1;
    const CartesianBox box = boxAround(bounds, h, defaultMargin(h));
    const double onPlane = box.box.min.z + 5 * h;
    const CartesianBox shifted =
        clearOfFlatSides(box, bounds, defaultMargin(h), {{{}, {}, {onPlane + 1e-6}}});
    EXPECT_EQ(shifted.box.min.x, box.box.min.x);
    EXPECT_EQ(shifted.cells[0], box.cells[0]);
    EXPECT_GE(clearanceOf(shifted, 2, onPlane + 1e-6), 0.19);
    EXPECT_LE(shifted.box.min.z, -defaultMargin(h) + 1e-12);
    EXPECT_GE(shifted.box.max.z, 1 + defaultMargin(h) - 1e-12);
    EXPECT_NEAR(shifted.box.size().z, static_cast<double>(shifted.cells[2]) * h, 1e-12);
}

TEST(ClearOfFlatSides, keepsThePlanesOfHalvedCellsAwayToo) {
    const Box bounds{{0, 0, 0}, {1, 1, 1}};
    const double h = 0.1;
    const CartesianBox box = boxAround(bounds, h, defaultMargin(h));
    const std::vector<double> flats{box.box.min.y + 5.25 * h, box.box.min.y + 7.52 * h};
    const CartesianBox plain = clearOfFlatSides(box, bounds, defaultMargin(h), {{{}, flats, {}}});
    const CartesianBox shifted =
        clearOfFlatSides(box, bounds, defaultMargin(h), {{{}, flats, {}}}, 3);
    EXPECT_EQ(plain, box);
    for (const int parts : {1, 2, 4, 8}) {
        CartesianBox halved = shifted;
        halved.cells[1] *= parts;
        for (const double flat : flats)
            EXPECT_GE(clearanceOf(halved, 1, flat), 0.1) << parts;
    }
}

TEST(ClearOfFlatSides, leavesABoxThatIsClearAsItIs) {
    const Box bounds{{0, 0, 0}, {1, 1, 1}};
    const CartesianBox box = boxAround(bounds, 0.1, defaultMargin(0.1));
    const double between = box.box.min.x + 5.5 * 0.1;
    EXPECT_EQ(clearOfFlatSides(box, bounds, defaultMargin(0.1), {{{between}, {between}, {}}}), box);
}

TEST(ClearOfFlatSides, doesWhatItCanWhereSidesAreDense) {
    const Box bounds{{0, 0, 0}, {1, 1, 1}};
    const double h = 0.1;
    const CartesianBox box = boxAround(bounds, h, defaultMargin(h));
    const double first = box.box.min.y;
    const std::vector<double> dense{first + 3 * h, first + 4.34 * h, first + 5.67 * h};
    const CartesianBox shifted = clearOfFlatSides(box, bounds, defaultMargin(h), {{{}, dense, {}}});
    for (const double flat : dense)
        EXPECT_GE(clearanceOf(shifted, 1, flat), 0.14);
}

} // namespace
} // namespace polymesh::test
