// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/cuttingLoop.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/meshEditor.h"
#include "libpolymesh/quality/workBudget.h"

#include <span>
#include <vector>

namespace polymesh {

/// An edge of a cell at which it is concave: the angle inside, between the faces f and g, is larger
/// than 180 degrees by `excess` [rad].
struct ReflexEdge {
    Label low = -1;
    Label high = -1;
    Label f = -1;
    Label g = -1;
    double excess = 0;
};

/// The edges of a cell with an excess over `tolerance` [rad], the largest excess first.
std::vector<ReflexEdge> reflexEdges(MeshEditor& editor, Label cell, double tolerance);

/// The excess over all reflex edges of a cell [rad].
double totalExcess(MeshEditor& editor, Label cell, double tolerance);

/// A cut that can be made, and what it would leave.
struct Cut {
    CellCut loops;
    Badness after;     // of the region round the cell and the new cell
    double excess = 0; // [rad] sum over the reflex edges of both parts, if asked for
};

/// What cuts are for.
struct CutAim {
    double tolerance = 0;     // [rad] an edge with a larger excess is concave
    bool wantsConvex = false; // cuts are judged by the concavity that they leave too, and planes
                              // are followed exactly as well
};

/// All cuts that planes at the reflex edges of a cell allow: on along either face of the edge and
/// half-way between; where a hole goes through the cell, further loops in the plane cut it open.
/// `region` holds the cell and its neighbours. When only soundness is asked for,
/// the search ends with a cut that leaves nothing to be desired in both parts.
std::vector<Cut> possibleCuts(MeshEditor& editor,
                              Label cell,
                              std::span<const Label> region,
                              const CutAim& aim,
                              WorkBudget& budget);

/// Cuts in the planes that halve the angles at all edges of a cell, concave or not.
std::vector<Cut>
halvingCuts(MeshEditor& editor, Label cell, std::span<const Label> region, WorkBudget& budget);

} // namespace polymesh
