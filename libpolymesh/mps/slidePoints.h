// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/midPointSubdivision.h"

#include <span>

namespace polymesh {

/// Slides points along edges where triangles of `cells` cross whatever diagonals they have, as in a
/// face that crosses itself: points inside, and those of the surface where all boundary faces are
/// in one plane and one patch, within that, so that the surface and its volume stay. A move is made
/// when fewer triangles cross in all the cells of the point. Returns how many points moved.
/// Cost: up to a second for a cell with such triangles.
Label slidePoints(PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> cells);

} // namespace polymesh
