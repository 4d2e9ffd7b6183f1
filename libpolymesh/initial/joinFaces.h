// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"

#include <array>
#include <vector>

namespace polymesh {

/// Two boundary faces that are one.
using FacePair = std::array<Label, 2>;

/// Makes internal faces of pairs of boundary faces. `merged` has for each point the one that takes
/// its place, itself for those that stay (and for all that take a place). The two faces of a pair
/// then have the same points and belong to different cells. Patches that lose all their faces go;
/// those that were empty stay. Point and face zones are dropped.
/// Cost: O(n log n) in the faces of the mesh.
void joinFaces(PolyMesh& mesh, std::vector<Label> merged, const std::vector<FacePair>& pairs);

} // namespace polymesh
