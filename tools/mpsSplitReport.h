// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/keepHexahedra.h"
#include "libpolymesh/mps/makeDivisible.h"
#include "libpolymesh/mps/projectBoundary.h"
#include "libpolymesh/mps/relaxPoints.h"
#include "tools/toolMain.h"

#include <vector>

namespace polymesh::tools {

/// A cell that can not be divided without an inverted part.
struct InvertedCell {
    Label cell = -1;     // of the undivided mesh
    Vec3 centre;         // [m]
    double jacobian = 0; // the least scaled one of its parts
};

/// The mesh as it was read.
struct UndividedMesh {
    Label cells = 0;
    double volume = 0; // [m^3]
};

/// What `-only polyhedra` left alone and put between.
struct PartFigures {
    bool isPart = false;
    Label whole = 0; // hexahedra
    Label layer = 0; // hexahedra that became cones
    Label pyramids = 0;
    Label tetrahedra = 0;
};

/// What the report needs of the mesh and the plan, which the division uses up.
struct MpsFigures {
    UndividedMesh undivided;
    DivisibleCounts counts;
    SubdivisionCounts demanded;
    SubdivisionCounts planned;
    std::vector<InvertedCell> inverted; // by Jacobian, the worst first
    std::vector<Label> invertedParts;   // cells of the divided mesh, ascending
    PartFigures part;
    RelaxCounts relaxed;
};

/// Cost: linear.
UndividedMesh describe(const PolyMesh& mesh);

/// Cost: linear.
MpsFigures figuresOf(const UndividedMesh& undivided, const Divisible& divisible);

/// Takes out of the figures what is not divided, and counts the layer. Cost: linear.
void takeOnlyDivided(const Divisible& divisible,
                     const std::vector<Fate>& fates,
                     const PartlyDivided& partly,
                     MpsFigures& figures);

/// Throws WorkError unless the mesh is valid; inverted parts that are known of are let through.
void requireConformal(const PolyMesh& result, const MpsFigures& figures);

/// Throws InputError for a mesh that breaks PolyMesh's laws or has cells without volume, after
/// writing those to sets; the mesh stays as it is.
void refuseInvalid(ToolRun& tool, const PolyMesh& mesh);

void reportProjection(ToolRun& tool, const ProjectionCounts& counts);

/// Says what was done and puts the same into the report; writes the cells with an inverted part to
/// sets. Throws WorkError when the result has not the hexahedra and pyramids that theory demands.
/// Returns true when no part is inverted.
bool reportSplit(ToolRun& tool, const MpsFigures& figures, const PolyMesh& result);

} // namespace polymesh::tools
