// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/shapeSplit/fillWithTetrahedra.h"

#include <functional>
#include <vector>

namespace polymesh {

/// What changes of pieces may do.
struct MendMeans {
    Label firstNewCell = 0;                     // cells from here on may go
    Label firstNewPoint = 0;                    // interior points from here on may move
    std::function<bool(Label, Label)> mayUnite; // two neighbouring cells, by zones
    const Tetrahedraliser* tetrahedralise = nullptr;
    std::vector<Label> tolerated; // cells that are left as they are; ascending
};

/// A local change that may mend a piece. To be made in the state in which it was listed.
struct PieceChange {
    std::vector<Label> cells;   // it changes these at least
    std::function<bool()> make; // false when it cannot be made, and the caller then undoes
};

/// Changes of what a cell consists of: it becomes one with a neighbour; a face of it is cut, and
/// the cells on both sides along the cut; alone or with a neighbour it becomes pyramids or
/// tetrahedra. The editor and the means have to live as long as the changes.
std::vector<PieceChange> changesOfPiece(MeshEditor& editor, const MendMeans& means, Label cell);

/// Moves of the cell's new points.
std::vector<PieceChange> movesOfPiece(MeshEditor& editor, const MendMeans& means, Label cell);

/// Changes that cost more: the cell and two neighbours become tetrahedra; all pieces of a cell of
/// the initial mesh, alone or with those of a neighbour, become other pyramids or tetrahedra.
std::vector<PieceChange> wideChanges(MeshEditor& editor, const MendMeans& means, Label cell);

/// Changes that cost most: all pieces of a cell of the initial mesh and of two neighbours.
std::vector<PieceChange> widestChanges(MeshEditor& editor, const MendMeans& means, Label cell);

} // namespace polymesh
