// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/star/assemble.h"
#include "formats/star/names.h"
#include "formats/star/starFiles.h"

namespace polymesh::star {

/// The patches of a mesh that was read: one for each region that has records or a name, by number;
/// one for the baffles of each cell table entry that have no region; last, when there are faces
/// without a region, Default_Boundary_Region. Names that `names` does not give are those of
/// OpenFOAM's converters: wall_1 (version 4), WALL1 (version 3).
PatchFaces patchesOf(const CellMesh& mesh,
                     const BoundaryRecords& records,
                     const Names& names,
                     Version version);

/// The cells of each entry of the cell table as zones; none for cells of a single entry without a
/// name and for those of the entry of cells in no zone.
std::vector<Zone> zonesOf(const CellRecords& cells, const Names& names);

} // namespace polymesh::star
