// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/midPointSubdivision.h"
#include "tools/toolMain.h"

#include <vector>

namespace polymesh::tools {

/// A cell that can not be divided without an inverted part.
struct InvertedCell {
    Label cell = -1;     // of the undivided mesh
    Vec3 centre;         // [m]
    double jacobian = 0; // the least scaled one of its parts
};

/// What the report needs of the undivided mesh and the plan, which the division uses up.
struct MpsFigures {
    Label cells = 0;
    double volume = 0; // [m^3]
    SubdivisionCounts demanded;
    SubdivisionCounts planned;
    std::vector<InvertedCell> inverted; // by Jacobian, the worst first
    std::vector<Label> invertedParts;   // cells of the divided mesh, ascending
};

/// Cost: linear.
MpsFigures figuresOf(const PolyMesh& mesh, const SubdivisionPlan& plan);

/// Throws InputError for a mesh that breaks PolyMesh's laws or has cells without volume, after
/// writing those to sets; the mesh stays as it is.
void refuseInvalid(ToolRun& tool, const PolyMesh& mesh);

/// Says what was done and puts the same into the report; writes the cells with an inverted part to
/// sets. Throws WorkError when the result has not the hexahedra and pyramids that theory demands.
/// Returns true when no part is inverted.
bool reportSplit(ToolRun& tool, const MpsFigures& figures, const PolyMesh& result);

} // namespace polymesh::tools
