// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The steps of the trim up to any point, shared by the tests of its parts.

#include "libpolymesh/surface/triangleBoxes.h"
#include "libpolymesh/trim/arrangement.h"
#include "libpolymesh/trim/farCells.h"
#include "libpolymesh/trim/loops.h"
#include "libpolymesh/trim/nodes.h"
#include "tests/support/surfaces.h"

#include <utility>
#include <vector>

namespace polymesh::test {

/// Mesh and surface with all that is known of how they meet. Not to be moved: parts point to it.
struct Arranged {
    Arranged(PolyMesh initial, TriSurface part, bool keepsOutside = false)
        : mesh(std::move(initial)),
          surface(keepsOutside ? inverted(std::move(part)) : std::move(part)),
          cutter{&surface, pairEdges(surface), triangleBoxes(surface)},
          probe(findProbe(mesh, surface, cutter.triangleBoxes)) {
        const int shift = keepsOutside ? 1 : 0;
        cellWinding = windFarCells(mesh, probe, cutter, shift);
        addFacets(cutter.triangleBoxes, probe);
        crossEdges(probe, cutter, arrangement);
        windNodes(probe, cutter, shift, arrangement);
        checkFarCells(mesh, probe, cellWinding, arrangement);
        pierceFacets(probe, cutter, arrangement);
        locateVertices(mesh, probe, cutter, arrangement);
        positions = placePoints(probe, cutter, arrangement);
        loops = walkFaces(probe, arrangement, positions);
    }

    Arranged(const Arranged&) = delete;
    Arranged& operator=(const Arranged&) = delete;

    PolyMesh mesh;
    TriSurface surface;
    CuttingSurface cutter;
    Probe probe;
    Arrangement arrangement;
    std::vector<std::int8_t> cellWinding;
    PointPositions positions;
    FaceLoops loops;
};

} // namespace polymesh::test
