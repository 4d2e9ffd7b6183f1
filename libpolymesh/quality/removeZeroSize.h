// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

namespace polymesh {

/// What removeZeroSize did.
struct ZeroSizeCounts {
    Label points = 0;         // points that lay on another point, up to rounding
    Label edges = 0;          // edges that got a point which lay on them
    Label cells = 0;          // cells without volume, merged into a neighbour or removed
    Label remainingCells = 0; // cells without volume that no neighbour could take
};

/// Removes what has no size but rounding errors: edges as short as that, faces that run back along
/// themselves (a point lies on an edge: the edge gets the point, in every cell round it, and the
/// face loses its spike), and cells without volume, which go to the neighbour across their largest
/// face, so that their boundary faces become its own. Nothing moves by more than 1e-10 of a cell.
/// Cost: linear, small constant for what has a size.
ZeroSizeCounts removeZeroSize(MeshEditor& editor);

/// Puts the point p into the edge a-b of all faces round it. False when a frozen cell may use the
/// edge.
bool insertPointInEdge(MeshEditor& editor, Label a, Label b, Label p);

/// Gives all faces of the point `from` the point `to` instead, and tidies the cells round it.
/// Returns the number of cells that are left broken or in more than one piece: 0 when all is well.
Label replacePoint(MeshEditor& editor, Label from, Label to);

} // namespace polymesh
