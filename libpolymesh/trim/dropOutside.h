// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/trim/probe.h"

#include <cstdint>
#include <vector>

namespace polymesh {

/// Takes the cells out of the mesh that are neither probed nor inside (winding number 1 or more),
/// with the faces and points that only they use, and renumbers what the probe and `cellWinding`
/// (one per mesh cell) say of the rest. A probed face next to a cell that goes gets the mesh face
/// -1. Zones and patches are renumbered too. Nothing happens where less than a fifth of the cells
/// would go.
/// Why: the box round a part often holds four times the cells of the part; letting them go halves
/// the memory of all that follows. In place; cost: O(mesh).
void dropOutside(PolyMesh& mesh, Probe& probe, std::vector<std::int8_t>& cellWinding);

} // namespace polymesh
