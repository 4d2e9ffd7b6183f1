// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <optional>
#include <vector>

namespace polymesh {

/// A corner of a loop on the surface of a cell: a point, or the place where a plane crosses an
/// edge.
struct LoopCorner {
    Label point = -1; // -1: on the edge low-high, at `position`
    Label low = -1;
    Label high = -1;
    Vec3 position;         // [m]
    double offPlane = 0;   // [m] distance from the plane: of points that were taken though near it
    Label faceToNext = -1; // the face to cut from here to the next corner; -1: they share an edge
};

/// A closed walk on the surface of a cell, along edges and across faces, that cuts it in two.
using CellLoop = std::vector<LoopCorner>;

/// A plane through an edge of a cell.
struct EdgePlane {
    Label a = -1; // the edge's points
    Label b = -1;
    Vec3 normal; // unit
};

/// What a loop may not use: the edges at which the surface does not need to be cut.
using EdgeList = std::vector<std::pair<Label, Label>>;

/// The shortest loop through the edge of the plane along which the plane cuts the surface of the
/// cell; points nearer to the plane than `snap` times the length of a crossed edge are taken
/// instead of a crossing. Weights: 1 a step, and more the farther a corner is from the plane. No
/// loop where the plane does not close one or where it would cut a frozen face. Cost: some small
/// sorts.
std::optional<CellLoop> findCuttingLoop(
    MeshEditor& editor, Label cell, const EdgePlane& plane, double snap, const EdgeList& forbidden);

/// Cuts a cell along a loop: new points go into their edges and faces are cut, for all cells that
/// share them; then the loop becomes a face between the cell and a new one. Returns the new cell;
/// -1 when the loop does not cut the cell in two or would pinch a cell, and the caller then undoes.
/// Requires: the cells that share the faces are balls; then they and both parts are balls after it.
Label cutCell(MeshEditor& editor, Label cell, const CellLoop& loop);

/// Cuts a face from one of its points to another that is not next to it. False when a part would
/// have fewer than 3 points or the face is frozen.
bool splitFace(MeshEditor& editor, Label face, Label a, Label b);

} // namespace polymesh
