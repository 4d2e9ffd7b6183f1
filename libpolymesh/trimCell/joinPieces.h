// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/pieces.h"
#include "libpolymesh/trimCell/joinSites.h"

namespace polymesh {

/// Lists the parts of triangles in all cells, in order. Cost: O(steps).
CellPieces joinPieces(const JoinInputs& inputs, const Arrangement& arrangement);

} // namespace polymesh
