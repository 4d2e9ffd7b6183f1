// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/foamReader.h"

#include <charconv>
#include <cmath>
#include <fast_float/fast_float.h>

namespace polymesh::foam {
namespace {

constexpr std::ptrdiff_t longestPlain = 1024; // of a number or a word [bytes]
static_assert(longestPlain < static_cast<std::ptrdiff_t>(InputFile::longestToken));

bool isBlank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

bool isDelimiter(char c) {
    return isBlank(c) || c == '\0' || c == '(' || c == ')' || c == '{' || c == '}' || c == ';' ||
           c == '[' || c == ']' || c == '/' || c == '"';
}

bool endsWord(char c) {
    return isBlank(c) || c == '\0' || c == '"' || c == '\'' || c == ';' || c == '{' || c == '}';
}

std::string_view unquoted(std::string_view text) {
    if (text.size() >= 2 && text.front() == '"') return text.substr(1, text.size() - 2);
    return text;
}

void trimEnd(std::string& text) {
    while (!text.empty() && isBlank(text.back()))
        text.pop_back();
}

} // namespace

FoamReader::FoamReader(const std::filesystem::path& path) : file_(path) {
    readHeader();
}

FoamReader::FoamReader(std::string_view contents, std::string name)
    : file_(contents, std::move(name)) {
    readHeader();
}

std::string FoamReader::place() const {
    return fmt::format("{}:{}: ", file_.name(), file_.lineNumber());
}

void FoamReader::failTooLarge(std::int64_t value, std::string_view what) const {
    fail("{} {} does not fit {} bits; use a build with 64-bit labels",
         what,
         value,
         8 * sizeof(Label));
}

char FoamReader::peek() {
    while (true) {
        const char* here = file_.here();
        while (isBlank(*here))
            ++here;
        file_.moveTo(here);
        if (here == file_.end()) {
            if (file_.atEnd()) return '\0';
            continue;
        }
        if (*here == '/') {
            file_.lookAhead(2);
            if (skipComment()) continue;
        }
        file_.lookAhead(InputFile::longestToken);
        return *file_.here();
    }
}

bool FoamReader::skipComment() {
    const char kind = file_.here()[1];
    if (kind != '/' && kind != '*') return false;
    file_.moveTo(file_.here() + 2);
    char last = '\0';
    while (!file_.atEnd()) {
        const char c = *file_.here();
        file_.moveTo(file_.here() + 1);
        if (kind == '/' ? c == '\n' : last == '*' && c == '/') return true;
        last = c;
    }
    if (kind == '*') fail("the file ends inside a comment; a */ is missing");
    return true;
}

bool FoamReader::accept(char character) {
    if (peek() != character || file_.here() == file_.end()) return false;
    file_.moveTo(file_.here() + 1);
    return true;
}

void FoamReader::expect(char character, std::string_view what) {
    if (!accept(character)) fail("{}: expected '{}', found {}", what, character, found());
}

std::string FoamReader::found() {
    peek();
    if (file_.atEnd()) return "the end of the file";
    constexpr std::ptrdiff_t longest = 30;
    std::string text = "'";
    for (const char* c = file_.here(); c != file_.end() && c - file_.here() < longest; ++c) {
        if (c != file_.here() && (isDelimiter(*c) || isDelimiter(*file_.here()))) break;
        text += *c >= ' ' && *c <= '~' ? *c : '?';
    }
    return text + "'";
}

void FoamReader::finishNumber(const char* end, std::string_view what) {
    if (end - file_.here() >= longestPlain) fail("{}: a number of too many digits", what);
    if (!isDelimiter(*end)) fail("{}: expected a number, found {}", what, found());
    file_.moveTo(end);
}

std::int64_t FoamReader::integer(std::string_view what) {
    const char first = peek();
    const char* start = file_.here() + (first == '+' ? 1 : 0);
    std::int64_t value = 0;
    const auto [end, problem] = std::from_chars(start, file_.end(), value);
    if (problem == std::errc::result_out_of_range)
        fail("{}: {} does not fit 64 bits", what, found());
    if (problem != std::errc{}) fail("{}: expected an integer, found {}", what, found());
    finishNumber(end, what);
    return value;
}

double FoamReader::scalar(std::string_view what) {
    const char first = peek();
    const char* start = file_.here() + (first == '+' ? 1 : 0);
    double value = 0;
    const auto [end, problem] = fast_float::from_chars(start, file_.end(), value);
    if (problem != std::errc{} && problem != std::errc::result_out_of_range)
        fail("{}: expected a number, found {}", what, found());
    if (!std::isfinite(value)) fail("{}: expected a finite number, found {}", what, found());
    finishNumber(end, what);
    return value;
}

std::string FoamReader::word(std::string_view what) {
    std::string text;
    if (peek() == '"') {
        appendQuoted(text);
        return text;
    }
    int depth = 0; // parentheses may stand in a word when they are balanced
    const char* c = file_.here();
    for (; !endsWord(*c); ++c) {
        if (*c == '(') ++depth;
        if (*c == ')' && --depth < 0) break;
    }
    if (c - file_.here() >= longestPlain)
        fail("{}: a word of more than {} characters", what, longestPlain);
    text.assign(file_.here(), c);
    if (text.empty() || depth > 0) fail("{}: expected a word, found {}", what, found());
    file_.moveTo(c);
    return text;
}

void FoamReader::appendQuoted(std::string& text) {
    bool escaped = false;
    for (bool first = true;; first = false) {
        if (file_.atEnd()) fail("the file ends inside a string; a closing \" is missing");
        const char c = *file_.here();
        file_.moveTo(file_.here() + 1);
        text += c;
        if (c == '"' && !first && !escaped) return;
        escaped = c == '\\' && !escaped;
    }
}

std::string FoamReader::entryText() {
    std::string text;
    int depth = 0;
    const bool dictionary = peek() == '{';
    while (true) {
        const std::uint64_t offset = file_.offset();
        const char c = peek();
        const bool apart = file_.offset() != offset;
        if (apart && !text.empty() && !isBlank(text.back())) text += ' ';
        if (file_.atEnd()) fail("the file ends inside an entry; a ; or a }} is missing");
        if (c == '"') {
            appendQuoted(text);
            continue;
        }
        file_.moveTo(file_.here() + 1);
        if (c == ';' && depth == 0) break;
        text += c;
        depth += c == '{' || c == '(' || c == '[';
        depth -= c == '}' || c == ')' || c == ']';
        if (depth < 0) fail("an entry ends with '{}'; a ; is missing before it", c);
        if (dictionary && depth == 0) break;
    }
    trimEnd(text);
    return text;
}

void FoamReader::readHeader() {
    if (peek() == '\0' && file_.atEnd())
        throw InputError(fmt::format("{}: the file is empty", file_.name()));
    constexpr std::string_view title = "FoamFile";
    const std::string_view text(file_.here(), static_cast<std::size_t>(file_.end() - file_.here()));
    if (!text.starts_with(title))
        fail("not an OpenFOAM file: expected FoamFile {{ ... }}, found {}", found());
    file_.moveTo(file_.here() + title.size());
    expect('{', "header FoamFile");
    while (!accept('}')) {
        const std::string key = word("header FoamFile");
        const std::string value = entryText();
        if (key == "format") {
            if (value != "ascii" && value != "binary")
                fail("format '{}': expected ascii or binary", value);
            header_.binary = value == "binary";
        }
        if (key == "class") header_.className = unquoted(value);
        if (key == "object") header_.object = unquoted(value);
        if (key == "note") header_.note = unquoted(value);
        if (key == "arch") readArchitecture(unquoted(value));
    }
}

void FoamReader::readArchitecture(std::string_view text) {
    if (text.find("MSB") != std::string_view::npos)
        fail("arch '{}': big-endian files are not supported; convert to ascii first", text);
    const auto bytesOf = [&](std::string_view key, std::size_t standard) -> std::size_t {
        const std::size_t at = text.find(key);
        if (at == std::string_view::npos) return standard;
        const std::string_view bits = text.substr(at + key.size(), 2);
        if (bits != "32" && bits != "64") fail("arch '{}': expected {}32 or {}64", text, key, key);
        return bits == "32" ? 4 : 8;
    };
    header_.labelBytes = bytesOf("label=", header_.labelBytes);
    header_.scalarBytes = bytesOf("scalar=", header_.scalarBytes);
}

} // namespace polymesh::foam
