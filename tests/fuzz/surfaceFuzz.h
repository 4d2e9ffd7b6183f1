// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the fuzz targets of surfaces share: a law that does not hold ends the program.

#include "libpolymesh/base/error.h"
#include "libpolymesh/surface/regions.h"
#include "libpolymesh/surface/triSurface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <string_view>

namespace polymesh::fuzz {

inline void demand(bool holds, const char* law) {
    if (holds) return;
    fmt::print(stderr, "broken: {}\n", law);
    std::abort();
}

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// The laws of TriSurface.
inline void demandLaws(const TriSurface& surface) {
    demand(std::set<Vec3>(surface.points.begin(), surface.points.end()).size() ==
               surface.points.size(),
           "no two points are equal");
    demand(std::ranges::all_of(surface.points, isFinite), "coordinates are finite");
    std::vector<char> isUsed(surface.points.size(), 0);
    for (const auto& corners : surface.triangles) {
        for (Label corner : corners) {
            demand(corner >= 0 && corner < surface.pointCount(), "corners are points");
            isUsed[index(corner)] = 1;
        }
        demand(corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0],
               "corners are distinct");
    }
    demand(std::ranges::count(isUsed, 0) == 0, "every point is used");
    demand(surface.region.size() == surface.triangles.size(), "every triangle has a region");
    for (Label region : surface.region)
        demand(region >= 0 && region < toLabel(surface.regionNames.size()), "regions exist");
    for (const auto& name : surface.regionNames)
        demand(!name.empty() && toWord(name) == name, "names are words");
    demand(std::set<std::string>(surface.regionNames.begin(), surface.regionNames.end()).size() ==
               surface.regionNames.size(),
           "names are distinct");
}

/// Reads the input, which may fail in one way only; then writes it and reads it again.
template<class Read, class Write>
void testReader(std::string_view input, Read&& read, Write&& write) {
    TriSurface surface;
    try {
        surface = read(input, "input", "part");
    } catch (const InputError&) {
        return;
    }
    demandLaws(surface);
    const TriSurface again = read(write(surface), "output", "part");
    demand(again.triangles.size() == surface.triangles.size(), "what was written can be read");
    demand(again.points.size() == surface.points.size(), "points stay the same in number");
}

} // namespace polymesh::fuzz
