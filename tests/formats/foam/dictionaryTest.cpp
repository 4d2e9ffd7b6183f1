// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/dictionary.h"

#include "foamTestSupport.h"

#include <gtest/gtest.h>

namespace polymesh::foam {
namespace {

namespace fs = std::filesystem;
using test::inputError;
using test::TemporaryDirectory;
using test::writeText;

Dictionary parse(std::string_view text) {
    return parseDictionary(text, "dict");
}

TEST(Dictionary, readsEveryTypeOfValue) {
    const Dictionary dict = parse(R"(
        FoamFile { version 2.0; class dictionary; }
        // a comment; with { everything "
        name    wing /* between */; file "a \"b\".stl";
        size    -1.5e-3; count +12; switchOn yes; switchOff false;
        corner  (1 2.5 -3); scheme div(phi,U); sized 3(7 8 9); counted 2 (1 2);
        names   (a "b c" d); points ((0 0 0) (1 0 0)); empty ();
    )");
    EXPECT_EQ(dict.word("name"), "wing");
    EXPECT_EQ(dict.string("file"), "a \"b\".stl");
    EXPECT_EQ(dict.scalar("size"), -1.5e-3);
    EXPECT_EQ(dict.label("count"), 12);
    EXPECT_TRUE(dict.flag("switchOn"));
    EXPECT_FALSE(dict.flag("switchOff"));
    EXPECT_EQ(dict.vector("corner"), (Vec3{1, 2.5, -3}));
    EXPECT_EQ(dict.word("scheme"), "div(phi,U)");
    EXPECT_EQ(dict.labels("sized"), (std::vector<Label>{7, 8, 9}));
    EXPECT_EQ(dict.labels("counted"), (std::vector<Label>{1, 2}));
    EXPECT_EQ(dict.words("names"), (std::vector<std::string>{"a", "b c", "d"}));
    EXPECT_EQ(dict.vectors("points"), (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}));
    EXPECT_TRUE(dict.list("empty").empty());
    EXPECT_EQ(dict.scalar("absent", 5.0), 5.0);
}

TEST(Dictionary, readsABlockMeshDictAsTokensWithLines) {
    const Dictionary dict = parse("blocks\n(\n    hex (0 1 2 3 4 5 6 7) zone (4 3 2)\n"
                                  "    simpleGrading (1 ((0.5 2)(0.5 1)) 1)\n);\n"
                                  "boundary ( in { type wall; faces ((0 4 7 3) 4(1 2 3 4)); } );");
    const std::vector<Value>& block = dict.list("blocks");
    ASSERT_EQ(block.size(), 6U);
    EXPECT_EQ(block[0].word("blocks"), "hex");
    EXPECT_EQ(block[1].list("blocks").size(), 8U);
    EXPECT_EQ(block[5].list("blocks")[1].list("grading").size(), 2U);
    EXPECT_EQ(block[5].place.line, 4);
    const auto patches = namedDictionaries(dict.entry("boundary"));
    ASSERT_EQ(patches.size(), 1U);
    EXPECT_EQ(patches[0].first, "in");
    EXPECT_EQ(patches[0].second->list("faces")[1].list("faces").size(), 4U);
}

TEST(Dictionary, expandsMacrosOfEveryScope) {
    const Dictionary dict = parse(R"(
        length 2; box ((0 0 0) ($length 1 1));
        common { type wall; level 3; inner { deep 7; } }
        a { $common; level 4; up $..length; top $:common.level; here $.level; far $common.inner.deep; }
        b $common; list (1 $length ${length}); all $box;
    )");
    EXPECT_EQ(dict.list("box")[1].vector("box"), (Vec3{2, 1, 1}));
    const Dictionary& a = dict.dictionary("a");
    EXPECT_EQ(a.word("type"), "wall");
    EXPECT_EQ(a.label("level"), 4);
    EXPECT_EQ(a.label("up"), 2);
    EXPECT_EQ(a.label("top"), 3);
    EXPECT_EQ(a.label("here"), 4);
    EXPECT_EQ(a.label("far"), 7);
    EXPECT_EQ(dict.dictionary("b").label("level"), 3);
    EXPECT_EQ(dict.labels("list"), (std::vector<Label>{1, 2, 2}));
    EXPECT_EQ(dict.vectors("all").size(), 2U);
}

TEST(Dictionary, lastEntryWinsAndDictionariesMerge) {
    const Dictionary dict = parse("a 1; d { x 1; y 2; } a 2; d { y 3; z 4; } r 1; #remove r\n");
    EXPECT_EQ(dict.label("a"), 2);
    EXPECT_EQ(dict.dictionary("d").label("x"), 1);
    EXPECT_EQ(dict.dictionary("d").label("y"), 3);
    EXPECT_EQ(dict.dictionary("d").label("z"), 4);
    EXPECT_FALSE(dict.has("r"));
}

TEST(Dictionary, includesRelativeToTheFileAndNamesTheRightOne) {
    const TemporaryDirectory directory;
    const fs::path path = directory.path() / "system" / "dict";
    writeText(path, "h 0.1;\n#include \"parts/more\"\n#includeIfPresent \"none\"\nafter $size;\n");
    writeText(directory.path() / "system/parts/more", "#include \"again\"\nsize (1 2);\n");
    writeText(directory.path() / "system/parts/again", "\nmargin x;\n");
    const Dictionary dict = readDictionary(path);
    EXPECT_EQ(dict.labels("after"), (std::vector<Label>{1, 2}));
    EXPECT_EQ(inputError([&] { (void)dict.scalar("margin"); }),
              (directory.path() / "system/parts/again").string() +
                  ":2: margin: found x, expected a number");
}

TEST(Dictionary, refusesIncludeCyclesAndMissingFiles) {
    const TemporaryDirectory directory;
    const fs::path path = directory.path() / "a";
    writeText(path, "#include \"b\"\n");
    writeText(directory.path() / "b", "x 1;\n#include \"a\"\n");
    EXPECT_NE(inputError([&] { readDictionary(path); }).find("/b:2: #include: "),
              std::string::npos);
    writeText(path, "#include \"gone\"\n");
    EXPECT_NE(inputError([&] { readDictionary(path); }).find("there is no file"),
              std::string::npos);
    EXPECT_NE(inputError([&] { readDictionary(directory.path() / "no"); }).find("no such file"),
              std::string::npos);
}

struct WrongText {
    const char* text;
    const char* message;
};

class Refused : public testing::TestWithParam<WrongText> {};

TEST_P(Refused, saysLineAndReason) {
    EXPECT_EQ(inputError([] { parse(GetParam().text); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Dictionary,
    Refused,
    testing::Values(
        WrongText{"a 1;\nb 2\n", "dict:2: b: no ; at the end of the entry"},
        WrongText{"a 1;\nd { b 2;\n", "dict:2: this { has no matching }"},
        WrongText{"}", "dict:1: a } without a { before it"},
        WrongText{"a (1 2;\n", "dict:1: the list that begins here has no matching )"},
        WrongText{"\na (1 2];\n", "dict:2: the list that begins here has no matching )"},
        WrongText{"a \"x;\n", "dict:1: this string has no closing \""},
        WrongText{"a #{ x;\n", "dict:1: this #{ has no matching #}"},
        WrongText{"a 1; /* b\n", "dict:1: this comment has no end; a */ is missing"},
        WrongText{"a $none;", "dict:1: $none: there is no such entry before this line"},
        WrongText{"a 1;\nd { b $...a; }", "dict:2: $...a: there is no such entry before this line"},
        WrongText{"a 1; $a;", "dict:1: a is a value; expected a dictionary here"},
        WrongText{"a #calc \"f(1)\";", "dict:1: the expression 'f(1)': 'f' is not supported"},
        WrongText{"\na #eval{ 1/0 };", "dict:2: the expression ' 1/0 ': division by zero"},
        WrongText{"a #eval{ 1 + };",
                  "dict:1: the expression ' 1 + ': something is missing at the end"},
        WrongText{"a #eval 1;", "dict:1: #eval: expected \"expression\" or {expression}"},
        WrongText{"a #eval{ $b };",
                  "dict:1: the expression ' $b ': $b is no number that stands before this line"},
        WrongText{"a #codeStream {};",
                  "dict:1: #codeStream is not supported; write its result instead"},
        WrongText{"\n#codeStream {}",
                  "dict:2: #codeStream is not supported; write what it stands for"},
        WrongText{"a 3(1 2);", "dict:1: list: found 3, expected 2, the length of the list"},
        WrongText{"a 3 (1 2);", "dict:1: a: found 3, expected 2, the length of the list"},
        WrongText{"(1 2)", "dict:1: '(' is not expected here"}));

TEST(Dictionary, getterSaysWhatWasFoundAndExpected) {
    const Dictionary dict = parse("a (1 2);\nd { b on; }\nc 1.5;\ne x y;\n");
    const Dictionary& d = dict.dictionary("d");
    const auto message = [](auto&& call) { return inputError(call); };
    EXPECT_EQ(message([&] { (void)dict.vector("a"); }),
              "dict:1: a: found (1 2), expected three numbers (x y z)");
    EXPECT_EQ(message([&] { (void)dict.label("c"); }), "dict:3: c: found 1.5, expected an integer");
    EXPECT_EQ(message([&] { (void)d.scalar("b"); }), "dict:2: b: found on, expected a number");
    EXPECT_EQ(message([&] { (void)d.scalar("x"); }), "dict:2: d.x is missing");
    EXPECT_EQ(message([&] { (void)dict.word("e"); }), "dict:4: e: found 2 values, expected one");
    EXPECT_EQ(message([&] { (void)dict.word("d"); }),
              "dict:2: d: found a dictionary {...}, expected a value");
    EXPECT_EQ(message([&] { (void)dict.dictionary("c"); }),
              "dict:3: c: found a value, expected a dictionary {...}");
}

TEST(Dictionary, namesTheNearestKnownKey) {
    const Dictionary dict = parse("FoamFile {}\ncellSize 1;\nmargn 2;\n");
    EXPECT_EQ(inputError([&] {
                  requireKnownKeys(dict, {"cellSize", "margin", "surface"});
              }),
              "dict:3: unknown key 'margn'; did you mean 'margin'?");
    EXPECT_EQ(inputError([&] { requireKnownKeys(dict, {"cellSize", "margn"}); }), "no InputError");
}

TEST(Dictionary, evaluatesArithmetic) {
    const Dictionary dict = parse(R"(
        h 3; d { w 0.5; }
        a #eval{ 2*$h - -1 }; b #eval "($h + 1)/8"; c #calc "1/2 + 7/2.0";
        e ( #eval{ sqrt(${h}*3) } #calc #{ pow(2, $:d.w*4) - Foam::sin(0.0) #} );
        f #eval{ sin(degToRad(90))*max(1, pi()) };)");
    EXPECT_EQ(dict.scalar("a"), 7);
    EXPECT_EQ(dict.scalar("b"), 0.5);
    EXPECT_EQ(dict.scalar("c"), 3.5); // whole numbers divide as in C++
    EXPECT_EQ(dict.list("e").size(), 2U);
    EXPECT_EQ(dict.list("e")[0].scalar("e"), 3);
    EXPECT_EQ(dict.list("e")[1].scalar("e"), 4);
    EXPECT_DOUBLE_EQ(dict.scalar("f"), 3.141592653589793);
    EXPECT_NE(inputError([] { parse("a #eval{" + std::string(10000, '(') + "};"); }).find("nested"),
              std::string::npos);
}

TEST(Dictionary, includesValuesInsideAList) {
    const test::TemporaryDirectory dir;
    writeText(dir.path() / "part", "1 (2 3) // end");
    writeText(dir.path() / "dict", "a (0 #include \"part\" 4);");
    const Dictionary dict = readDictionary(dir.path() / "dict");
    EXPECT_EQ(dict.list("a").size(), 4U);
    writeText(dir.path() / "part", "1 )");
    EXPECT_NE(inputError([&] { readDictionary(dir.path() / "dict"); }).find("part:1: ')'"),
              std::string::npos);
}

TEST(Dictionary, skipsDirectivesOnDemand) {
    const Dictionary dict = parseDictionary(R"(
        #includeEtc "caseDicts/x"
        a #calc "1 + $b";
        c #codeStream { code #{ ; } #}; };
        d ($e 1); $gone;
        functions { #includeFunc residuals(p, U)
            x { type y; } #includeFunc z }
        writeFormat ascii;)",
                                            "dict",
                                            Directives::skip);
    EXPECT_FALSE(dict.has("a"));
    EXPECT_FALSE(dict.has("c"));
    EXPECT_FALSE(dict.has("d"));
    EXPECT_EQ(dict.word("writeFormat"), "ascii");
    EXPECT_TRUE(dict.dictionary("functions").has("x"));
}

TEST(Dictionary, boundsWhatMacrosMultiplyAndHowDeepTextNests) {
    std::string text = "a0 (1 1 1 1 1 1 1 1);\n";
    for (int i = 0; i < 30; ++i)
        text += fmt::format("a{0} ($a{1} $a{1} $a{1} $a{1});\n", i + 1, i);
    EXPECT_NE(inputError([&] { parse(text); }).find("macros make more than"), std::string::npos);
    text = "d0 {}\n";
    for (int i = 0; i < 3000; ++i)
        text += fmt::format("d{0} {{ a $d{1}; b $d{1}; }}\n", i + 1, i);
    EXPECT_NE(inputError([&] { parse(text); }).find("macros make more than"), std::string::npos);
    const std::string deep = "a " + std::string(100000, '(');
    EXPECT_NE(inputError([&] { parse(deep); }).find("levels of nesting"), std::string::npos);
}

} // namespace
} // namespace polymesh::foam
