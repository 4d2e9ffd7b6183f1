// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/cuttingLoop.h"

namespace polymesh {

/// Cuts a cell along closed loops: new points go into their edges and faces are cut, for all cells
/// that share them; then each loop becomes a face between the cell and a new one. Returns the new
/// cell; -1 when the loops do not cut the cell in two, would pinch a cell or are far from
/// flat, and the caller then undoes. Requires: the cells that share the faces are in one piece;
/// those that are balls remain so, and the parts of a ball are balls.
Label cutCell(MeshEditor& editor, Label cell, const CellCut& cut);
Label cutCell(MeshEditor& editor, Label cell, const CellLoop& loop);

/// True when a face of the cell has the edge a-b.
bool cellHasEdge(const MeshEditor& editor, Label cell, Label a, Label b);

/// Cuts a face from one of its points to another that is not next to it. False when a part would
/// have fewer than 3 points or the face is frozen.
bool splitFace(MeshEditor& editor, Label face, Label a, Label b);

} // namespace polymesh
