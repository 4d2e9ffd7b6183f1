// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/box.h"
#include "libpolymesh/trim/trim.h"
#include "tools/toolMain.h"

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

/// Ends the running stage; says what the trim did and how well the mesh meets the surface, and puts
/// the same into the report. Cost: linear in the boundary faces and features.
/// How many nodes were moved; nothing for Adjust::none.
void reportAdjust(ToolRun& tool, Adjust how, const AdjustCounts& counts);

void reportTrim(ToolRun& tool, const TrimRun& run);

} // namespace polymesh::tools
