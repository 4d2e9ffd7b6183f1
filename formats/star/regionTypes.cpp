// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/regionTypes.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace polymesh::star {

namespace {

constexpr std::string_view physicalType = "physicalType";
constexpr std::size_t starTypeLetters = 4;

template<class Convert>
std::string converted(std::string_view text, Convert&& convert) {
    std::string result(text);
    for (char& c : result)
        c = static_cast<char>(convert(static_cast<unsigned char>(c)));
    return result;
}

} // namespace

std::string toUpper(std::string_view text) {
    return converted(text, [](int c) { return std::toupper(c); });
}

std::string toLower(std::string_view text) {
    return converted(text, [](int c) { return std::tolower(c); });
}

Patch patchOfType(std::string_view starType) {
    const std::string word = toLower(starType);
    Patch patch;
    if (word.starts_with("wall")) {
        patch.type = "wall";
    } else if (word == "symmetryplane") {
        patch.type = "symmetryPlane";
    } else if (word.starts_with("sym")) {
        patch.type = "symmetry";
    } else if (word == "empty" || word == "wedge") {
        patch.type = word;
    } else if (!word.empty() && word != "none" && !word.starts_with("patc")) {
        patch.entries.emplace_back(physicalType, word);
    }
    return patch;
}

std::string starTypeOf(const Patch& patch) {
    if (patch.type == "wall") return "WALL";
    if (patch.type == "symmetry" || patch.type == "symmetryPlane") return "SYMP";
    if (patch.type == "empty" || patch.type == "wedge") return patch.type;
    for (const auto& [key, value] : patch.entries)
        if (key == physicalType && !value.empty())
            return toUpper(std::string_view(value).substr(0, starTypeLetters));
    return "patch";
}

} // namespace polymesh::star
