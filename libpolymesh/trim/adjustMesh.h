// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/surface/triSurface.h"
#include "libpolymesh/trim/trim.h"

namespace polymesh {

/// Moves nodes as `trim` does before it cuts, with projected nodes on the surface. No cell gets a
/// part that is too small; `options.keep`, `featureAngle` and `adjust` count.
/// Requires: as trim. Cost: see adjustNodes.
AdjustCounts adjustMesh(PolyMesh& mesh, TriSurface surface, const TrimOptions& options);

} // namespace polymesh
