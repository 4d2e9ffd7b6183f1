// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/shapeSplit/fillWithTetrahedra.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace polymesh {

/// What a split did.
struct ShapeSplitCounts {
    Label splitCells = 0;  // cells that were not acceptable
    Label newCells = 0;    // by which the mesh has grown
    Label newPoints = 0;   // by which it has grown
    Label splitFaces = 0;  // faces with more points than any shape has, which were cut
    Label unitedCells = 0; // cells that could only be split together with a neighbour
    Label cutCells = 0;    // cells that had to be cut before a point inside saw all faces
    Label filledCells = 0; // cells of which tetrahedra were made
    Label foldedCells = 0; // cells split round a point that does not see all of a warped face
    Label mended = 0;      // changes that mended pieces
    Label mends = 0;       // changes of pieces that checkMesh would have failed
    std::vector<Label> remaining; // cells that are still not acceptable, ascending
};

/// Which zones keep cells apart: cells of different zones, or with a face of a zone between them,
/// are never split together. The first ones of the mesh, so that sets may travel as zones after
/// them.
struct BindingZones {
    std::size_t cellZones = std::numeric_limits<std::size_t>::max();
    std::size_t faceZones = std::numeric_limits<std::size_t>::max();
};

/// What a split may use and has to mind.
struct ShapeSplitMeans {
    BindingZones binding;
    Tetrahedraliser tetrahedralise; // of cells that cannot be cut in few pieces; may be empty
};

/// Replaces every cell whose shape STAR-CD does not accept (shapes/recognise.h) by acceptable ones:
/// the pyramids on its faces round a point inside. Faces that other cells share stay, unless they
/// have more than six points, no point inside sees all faces, or checkMesh would fail the pieces;
/// then they are cut for both cells.
/// Laws: (1) the result is valid (mesh/validate.h) and every piece has a positive volume; (2) the
/// volume that the boundary bounds stays, up to rounding; (3) points never move; patches and zones
/// stay, parts belong to those of the whole; (4) cells that are acceptable stay as they are unless
/// a face of theirs was cut, they were split together with another, or pieces beside them would
/// fail checkMesh otherwise; (5) a cell keeps its label
/// for one of its pieces, the others follow after the last cell; `origins`, if given, gets for each
/// cell of the new mesh the cell that it is a piece of.
/// Requires: a valid mesh. Cost: linear in the mesh with a small constant; some 20 microseconds
/// for a cell to split, up to a second for one that has to be cut.
ShapeSplitCounts splitUnacceptableCells(PolyMesh& mesh,
                                        const ShapeSplitMeans& means = {},
                                        std::vector<Label>* origins = nullptr);

} // namespace polymesh
