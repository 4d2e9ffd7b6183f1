// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/editMesh.h"

#include <functional>
#include <vector>

namespace polymesh {

/// A division of the cells of an EditMesh into parts that can be edited side by side.
struct CellParts {
    std::vector<Label> ofCell; // part of each cell; -1: none, the cell stays as it is
    Label count = 0;
};

/// Divides the cells by planes across the longest side of the mesh into slabs of at least
/// `leastCells` cells each, the same ones however cells and points are numbered.
/// Frozen and removed cells belong to none. Cost: O(cells).
CellParts divideIntoSlabs(const EditMesh& mesh, Label leastCells);

/// The cells within some rings of face neighbours of where two parts meet: one part for each pair
/// of parts that meet, so that what could not be edited there can be now. Cost: O(faces).
CellParts alongSeams(const EditMesh& mesh, const CellParts& parts);

/// An edit of a part's own mesh; the cells that it returns are of note to the caller.
using EditOfPart = std::function<std::vector<Label>(EditMesh& mesh, Label part)>;

/// Calls edit(part's own mesh, part) for each part, in parallel, and takes over what it has
/// changed; new cells join the part that made them. In a part's mesh the cells next to it are
/// frozen, and so are the points that others use, so that no two parts ever change the same thing:
/// the result does not depend on the number of threads. Returns the cells that the edits returned,
/// with their labels in the whole, part by part. Cost: a copy of each part.
std::vector<Label> editParts(EditMesh& mesh, CellParts& parts, const EditOfPart& edit);

} // namespace polymesh
