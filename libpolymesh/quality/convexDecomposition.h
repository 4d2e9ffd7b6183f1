// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/quality/meshEditor.h"
#include "libpolymesh/quality/workBudget.h"

#include <span>
#include <vector>

namespace polymesh {

/// When a cell is convex enough, and how far the decomposition may go.
struct DecompositionOptions {
    /// [rad] A cell is convex when the angle inside at none of its edges, and at no corner of its
    /// faces, is larger than 180 degrees and this.
    double angle = 0.1;
    Label maxCuts = 40; // for each of the cells given
};

/// What a decomposition did.
struct DecompositionCounts {
    Label concaveCells = 0;       // of the cells given, those that were not convex
    Label cuts = 0;               // each adds a cell
    Label edgePoints = 0;         // new points on edges, where cuts cross them
    Label cellPoints = 0;         // cells that got a point inside, and a pyramid for each face
    Label splitFaces = 0;         // faces that were cut though no cut of a cell crosses them
    std::vector<Label> remaining; // cells that are still not convex, ascending
};

/// The cells that are not convex, ascending. Cost: all cells are looked at, in parallel.
std::vector<Label> concaveCells(const PolyMesh& mesh, double angle);

/// Decomposes each of the cells that is not convex into convex ones: cuts along closed loops
/// through its reflex edges; where no cut helps, a point inside that sees all faces is joined to
/// them. Then concave faces are cut from corner to corner. Faces are cut alike for both cells that
/// share them, so the mesh stays conformal; neighbours get more faces, but of the same shape as a
/// whole. Points never move, volumes stay.
/// The first part of a cell keeps its label; the others follow after the last cell, in the order of
/// the cells that they are parts of. Patches stay, parts of a boundary face follow each other in
/// its place; parts belong to the zones of the whole; new points come last and belong to no zone.
/// `origins`, if given, gets for each cell of the new mesh the cell that it is a part of.
/// Requires: a valid mesh; cells ascending. The result is valid (mesh/validate.h).
/// Cost: linear in the mesh with a small constant, about a millisecond for a cell to decompose.
/// Source: W. Oaks, S. Paoletti, Polyhedral mesh generation, section 3.2.
DecompositionCounts decomposeCells(PolyMesh& mesh,
                                   std::span<const Label> cells,
                                   const DecompositionOptions& options = {},
                                   std::vector<Label>* origins = nullptr);

/// The same for one cell of a mesh that is being edited; `remaining` has parts of it. Can be taken
/// back. The budget ends the cuts.
DecompositionCounts decomposeCell(MeshEditor& editor,
                                  Label cell,
                                  const DecompositionOptions& options,
                                  WorkBudget& budget);

} // namespace polymesh
