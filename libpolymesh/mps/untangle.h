// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/midPointSubdivision.h"

namespace polymesh {

/// Moves points of the divided mesh inside the domain so that parts which are flat or inverted at
/// a corner no longer are: at hanging nodes, which lie on a straight edge or flat face of a coarse
/// cell, every subdivision is flat, and a small step towards the finer side makes it right. No part
/// that is right becomes wrong; points on the boundary stay. Takes the cells that are cured out of
/// plan.inverted. Returns the number of points moved.
/// Each corner's Jacobian is linear in each of its four points, so that a point is right within an
/// intersection of half-spaces (pointWithin.h); the points of inverted corners are tried in turn.
/// Cost: linear for the addressing when there are such cells, then some 0.1 ms a cell.
Label untangle(const PolyMesh& mesh, SubdivisionPlan& plan);

} // namespace polymesh
