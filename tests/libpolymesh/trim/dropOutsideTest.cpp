// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/dropOutside.h"

#include "arranged.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polymesh::test {
namespace {

/// A ball in a box, and winding numbers of our own for the cells that it does not touch.
template<class Winding>
Arranged& wound(Arranged& ball, Winding&& windingOf) {
    for (Label c = 0; c < ball.mesh.cellCount; ++c)
        if (ball.probe.localCell[index(c)] < 0)
            ball.cellWinding[index(c)] = static_cast<std::int8_t>(windingOf(c % 10));
    return ball;
}

TEST(DropOutside, keepsWhatIsProbedOrInside) {
    Arranged ball(box(10, 10, 10), sphere(2, 0.2, {0.5, 0.5, 0.5}));
    const auto windingOf = [](Label layer) { return layer < 4 ? -1 : layer < 8 ? 0 : 2; };
    wound(ball, windingOf);
    const auto probed = ball.probe.cellCount();
    const auto inside = std::ranges::count(ball.cellWinding, std::int8_t{2});
    dropOutside(ball.mesh, ball.probe, ball.cellWinding);
    EXPECT_EQ(ball.mesh.cellCount, probed + inside);
    EXPECT_EQ(ball.cellWinding.size(), index(ball.mesh.cellCount));
    EXPECT_EQ(std::ranges::count(ball.cellWinding, std::int8_t{2}), inside);
    for (Label i = 0; i < probed; ++i)
        EXPECT_EQ(ball.probe.localCell[index(ball.probe.cells[index(i)])], i);
}

TEST(DropOutside, doesNothingForAFewCells) {
    Arranged ball(box(10, 10, 10), sphere(2, 0.2, {0.5, 0.5, 0.5}));
    wound(ball, [](Label layer) { return layer < 1 ? 0 : 1; });
    dropOutside(ball.mesh, ball.probe, ball.cellWinding);
    EXPECT_EQ(ball.mesh.cellCount, 1000);
}

} // namespace
} // namespace polymesh::test
