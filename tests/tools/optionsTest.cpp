// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/options.h"

#include "libpolymesh/base/error.h"

#include <gtest/gtest.h>

namespace polymesh::tools {

namespace {

Settings settingsWith(const std::vector<std::string>& arguments) {
    Settings settings({{"cellSize", "H", "edge of a cell [m]"},
                       {"margin", "M", "distance [m]"},
                       {"box", "CORNERS", "two corners [m]"},
                       {"keep", "SIDE", "inside or outside"},
                       {"whole", "", "a switch"}});
    addCommandLine(settings, arguments);
    return settings;
}

std::string messageOf(const std::vector<std::string>& arguments) {
    try {
        settingsWith(arguments);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

} // namespace

TEST(Options, areWrittenWithOneDashOrTwo) {
    EXPECT_EQ(settingsWith({"-cellSize", "0.5"}).number("cellSize"), 0.5);
    EXPECT_EQ(settingsWith({"--cellSize", "0.5"}).number("cellSize"), 0.5);
    EXPECT_EQ(settingsWith({"-cellSize=0.5"}).number("cellSize"), 0.5);
    EXPECT_TRUE(settingsWith({"-whole"}).isOn("whole"));
    EXPECT_FALSE(settingsWith({}).isOn("whole"));
}

TEST(Options, takeNegativeNumbers) {
    EXPECT_EQ(settingsWith({"-margin", "-1.5e-3"}).number("margin"), -1.5e-3);
    EXPECT_EQ(settingsWith({"-box", "-1 -2 -3"}).vector("box"), (Vec3{-1, -2, -3}));
}

TEST(Options, takeVectorsWithAndWithoutParentheses) {
    EXPECT_EQ(settingsWith({"-box", "(1 2 3)"}).vector("box"), (Vec3{1, 2, 3}));
    EXPECT_EQ(settingsWith({"-box", "1 2 3"}).vector("box"), (Vec3{1, 2, 3}));
    EXPECT_EQ(settingsWith({"-box", "(0 0 0) (1 1 1e0)"}).numbers("box", 6),
              (std::vector<double>{0, 0, 0, 1, 1, 1}));
    EXPECT_THROW((void)settingsWith({"-box", "(1 2)"}).vector("box"), InputError);
    EXPECT_THROW((void)settingsWith({"-box", "1 2 nan"}).vector("box"), InputError);
}

TEST(Options, misspeltNameTheNearest) {
    EXPECT_NE(messageOf({"-celSize", "1"}).find("-cellSize"), std::string::npos);
    EXPECT_NE(messageOf({"--margn", "1"}).find("-margin"), std::string::npos);
}

TEST(Options, areNotAbbreviated) {
    EXPECT_NE(messageOf({"-cell", "1"}).find("unknown option -cell"), std::string::npos);
}

TEST(Options, missingValueStrayWordAndTwiceAreErrors) {
    EXPECT_NE(messageOf({"-cellSize"}), "no error");
    EXPECT_NE(messageOf({"-cellSize", "-margin", "1"}), "no error");
    EXPECT_NE(messageOf({"stray"}).find("stray"), std::string::npos);
    EXPECT_NE(messageOf({"-margin", "1", "-margin", "2"}).find("twice"), std::string::npos);
}

TEST(Options, outOfRangeAndNotANumberNameTheOption) {
    EXPECT_THROW((void)settingsWith({"-cellSize", "0"}).number("cellSize", 1e-9), InputError);
    EXPECT_THROW((void)settingsWith({"-cellSize", "1x"}).number("cellSize"), InputError);
    EXPECT_THROW((void)settingsWith({"-cellSize", "inf"}).number("cellSize"), InputError);
    EXPECT_THROW((void)settingsWith({"-cellSize", "2.5"}).integer("cellSize", 0, 9), InputError);
    EXPECT_EQ(settingsWith({}).numberOr(0.25, "margin"), 0.25);
}

TEST(Options, wordsAreChecked) {
    const std::vector<std::string> sides{"inside", "outside"};
    EXPECT_EQ(settingsWith({}).word("keep", sides, "inside"), "inside");
    EXPECT_THROW((void)settingsWith({"-keep", "outsid"}).word("keep", sides, "inside"), InputError);
}

TEST(Settings, firstPlaceWins) {
    Settings settings = settingsWith({"-margin", "1"});
    settings.add("margin", "2", "system/xDict:3: margin");
    settings.add("cellSize", "3", "system/xDict:4: cellSize");
    EXPECT_EQ(settings.number("margin"), 1);
    EXPECT_EQ(settings.number("cellSize"), 3);
    EXPECT_EQ(settings.place("cellSize"), "system/xDict:4: cellSize");
}

TEST(Help, listsEveryOption) {
    const std::string help = helpText("x", "does x", settingsWith({}));
    for (const char* text : {"x: does x", "-cellSize H", "edge of a cell [m]", "-whole"})
        EXPECT_NE(help.find(text), std::string::npos) << text;
}

TEST(Help, listsOnlyCommonOptionsAsThoseOfEveryTool) {
    const std::vector<Option> own{{"listAll", "", "print all there are", false}};
    const std::string help = helpText("x", "does x", Settings(own));
    EXPECT_LT(help.find("-listAll"), help.find("Options of every tool"));
    EXPECT_NE(help.find("not in the dictionary"), std::string::npos);
}

} // namespace polymesh::tools
