// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/features.h"
#include "libpolymesh/trim/adjustNodes.h"
#include "libpolymesh/trim/arrangement.h"
#include "libpolymesh/trim/editPart.h"
#include "libpolymesh/trim/loops.h"
#include "libpolymesh/trim/pieces.h"
#include "libpolymesh/trim/trim.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace polymesh {

/// The surface that cuts and its features.
struct FeaturedSurface {
    const CuttingSurface& cutter;
    const SurfaceFeatures& features;
};

/// What is left of the mesh's faces, and the parts of triangles in its cells, all exact.
struct ExactFaces {
    FaceLoops loops;
    CellPieces pieces;
};

/// How the surface cuts the mesh, exactly; what is kept of that is decided afterwards.
struct MeshCut {
    Probe probe;
    std::vector<SettledNode> settled;     // local nodes on the surface
    std::vector<std::int8_t> cellWinding; // of cells outside the probe
    Arrangement arrangement;
    PointPositions positions;
    std::optional<ExactFaces> faces{}; // where findCut has found them too
};

/// The pieces of the cells as the surface cuts them, before clean-up.
struct Pieces {
    EditPart part;
    Label holedFaces = 0;
    Label remadeCells = 0; // in places of their own
    bool mayTouch = false; // the surface may lie on faces of the mesh
    bool mayPinch = false; // the surface has edges of more than two triangles
};

/// Finds where the surface cuts the mesh; cells that are far outside go from the mesh.
MeshCut findCut(PolyMesh& mesh,
                const FeaturedSurface& surface,
                const AdjustedNodes& adjusted,
                const TrimOptions& options);

/// Makes the cells on the side to keep, with as much of the surface as the deviation asks for; in
/// places of their own, of which the last that holds a cell counts. May be called again with other
/// places as long as no node is settled (these go to their final place here, in the mesh too).
/// Throws InputError where the surface intersects itself so that cells do not close.
Pieces makePieces(PolyMesh& mesh,
                  MeshCut& cut,
                  const FeaturedSurface& surface,
                  const TrimOptions& options,
                  std::span<const FidelityPlace> places);

} // namespace polymesh
