// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/loops.h"
#include "libpolymesh/trimCell/joinSites.h"

namespace polymesh {

/// Puts the outlines on mesh faces together, each of which two cells have found by themselves, and
/// opens holes. Fills `segments` of the arrangement.
/// Throws WorkError where two cells disagree about what is left of the face between them.
/// Cost: O(steps) and small sorts.
FaceLoops
joinOutlines(const JoinInputs& inputs, const PointPositions& positions, Arrangement& arrangement);

} // namespace polymesh
