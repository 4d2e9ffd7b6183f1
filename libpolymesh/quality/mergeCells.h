// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <vector>

namespace polymesh {

/// A cell with which another one could be merged, and the area [m^2] of the faces between them.
struct MergePartner {
    Label cell = -1;
    double area = 0;
};

/// The edited neighbours of a cell, the one with the largest common area first.
std::vector<MergePartner> mergePartners(MeshEditor& editor, Label cell);

/// Merges the cell `from` into the cell `into`: their common faces go, then pairs of faces against
/// the same third cell (nearly coplanar) or on the same patch (coplanar) that only an edge between
/// the two cells kept apart become one, then points that are redundant go. False when the merged
/// cell would not be a ball; the caller then undoes. Cost: what is round the two cells.
bool mergeCells(MeshEditor& editor, Label from, Label into);

/// Merges `cell` into the partner with which it makes the least concave cell, among those that
/// leave the cells round it no worse than before; of equal ones the one with the largest common
/// area. Returns the partner, or -1 when every one was refused.
Label mergeIntoBestPartner(MeshEditor& editor, Label cell);

/// Merges every cell with a volume below minVolume times the cube of its size into a neighbour,
/// unless that makes cells worse. Returns the number of cells that went. Frozen cells are left
/// alone, and so are small ones that share most area with one of them: at the seam of a slab that
/// is where they belong once the seam is edited. Cost: linear, small constant for cells that are
/// large enough.
Label mergeSmallCells(MeshEditor& editor, double minVolume);

} // namespace polymesh
