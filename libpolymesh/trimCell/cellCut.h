// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trimCell/cellGraph.h"

#include <vector>

namespace polymesh {

/// A step along the outline of what is left of a mesh face.
struct FaceStep {
    PointName point;
    /// The facet and the triangle that meet in the line to the next point; -1: a mesh edge.
    Label facet = -1;
    Label triangle = -1;

    bool operator==(const FaceStep&) const = default;
};

/// An outline of what is left of a mesh face, or of a facet where the face is taken by facets.
struct FaceLoop {
    Label face = -1;
    Label facet = -1;            // -1: of the whole face
    std::vector<FaceStep> steps; // in the direction of the face
};

/// A step along the outline of a triangle's part in the cell.
struct PieceStep {
    PointName point;
    Label surfaceEdge = -1; // along which it goes on to the next point; -1: on a facet
};

struct PieceLoop {
    Label triangle = -1;
    std::vector<PieceStep> steps; // in the direction of the triangle
};

/// One cell cut by the surface: what it knows of the mesh and the surface, and its faces. Points
/// have names; nothing in here depends on other cells.
struct CellCut {
    CellSites sites;
    std::vector<FaceLoop> faceLoops;
    std::vector<PieceLoop> pieces;
};

/// Cuts one cell with the surface (paper, section 2.2). See docs/cellTrim.md.
/// Throws InputError and WorkError as findSites, buildGraph and findLoops do.
CellCut cutOneCell(const CellInputs& inputs, Label cell);

} // namespace polymesh
