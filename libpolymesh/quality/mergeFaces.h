// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

namespace polymesh {

/// Merges faces that lie in one plane: boundary faces of one cell on the same patch, and faces
/// between the same two cells, that have an edge in common and whose normals differ by at most
/// `angle` [rad]; 0 asks for exactly coplanar ones (up to rounding). Only where the union is a disc
/// and no cell gets worse; cells with more than 64 faces are passed over; points that become
/// redundant go. Returns the number of faces that went. Cost: linear, small constant where there is
/// nothing to merge.
Label mergeFaces(MeshEditor& editor, double angle);

/// True when two faces of `cell` bound it against the same cell, or on the same patch.
bool isSameInterface(const MeshEditor& editor, Label f, Label g, Label cell);

/// True when the faces of `cell` turn by at most `angle` [rad] from one to the other; with angle 0
/// when all their points lie in one plane up to rounding.
bool isCoplanar(MeshEditor& editor, Label f, Label g, Label cell, double angle);

/// Makes face f of `cell` the union of f and g and removes g. False, and nothing is changed, when
/// the union is not a disc or a face is frozen.
bool uniteFaces(MeshEditor& editor, Label f, Label g, Label cell);

/// Takes a point out of all its faces when it is on a straight line between the same two neighbours
/// in every one of them and nothing else needs it. False when it has to stay.
bool dropRedundantPoint(MeshEditor& editor, Label p);

} // namespace polymesh
