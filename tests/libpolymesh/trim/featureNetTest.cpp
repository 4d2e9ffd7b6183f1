// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/featureNet.h"

#include <gtest/gtest.h>

namespace polymesh::test {
namespace {

/// The ends of the edges that have become borders.
std::vector<std::array<Label, 2>>
newBorders(std::vector<NetEdge> net, const std::vector<Label>& outline, bool expected = true) {
    const std::vector<NetEdge> before = net;
    EXPECT_EQ(carryFeaturesOn(net, outline), expected);
    std::vector<std::array<Label, 2>> found;
    for (std::size_t k = 0; k < net.size(); ++k)
        if (net[k].isBorder && !before[k].isBorder) found.push_back(net[k].ends);
    return found;
}

using Borders = std::vector<std::array<Label, 2>>;

TEST(FeatureNet, aLineGoesOnFromItsFreeEndToTheOutlineTheCheapestWay) {
    // 1 and 4 are on the outline; the line ends at 2, from where 3 is a cheap detour.
    const std::vector<NetEdge> net{{{1, 2}, 1, true}, {{2, 4}, 5}, {{2, 3}, 1}, {{3, 4}, 1}};
    EXPECT_EQ(newBorders(net, {1, 4}), (Borders{{2, 3}, {3, 4}}));
    EXPECT_EQ(newBorders(net, {1, 3, 4}), (Borders{{2, 3}}));
}

TEST(FeatureNet, bothEndsOfALineInsideGoOnToDifferentPlaces) {
    const std::vector<NetEdge> net{
        {{2, 3}, 1, true}, {{2, 5}, 1}, {{3, 5}, 1}, {{2, 6}, 2}, {{3, 6}, 3}};
    EXPECT_EQ(newBorders(net, {5, 6}), (Borders{{2, 5}, {3, 6}}));
}

TEST(FeatureNet, aLineMayEndAtAnotherLine) {
    const std::vector<NetEdge> net{
        {{1, 2}, 1, true}, {{2, 3}, 1}, {{3, 4}, 1, true}, {{3, 5}, 1, true}};
    EXPECT_EQ(newBorders(net, {1, 4, 5}), (Borders{{2, 3}}));
}

TEST(FeatureNet, aLineNeverEndsAtItself) {
    const std::vector<NetEdge> net{
        {{1, 2}, 1, true}, {{2, 3}, 1, true}, {{3, 4}, 1}, {{4, 1}, 1}, {{4, 2}, 1}};
    EXPECT_EQ(newBorders(net, {1}, false), Borders{});
}

TEST(FeatureNet, linesWithoutFreeEndsStayAsTheyAre) {
    const std::vector<NetEdge> net{{{1, 2}, 1, true}, {{2, 3}, 1, true}, {{2, 4}, 1}};
    EXPECT_EQ(newBorders(net, {1, 3, 4}), Borders{});
}

} // namespace
} // namespace polymesh::test
