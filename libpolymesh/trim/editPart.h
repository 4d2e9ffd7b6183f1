// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/editMesh.h"
#include "libpolymesh/surface/features.h"
#include "libpolymesh/trim/adjustNodes.h"
#include "libpolymesh/trim/trimmedCells.h"

#include <cstdint>
#include <vector>

namespace polymesh {

/// What a mesh cell has become.
enum class CellState : std::uint8_t {
    outside, // gone
    inside,  // as it was, and not part of the EditMesh unless as a frozen cell
    edited   // its pieces are cells of the EditMesh
};

/// The cut cells and the untouched ones round them, ready for clean-up.
struct EditPart {
    EditMesh mesh;
    std::vector<Label> meshPoint;      // edit point -> point of the initial mesh, or -1
    std::vector<Label> representative; // edit point -> the one that it coincides with
    std::vector<CellState> states;     // per mesh cell
    Label cutCellCount = 0;            // pieces of cells that the surface cuts
};

/// Inputs of buildEditPart that belong together.
struct TrimResult {
    const PolyMesh& mesh;
    const Probe& probe;
    const CuttingSurface& cutter;
    const Arrangement& arrangement;
    const PointPositions& positions;
    const FaceLoops& loops;
    const BoundaryPolygons& boundary;
    const TrimmedCells& cells;
    const std::vector<Label>& touchedRegions;    // see touching.h
    const std::vector<std::int8_t>& cellWinding; // of cells outside the probe
    const std::vector<double>& cellSizes;        // of probed cells
    const std::vector<SettledNode>& settled;     // local nodes on the surface
    double minEdge = 0;                          // edges may be collapsed below this, times size
};

/// Gathers the pieces of the probed cells, the cells that share a face with one, and those round
/// points that may be collapsed, as an EditMesh; the cells next to those are frozen. Patches are
/// numbered as in the mesh, the regions of the surface follow. Cost: O(faces of the mesh), small
/// constant.
EditPart buildEditPart(const TrimResult& trim,
                       const SurfaceFeatures& features,
                       const std::vector<Label>& representative);

} // namespace polymesh
