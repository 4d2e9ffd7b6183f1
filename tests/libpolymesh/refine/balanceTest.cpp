// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/forest.h"
#include "tests/libpolymesh/refine/macroCells.h"

#include <gtest/gtest.h>

namespace polymesh {
namespace {

/// Divides about one octant in `rarity`, some of them deeply.
RefinedOctants randomOctants(Label trees, unsigned rarity, unsigned seed) {
    std::mt19937 random(seed);
    return selectOctants(0, trees, [&](int level, std::span<const OctantKey> octants) {
        std::vector<char> flags(octants.size(), 0);
        for (char& flag : flags)
            flag = level < 5 && random() % (level == 0 ? rarity : 6) == 0 ? 1 : 0;
        return flags;
    });
}

void expectAsP4est(const HexCells& cells, unsigned seed) {
    const MacroMesh mesh(cells.corners, toLabel(cells.points.size()));
    RefinedOctants refined = randomOctants(mesh.cellCount(), 3, seed);
    const Leaves expected = growBalancedForest(mesh, refined);
    balance(mesh, 1, refined);
    const Leaves leaves = growForest(
        mesh, refined, octantsByTree(mesh, refined), evenPartition(mesh.cellCount(), Processes()));
    EXPECT_EQ(leaves.first, expected.first) << "seed " << seed;
    EXPECT_EQ(leaves.codes, expected.codes) << "seed " << seed;
}

} // namespace

TEST(Balance, dividesWhatP4estDividesInABox) {
    for (unsigned seed = 1; seed <= 10; ++seed)
        expectAsP4est(hexCells({{{0, 0, 0}, {3, 4, 5}}, {3, 4, 5}}), seed);
}

TEST(Balance, dividesWhatP4estDividesHoweverCellsAreTurned) {
    for (unsigned seed = 1; seed <= 10; ++seed)
        expectAsP4est(test::turned(hexCells({{{0, 0, 0}, {3, 3, 3}}, {3, 3, 3}}), seed), seed);
}

TEST(Balance, dividesWhatP4estDividesRoundEdgesOfAnyNumberOfCells) {
    for (const Label sectors : {3, 5, 6})
        for (unsigned seed = 1; seed <= 10; ++seed)
            expectAsP4est(test::turned(test::star(sectors), seed), seed);
}

TEST(Balance, keepsLayersBetweenLevels) {
    const HexCells cells = hexCells({{{0, 0, 0}, {8, 1, 1}}, {8, 1, 1}});
    const MacroMesh mesh(cells.corners, toLabel(cells.points.size()));
    for (const int layers : {1, 2, 3, 4}) {
        RefinedOctants refined;
        refined[0] = {octantKey(0, {})};
        refined[1] = {octantKey(0, {latticeSize / 2, 0, 0})};
        balance(mesh, layers, refined);
        // Halves of cells: the first layer is in the next cell, the third in the one after.
        EXPECT_EQ(refined[0].size(), static_cast<std::size_t>(1 + (layers + 1) / 2)) << layers;
    }
}

} // namespace polymesh
