// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <span>

namespace polymesh {

/// Takes apart the wedges of cells that touch themselves along an edge, as cells do where the
/// surface does (it uses the edge for four triangles): they would use it more than once in each
/// direction. Each wedge but one gets a point of its own in the middle of the edge, with all faces
/// round the edge that internal faces connect it to; no shape changes. Returns the number of cells
/// that are not closed even so: wedges that reach frozen cells, or each other, stay together.
/// Cost: the sort of a cell's edges, for each cell.
Label separatePinches(MeshEditor& editor);

} // namespace polymesh
