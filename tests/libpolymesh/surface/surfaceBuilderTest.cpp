// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/surfaceBuilder.h"

#include "libpolymesh/surface/regions.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>

namespace polymesh {

namespace {

using Names = std::vector<std::string>;

TEST(SurfaceBuilder, mergesPointsThatAreEqualBitForBitAndTheTwoZeros) {
    SurfaceBuilder builder;
    EXPECT_EQ(builder.addPoint({0, 1, 2}), 0);
    EXPECT_EQ(builder.addPoint({0, 1, 2.0000000000000004}), 1);
    EXPECT_EQ(builder.addPoint({-0.0, 1, 2}), 0);
    EXPECT_EQ(builder.pointCount(), 2);
}

TEST(SurfaceBuilder, mergesAsASetOfPointsDoes) {
    SurfaceBuilder builder;
    std::set<Vec3> distinct;
    std::mt19937 random(7);
    for (int i = 0; i < 20000; ++i) {
        const auto next = [&] { return static_cast<double>(random() % 20) - 9.5; };
        const Vec3 p{next(), next(), next()};
        distinct.insert(p);
        builder.addPoint(p);
    }
    EXPECT_EQ(builder.pointCount(), toLabel(distinct.size()));
}

TEST(SurfaceBuilder, dropsTrianglesWithTwoEqualCornersAndUnusedPoints) {
    SurfaceBuilder builder;
    builder.addPoint({9, 9, 9});
    const std::array<Label, 4> corners{builder.addPoint({0, 0, 0}),
                                       builder.addPoint({1, 0, 0}),
                                       builder.addPoint({1, 0, 0}),
                                       builder.addPoint({0, 1, 0})};
    builder.addPolygon(corners, builder.addRegion("a"));
    const TriSurface surface = builder.finish("file");
    EXPECT_EQ(surface.triangles, (std::vector<std::array<Label, 3>>{{0, 1, 2}}));
    EXPECT_EQ(surface.points, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(SurfaceBuilder, joinsRegionsOfOneNameDropsEmptyOnesAndNamesTheNameless) {
    SurfaceBuilder builder;
    const std::array<Label, 3> corners{
        builder.addPoint({0, 0, 0}), builder.addPoint({1, 0, 0}), builder.addPoint({0, 1, 0})};
    builder.addRegion("empty");
    builder.addPolygon(corners, builder.addRegion("inlet"));
    builder.addPolygon(corners, builder.addRegion(""));
    builder.addPolygon(corners, builder.addRegion("in let"));
    builder.addPolygon(corners, builder.addRegion("outlet"));
    const TriSurface surface = builder.finish("my part");
    EXPECT_EQ(surface.regionNames, (Names{"inlet", "mypart", "outlet"}));
    EXPECT_EQ(surface.region, (std::vector<Label>{0, 1, 0, 2}));
}

TEST(SurfaceBuilder, givesTheNamelessRegionToItsNamesake) {
    SurfaceBuilder builder;
    const std::array<Label, 3> corners{
        builder.addPoint({0, 0, 0}), builder.addPoint({1, 0, 0}), builder.addPoint({0, 1, 0})};
    builder.addPolygon(corners, builder.addRegion(""));
    builder.addPolygon(corners, builder.addRegion("part"));
    const TriSurface surface = builder.finish("part");
    EXPECT_EQ(surface.regionNames, (Names{"part"}));
    EXPECT_EQ(surface.region, (std::vector<Label>{0, 0}));
}

TEST(ToWord, dropsWhatDictionariesDoNotTake) {
    EXPECT_EQ(toWord("frame:016-shadow%13"), "frame:016-shadow%13");
    EXPECT_EQ(toWord(" my \"first\" part; {x}/$y\t"), "myfirstpartxy");
    EXPECT_EQ(toWord("12"), "_12");
    EXPECT_EQ(toWord("-1.5e3"), "_-1.5e3");
    EXPECT_EQ(toWord(" \t"), "");
    // OpenFOAM v1912 refuses a boundary file with these names as they are.
    for (const char* name : {"-wall", "+x", ".hidden", "..", "*", ":a", "=b", "3d"})
        EXPECT_EQ(toWord(name), "_" + std::string(name));
    for (const char* name : {"a-b", "a.1", "x:y", "a=b", "a*", "_1", "inf", "e5", "!x", "%1"})
        EXPECT_EQ(toWord(name), name);
}

TEST(TrianglesOfRegions, listsThemInAscendingOrder) {
    TriSurface surface;
    surface.region = {1, 0, 1, 1};
    surface.triangles.resize(4);
    surface.regionNames = {"a", "b", "c"};
    const Rows<Label> rows = trianglesOfRegions(surface);
    EXPECT_EQ(rows.offsets, (std::vector<Label>{0, 1, 4, 4}));
    EXPECT_EQ(rows.values, (std::vector<Label>{1, 0, 2, 3}));
}

} // namespace

} // namespace polymesh
