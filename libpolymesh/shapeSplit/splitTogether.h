// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/shapeSplit/fillWithTetrahedra.h"

#include <limits>
#include <span>

namespace polymesh {

/// Unites a cell with others, each of which shares faces with the cell or with one before it; these
/// are left without faces. False, and nothing is changed, when that does not make a ball, or would
/// leave a point before `firstNewPoint` without a face.
bool uniteCells(MeshEditor& editor,
                Label cell,
                std::span<const Label> others,
                Label firstNewPoint = std::numeric_limits<Label>::max());

/// Gives the last of the pieces of a united cell the labels of the cells that it was united with.
void nameAfterCells(MeshEditor& editor,
                    std::span<const Label> pieces,
                    std::span<const Label> others);

/// Splits a cell together with others, each of which shares faces with the cell or with one before
/// it: the faces between them go, and where one point sees all the rest they become pyramids on
/// these. Faces of further cells stay. False, and nothing is changed, when the cells do not make a
/// ball or no such point is found. With `mayFold` a point behind all faces will do (innerPoint.h).
bool splitTogether(MeshEditor& editor, Label cell, std::span<const Label> others, bool mayFold);

/// The same with tetrahedra instead of pyramids round one point. None when the cells cannot be
/// united.
std::optional<Filled> fillTogether(MeshEditor& editor,
                                   Label cell,
                                   std::span<const Label> others,
                                   const Tetrahedraliser& tetrahedralise);

} // namespace polymesh
