// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/midPointSubdivision.h"

#include <span>
#include <vector>

namespace polymesh {

/// The parts of these cells, ascending.
std::vector<Label> dividedCells(const SubdivisionPlan& plan, std::span<const Label> cells);

/// These points and the new points that are made of none but them, ascending.
std::vector<Label>
dividedPoints(const PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> points);

/// Gives the divided mesh `result` the zones of `mesh`; a part is in the zones of its cell or face
/// and faces the same way. children[i], beside mesh.faces.values, is the divided face at that
/// corner; it may be empty when there are no face zones. Cost: linear.
void divideZones(const PolyMesh& mesh,
                 const SubdivisionPlan& plan,
                 const std::vector<Label>& children,
                 PolyMesh& result);

} // namespace polymesh
