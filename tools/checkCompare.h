// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/surface/triSurface.h"
#include "tools/toolMain.h"

namespace polymesh::tools {

/// checkMesh -surface: prints volume, area and distances beside the surface's, for the whole and
/// for each patch, and adds them to the report as `surface`.
void compareWithSurface(ToolRun& tool, const PolyMesh& mesh, const TriSurface& surface);

/// checkMesh -tetgen: prints how TetGen's volumes of the surface (when not null) and of every cell
/// that is not a hexahedron agree with ours, and adds that to the report as `tetgen`.
void compareWithTetgen(ToolRun& tool, const PolyMesh& mesh, const TriSurface* surface);

} // namespace polymesh::tools
