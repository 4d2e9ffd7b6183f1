// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/base/rows.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <array>
#include <vector>

namespace polymesh {

// Addressing derived from a mesh. All functions require labels in range (validate.h) and take
// O(face corners) time.

/// Faces of each cell: those that it owns, ascending, then the others, ascending.
Rows<Label> cellFaces(const PolyMesh& mesh);

/// Faces that use each point, ascending. A face that lists a point twice appears twice.
Rows<Label> pointFaces(const PolyMesh& mesh);

/// Cells that use each point, ascending.
Rows<Label> pointCells(const PolyMesh& mesh);

/// Distinct points of each cell, ascending.
Rows<Label> cellPoints(const PolyMesh& mesh, const Rows<Label>& cellFaces);

/// An undirected edge: its points, the lower label first.
using Edge = std::array<Label, 2>;

/// The distinct edges of all faces, ascending.
std::vector<Edge> edges(const PolyMesh& mesh);

/// Number, from 0, of the part of the mesh that each cell lies in, where parts are joined through
/// internal faces. Parts are numbered in the order of their lowest cells.
std::vector<Label> cellRegions(const PolyMesh& mesh);

/// True for faces of patches that OpenFOAM couples to other cells (cyclic, processor, ...).
bool isCoupledType(const std::string& patchType);

} // namespace polymesh
