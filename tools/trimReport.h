// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/box.h"
#include "libpolymesh/mesh/valences.h"
#include "libpolymesh/surface/measure.h"
#include "libpolymesh/trim/trim.h"
#include "tools/toolMain.h"

#include <cstddef>
#include <vector>

namespace polymesh::tools {

/// What the report needs of the initial mesh, which the trim uses up.
struct InitialMesh {
    Box box;
    double volume = 0; // [m^3]
    std::size_t faceZones = 0;
    std::size_t pointZones = 0;
};

/// Cost: linear in the points and boundary faces.
InitialMesh describe(const PolyMesh& mesh);

/// A trim that is done: what went in and what came out.
struct TrimRun {
    const InitialMesh& initial;
    const TriSurface& surface;
    const TrimOptions& options;
    const Trimmed& trimmed;
    bool isSurfaceWithin; // the initial mesh's box, so that volume and area must agree
};

/// What is measured of mesh and surface for the report.
struct TrimFigures {
    ValenceCounts nodes;           // of the cells at the surface
    std::size_t cornersWithin = 0; // of the surface's features, in the initial mesh's box
    std::size_t cornersFound = 0;  // those that are points of the mesh, bit for bit
    SurfaceMeasure surface;
    double volume = 0;             // of the mesh [m^3]
    std::vector<double> patchArea; // of the surface's patches [m^2]
};

/// Measures a trim. Cost: linear in the faces and the surface.
TrimFigures measureTrim(const TrimRun& run);

/// Says how many nodes were moved; nothing for Adjust::none.
void reportAdjust(ToolRun& tool, Adjust how, const AdjustCounts& counts);

/// Ends the running stage; says what the trim did and how well the mesh meets the surface, and puts
/// the same into the report.
void reportTrim(ToolRun& tool, const TrimRun& run, const TrimFigures& figures);

} // namespace polymesh::tools
