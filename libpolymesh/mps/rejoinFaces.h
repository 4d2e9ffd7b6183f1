// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/meshRegion.h"
#include "libpolymesh/mps/midPointSubdivision.h"

#include <span>

namespace polymesh {

/// Joins the faces of `cells` (ascending) that are pieces of one: that are between the same cells,
/// or come from the same boundary face, are in the same zones and meet at an edge of no other face.
/// Those stay apart that do not make a polygon. The first of them has the polygon, the others are
/// gone, and points within may be of no face any more. Returns how many are gone. Cost: linear.
Label rejoinFaces(EditedMesh& edited, const SubdivisionPlan& plan, std::span<const Label> cells);

} // namespace polymesh
