// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/star/facePairs.h"
#include "libpolymesh/base/error.h"

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace polymesh::star {

/// What a boundary file says: faces of regions, in the order of its records, none twice.
struct BoundaryRecords {
    std::vector<Label> faces;           // of CellRecords
    std::vector<Label> regions;         // number of the region of each
    std::map<Label, std::string> types; // of all regions, by number
    std::vector<std::string> notes;     // what was left out
};

/// Notes that so many records of the file are left out, and why; nothing when there are none.
inline void
noteLeftOut(BoundaryRecords& records, const TextFile& file, Label count, std::string_view why) {
    if (count > 0)
        records.notes.push_back(
            fmt::format("{}: {} records {} and are left out", file.name, count, why));
}

/// The two faces of cells that lie on each baffle.
using BaffleSides = std::vector<std::array<Label, 2>>;

/// Parts the pairs of faces that baffles lie between: each becomes two boundary faces. Throws
/// InputError with the line for a baffle that lies between no two cells, or on another baffle.
/// Cost: O((F + B) log B).
BaffleSides openBaffles(const TextFile& file, const CellRecords& cells, FacePairs& pairs);

/// A mesh as far as the cell file gives it.
struct CellMesh {
    const Vertices& vertices;
    const CellRecords& cells;
    const FacePairs& pairs;
    const BaffleSides& baffles;
};

/// Reads records of version 4: cell number and face number. Region 0 is that of the faces that have
/// no record. Throws InputError with the line for a number that does not exist.
BoundaryRecords readBoundary4(const TextFile& file, const CellMesh& mesh);

/// Reads records of version 3: four vertices, of which the last two are equal for a triangle. The
/// face is the boundary face with the same points; else the one with the fewest corners that has
/// them all. Of two such faces (the sides of a baffle) the one that runs the same way round.
/// Throws InputError with the line for a number that does not exist.
BoundaryRecords readBoundary3(const TextFile& file, const CellMesh& mesh);

} // namespace polymesh::star
