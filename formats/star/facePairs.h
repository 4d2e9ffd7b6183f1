// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/star/cellRecords.h"

#include <vector>

namespace polymesh::star {

/// How the faces of cells meet.
struct FacePairs {
    std::vector<Label> cellOf;  // one for each face
    std::vector<Label> partner; // the face of another cell with the same points; -1: none
};

/// Pairs the faces that have the same points in the same cyclic order. Where two cells lie on the
/// same side of a face, the ones with a negative volume are turned inside out, and so are all cells
/// when the mesh as a whole has a negative volume; a note says so.
/// Throws InputError for cells that meet in another way: three in one face, two on one side, a cell
/// with itself.
/// Cost: O(face corners), with all threads; the same for any number of them.
FacePairs pairFaces(const TextFile& file, const std::vector<Vec3>& points, CellRecords& cells);

} // namespace polymesh::star
