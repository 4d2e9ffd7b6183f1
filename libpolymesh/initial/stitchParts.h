// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/meshParts.h"

#include <vector>

namespace polymesh {

/// Points of different parts that are nearer than this fraction of the shortest boundary edge at
/// either of them are one.
constexpr double stitchDistance = 0.01;

/// Joins parts of a mesh that so far have no points in common: where boundary faces of two parts
/// have the same points, they become one internal face. Patches that lose all their faces go.
/// Throws InputError, which begins with the place of a part, where parts overlap, where they touch
/// without the same faces or miss each other by a little (see refuseMisfits in partMisfits.h), and
/// for a part that is joined with none of the others.
/// Cost: O(n log n) in the faces of the mesh.
void stitchParts(PolyMesh& mesh, const std::vector<MeshPart>& parts);

} // namespace polymesh
