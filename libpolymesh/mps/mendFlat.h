// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"
#include "libpolymesh/surface/tetMesh.h"

#include <vector>

namespace polymesh {

/// Replaces flat tetrahedra, which lie on two triangles of a plane: the tetrahedra round one of
/// their edges or points become others over a new point among them, where that makes better ones.
/// The sides of all together stay. `points`: of the surface and the new ones, which grow.
/// Requires: tetrahedra (a, b, c, d) with det(b - a, c - a, d - a) > 0. Cost: linear for a flat
/// one.
void mendFlat(std::vector<Vec3>& points, TetMesh& mesh);

} // namespace polymesh
