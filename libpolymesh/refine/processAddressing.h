// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/refine/partition.h"
#include "libpolymesh/refine/processes.h"
#include "libpolymesh/refine/refinedFaces.h"

#include <vector>

namespace polymesh {

/// Where the parts of one process's mesh are in that of all, as OpenFOAM's decomposePar says it.
struct ProcessAddressing {
    std::vector<Label> points;
    std::vector<Label> faces; // from 1; negative when the face is turned there
    std::vector<Label> cells;
    std::vector<Label> patches; // -1: to another process
};

/// Adds a patch for each process that has neighbours of own cells, by rank, with the faces on both
/// sides in the order that they have in the mesh of all and each beginning at the same point; and
/// notes where the faces are there. `internal` holds the faces between cells, by own cells in
/// blocks; its inner faces are in the mesh already, and so are the other patches. Labels of cells
/// and points are those of the mesh of all.
void addProcessPatches(const std::vector<InternalFaces>& internal,
                       const std::vector<Label>& firstCells,
                       const Processes& processes,
                       PolyMesh& mesh,
                       ProcessAddressing& addressing);

/// Gives the cells and points of the mesh labels of their own, and notes which they have in the
/// mesh of all. Points are not set.
void useOwnLabels(Label firstCell, PolyMesh& mesh, ProcessAddressing& addressing);

} // namespace polymesh
