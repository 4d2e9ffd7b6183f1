// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/cuttingLoop.h"

#include <vector>

namespace polymesh {

/// Cuts that need no plane and no new points: they part a point, the two points of an edge or those
/// of a face from the rest of a cell, along the points next to them. Where a cell is concave in a
/// way that planes do not cut, such a piece may be what is in the way.
std::vector<CellLoop> rimCuts(const MeshEditor& editor, Label cell);

} // namespace polymesh
