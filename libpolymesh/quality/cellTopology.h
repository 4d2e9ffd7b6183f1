// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <boost/container/small_vector.hpp>

#include <array>
#include <span>
#include <vector>

namespace polymesh {

/// One use of an edge by a face of a cell: low < high are its points; `forward` when the face, seen
/// from outside the cell, runs from low to high.
struct EdgeUse {
    Label low = -1;
    Label high = -1;
    Label face = -1;
    bool forward = true;
};

/// All uses of the edges of a cell, uses of one edge together, by low, high, face. Cost: a small
/// sort.
void collectEdgeUses(const EditMesh& mesh, Label cell, std::vector<EdgeUse>& uses);

/// The two faces of each wedge of a cell at an edge.
using Wedges = boost::container::small_vector<std::array<Label, 2>, 4>;

/// The wedges of a cell round an edge that it uses more than once in each direction, by the angles
/// of the faces: each starts, going round the edge from low to high, at a face that runs backward
/// and ends at one that runs forward. `uses`: all of the edge.
Wedges wedgesRound(MeshEditor& editor, Label cell, std::span<const EdgeUse> uses);

/// The cells that use a point, frozen ones too: ascending.
std::vector<Label> cellsOfPoint(const MeshEditor& editor, Label p);

/// What the faces of a cell enclose.
enum class CellShape : std::uint8_t {
    ball,   // closed, in one piece, every edge between two faces, no holes, at least 4 faces
    closed, // every edge is used once in each direction, but it is not a ball
    broken  // some edge is not
};

CellShape cellShape(const EditMesh& mesh, Label cell);

/// True when each of the cells is a ball, or removed, or frozen.
bool allBalls(const MeshEditor& editor, std::span<const Label> cells);

/// Removes pairs of faces of a cell that have the same points and opposite directions: the cell has
/// no thickness between them. What lies on both sides is joined through one remaining face.
/// Cells whose faces change are added to `touched`. Returns the number of pairs.
Label cancelFlatPairs(MeshEditor& editor, Label cell, std::vector<Label>& touched);

/// Makes a cell whose faces hang together at points, or at edges used more than twice, into one
/// cell for each part; the first part stays. Returns the number of cells added.
Label separateParts(MeshEditor& editor, Label cell);

} // namespace polymesh
