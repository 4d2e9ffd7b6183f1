// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/regions.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace polymesh {

namespace {

bool isWordCharacter(char c) {
    constexpr std::string_view forbidden = "\"'/\\;{}()[]<>$#,";
    return static_cast<unsigned char>(c) > ' ' && c != 0x7f &&
           forbidden.find(c) == std::string_view::npos;
}

/// OpenFOAM's scanner takes these for the beginning of a number or for punctuation; within a word
/// they are characters as any other.
bool cannotBegin(char c) {
    constexpr std::string_view forbidden = "0123456789+-.*:=";
    return forbidden.find(c) != std::string_view::npos;
}

} // namespace

Rows<Label> trianglesOfRegions(const TriSurface& surface) {
    Rows<Label> rows;
    rows.offsets.assign(surface.regionNames.size() + 1, 0);
    for (Label region : surface.region)
        ++rows.offsets[index(region) + 1];
    std::partial_sum(rows.offsets.begin(), rows.offsets.end(), rows.offsets.begin());
    rows.values.resize(surface.region.size());
    std::vector<Label> next(rows.offsets.begin(), rows.offsets.end() - 1);
    for (Label t = 0; t < surface.triangleCount(); ++t)
        rows.values[index(next[index(surface.region[index(t)])]++)] = t;
    return rows;
}

std::string toWord(std::string_view name) {
    std::string word;
    std::ranges::copy_if(name, std::back_inserter(word), isWordCharacter);
    if (!word.empty() && cannotBegin(word.front())) word.insert(word.begin(), '_');
    return word;
}

} // namespace polymesh
