// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/names.h"

#include "formats/star/regionTypes.h"
#include "libpolymesh/surface/regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>

namespace polymesh::star {

namespace {

constexpr std::string_view separators = " \t\r,";
constexpr std::string_view commentStart = "! polymesh region ";

/// Takes the first word of the line away from it.
std::string_view takeWord(std::string_view& line) {
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(separators)));
    const std::string_view word = line.substr(0, line.find_first_of(separators));
    line.remove_prefix(word.size());
    return word;
}

std::optional<Label> takeNumber(std::string_view& line) {
    const std::string_view word = takeWord(line);
    Label number = 0;
    const auto [last, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool isWhole = error == std::errc{} && last == word.data() + word.size();
    return isWhole && number >= 0 ? std::optional(number) : std::nullopt;
}

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(separators);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(separators) + 1 - first);
}

/// Whether the text can stand before the semicolon of a dictionary entry: whoever edits the file
/// must not be able to spoil the dictionary that it comes into.
bool isValue(std::string_view text) {
    std::string open; // brackets that wait for their ends
    for (const char c : text) {
        if (c == '(' || c == '{') open += c == '(' ? ')' : '}';
        if (c == ')' || c == '}') {
            if (open.empty() || open.back() != c) return false;
            open.pop_back();
        }
        if ((c == ';' && open.empty()) || c == '"' || c == '/' || c == '#') return false;
    }
    return open.empty() && !text.empty();
}

void readComment(std::string_view line, Names& names) {
    const std::optional<Label> number = takeNumber(line);
    if (!number) return;
    const std::string_view what = takeWord(line);
    Names::Region& region = names.regions[*number];
    if (what == "type") {
        region.foamType = toWord(takeWord(line));
    } else if (what == "entry") {
        const std::string key = toWord(takeWord(line));
        const std::string_view value = trimmed(line);
        if (!key.empty() && isValue(value)) region.entries.emplace_back(key, value);
    }
}

void readCommand(std::string_view line, Names& names) {
    const std::string command = toLower(takeWord(line).substr(0, 4));
    const bool isKnown =
        command == "ctna" || command == "ctab" || command == "rnam" || command == "rdef";
    if (!isKnown) return;
    const std::optional<Label> number = takeNumber(line);
    if (!number) return;
    if (command == "ctna") names.tables[*number].name = trimmed(line);
    if (command == "ctab") names.tables[*number].type = toLower(takeWord(line));
    if (command == "rnam") names.regions[*number].name = trimmed(line);
    if (command == "rdef") names.regions[*number].type = takeWord(line);
}

/// A patch entry may be a list or dictionary that fills several lines.
std::string onOneLine(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return text;
}

} // namespace

Names readNames(std::string_view text) {
    Names names;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        if (line.starts_with(commentStart))
            readComment(line.substr(commentStart.size()), names);
        else
            readCommand(line, names);
    }
    return names;
}

std::string writeNames(const Names& names, const std::string& stem) {
    std::string text = "! names of the cell table and of the regions\n";
    const auto out = std::back_inserter(text);
    for (const auto& [number, table] : names.tables) {
        fmt::format_to(out, "ctable {} {} ,,,,,,\n", number, table.type);
        if (!table.name.empty()) fmt::format_to(out, "ctname {} {}\n", number, table.name);
    }
    for (const auto& [number, region] : names.regions) {
        fmt::format_to(out, "rdefine {} {}\n", number, toLower(region.type));
        fmt::format_to(out, "rname {} {}\n", number, region.name);
        if (!region.foamType.empty())
            fmt::format_to(out, "{}{} type {}\n", commentStart, number, region.foamType);
        for (const auto& [key, value] : region.entries)
            fmt::format_to(out, "{}{} entry {} {}\n", commentStart, number, key, onOneLine(value));
    }
    fmt::format_to(out,
                   "! read the files\n*set icvo mxv - 1\nvread {0}.vrt icvo,,,coded\n"
                   "cread {0}.cel icvo,,,add,coded\nbread {0}.bnd,,,coded\n*set icvo\n! end\n",
                   stem);
    return text;
}

} // namespace polymesh::star
