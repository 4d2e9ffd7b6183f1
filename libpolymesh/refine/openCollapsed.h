// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/refine/macroMesh.h"

#include <vector>

namespace polymesh {

/// Hexahedra with eight different corners each: where edges have collapsed, points have copies.
struct OpenedCells {
    std::vector<MacroMesh::Corners> corners;
    std::vector<Label> original; // of each point, copies last: itself, or what it is a copy of
};

/// Gives corners of a cell that are one point copies of it, so that the cells become trees that are
/// whole. Cells that have a side in common share its copies; sides that have collapsed to an edge
/// or a point have nothing across.
/// Throws InputError when only two cells are round a collapsed side: they would touch twice.
/// Cost: n log n in the cells at such points, and a pass over all cells.
OpenedCells openCollapsed(std::span<const MacroMesh::Corners> corners, Label pointCount);

} // namespace polymesh
