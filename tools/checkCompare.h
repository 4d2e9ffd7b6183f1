// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/surface/triSurface.h"
#include "tools/toolMain.h"

#include <string>

namespace polymesh::tools {

/// Reads the surface to compare with and turns it as trimSurface does; tells what was turned, and
/// whether it is open, there and in the report's `surface`.
TriSurface readToCompare(ToolRun& tool, const std::string& file);

/// checkMesh -surface: prints volume, area and distances beside the surface's, for the whole and
/// for each patch, and adds them to the report's `surface`.
void compareWithSurface(ToolRun& tool, const PolyMesh& mesh, const TriSurface& surface);

/// checkMesh -tetgen: prints how TetGen's volumes of the surface (when not null) and of every cell
/// that is not a hexahedron agree with ours, and adds that to the report as `tetgen`.
void compareWithTetgen(ToolRun& tool, const PolyMesh& mesh, const TriSurface* surface);

} // namespace polymesh::tools
