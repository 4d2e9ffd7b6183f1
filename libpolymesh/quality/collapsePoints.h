// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <span>

namespace polymesh {

/// What collapsePoints did.
struct CollapseCounts {
    Label removedFaces = 0; // faces with fewer than 3 points left, and flat pairs
    Label removedCells = 0; // cells of which no face was left
    Label addedCells = 0;   // parts of cells that hung together at a point or an edge only
    Label brokenCells = 0;  // cells that could not be closed: 0 for coincident points
};

/// Gives every point the label representative[p] (p itself: it stays) and repairs what that does:
/// repeated points go, faces that touch themselves are cut there, faces with fewer than 3 points
/// go, pairs of faces on both sides of nothing go, cells with no face left go (what was on their
/// two sides is joined, or gets the patch), cells that fall apart become several. Points are not
/// removed. Requires: representative[representative[p]] == representative[p]; points of frozen
/// cells stay. Cost: linear, small constant for what is not touched.
CollapseCounts collapsePoints(MeshEditor& editor, std::span<const Label> representative);

/// Replaces the corners of a face by a closed walk: the face becomes the simple loops of the walk,
/// and is removed when there is none.
void setFaceWalk(MeshEditor& editor, Label face, const Polygon& walk);

/// Cancels flat pairs in the cells, in their neighbours as far as they are touched, takes flat
/// parts out of cells that touch themselves along an edge (a face that lies on a part of another),
/// and separates the parts of cells; for cells whose faces have been given new points.
CollapseCounts tidyCells(MeshEditor& editor, std::vector<Label> cells);

} // namespace polymesh
