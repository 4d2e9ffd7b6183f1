// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/hexCells.h"
#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/refine/criterion.h"
#include "libpolymesh/refine/processAddressing.h"
#include "libpolymesh/refine/processes.h"

#include <vector>

namespace polymesh {

struct RefineOptions {
    std::vector<Criterion> criteria; // any of them suffices
    int bufferLayers = 1;
};

struct RefinedMesh {
    PolyMesh mesh;
    std::vector<Label> cellLevel;  // how often an initial cell was halved
    std::vector<Label> pointLevel; // at which level a point came up; 0: of the initial mesh
    ProcessAddressing addressing;  // with several processes
};

/// Divides cells into eight, again and again, until no criterion wants more or mostLevel is
/// reached; cells that touch differ by one level at most. Cells are numbered initial cell by
/// initial cell, in each along the curve of its octants; initial points keep their numbers. Patches
/// and zones stay.
///
/// With several processes each makes its part, of consecutive cells: all know the initial mesh and
/// which octants are divided, each the points and faces of its part only. Together the parts are
/// the mesh that one process makes. The cells between parts are joined by patches of type
/// processor.
RefinedMesh
refine(const HexCells& cells, const RefineOptions& options, const Processes& processes = {});

} // namespace polymesh
