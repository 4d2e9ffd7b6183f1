// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polymesh::star {

/// What a command file (.inp) tells about the numbers in the other files.
struct Names {
    struct Table {
        std::string name;
        std::string type; // fluid, solid, ...
    };

    struct Region {
        std::string name;
        std::string type;     // WALL, ...
        std::string foamType; // OpenFOAM's, where STAR-CD's type does not give it
        std::vector<std::pair<std::string, std::string>> entries; // of OpenFOAM's patch
    };

    std::map<Label, Table> tables;   // entries of the cell table by number
    std::map<Label, Region> regions; // by number
};

/// The cells that are in no zone have a cell table entry of this name, as foamToStarMesh calls it.
inline constexpr std::string_view unzonedCells = "__unZonedCells__";

/// Finds the commands CTABLE, CTNAME, RDEFINE and RNAME (of which four letters count, in upper or
/// lower case) and the comments that writeNames adds for OpenFOAM. Everything else in the file,
/// which may be any program, is passed over.
Names readNames(std::string_view text);

/// A command file that makes pro-STAR read the files `stem`.vrt, .cel, .bnd with these names.
std::string writeNames(const Names& names, const std::string& stem);

} // namespace polymesh::star
