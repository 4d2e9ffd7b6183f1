// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/blocks.h"

namespace polymesh {

/// Makes internal what two patches have in common: each face of the smaller one must have the
/// points of one of the other, up to a tenth of the shortest edge there; faces of the larger one
/// that are left over stay in it. A patch that becomes empty goes. Throws InputError, which begins
/// with the pair's place, for unknown patches, and with "is not supported" when faces would have to
/// be cut. Cost: O(n log n) in the faces of the mesh.
void mergePatches(PolyMesh& mesh, const PatchPair& pair);

} // namespace polymesh
