// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"
#include "libpolymesh/surface/tetMesh.h"

#include <span>
#include <vector>

namespace polymesh {

/// What came of filling a cell.
struct Filled {
    std::vector<Label> pieces;   // none: nothing was changed
    std::vector<Label> inTheWay; // faces on account of which: they cross others, or no point under
                                 // them sees them; with tetrahedra none
};

/// Replaces a cell of any form by tetrahedra and, under those faces that stay as they are because
/// they have more than three points, pyramids of little height: faces that other cells share are
/// never touched. Boundary faces become triangles first that bound the same volume, where they can.
/// Of several heights of the pyramids the one that leaves the least badness is taken.
/// Requires: the cell is a ball. Cost: some milliseconds.
Filled fillWithTetrahedra(MeshEditor& editor, Label cell, const Tetrahedraliser& tetrahedralise);

/// The faces of a cell that cross each other, or that no point under them sees: none of a cell
/// whose faces bound a body. Faces of more than three points count as low pyramids.
std::vector<Label> facesInTheWay(MeshEditor& editor, Label cell);

} // namespace polymesh
