// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/meshRegion.h"

#include <span>
#include <utility>
#include <vector>

namespace polymesh {

/// The cells that come from the same as one of `cells`, or as one beside such a cell, in pairs to
/// join (joinCells.h) so that each is whole again; but for those that would have edges of more than
/// two faces then. Cost: linear.
std::vector<std::pair<Label, Label>>
piecesRound(const EditedMesh& edited, const Rows<Label>& cellFaces, std::span<const Label> cells);

/// Takes points out that no face has any more, from the zones too. Cost: linear.
void dropUnusedPoints(EditedMesh& edited);

} // namespace polymesh
