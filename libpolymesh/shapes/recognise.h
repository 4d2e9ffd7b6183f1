// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/shapes/catalogue.h"

#include <optional>
#include <span>
#include <vector>

namespace polymesh {

/// A cell as a base shape of STAR-CD.
/// Laws: (1) collapsedFaces(base, vertices()) are the faces of the cell, outward: the base shape is
/// right-handed; (2) points that follow each other along an edge of the base are equal where that
/// edge has collapsed.
struct Recognition {
    ShapeId shape = 0; // in the catalogue
    BaseShape base = BaseShape::tetrahedron;
    std::array<Label, maxShapePoints> points{}; // point of each vertex of the base

    std::span<const Label> vertices() const {
        return std::span(points).first(tableOf(base).pointCount);
    }
};

/// The face graph of a cell, from the faces that a mesh gives it; none when it cannot be in the
/// catalogue: too large, open, or not a ball.
std::optional<FaceGraph>
faceGraphOf(const PolyMesh& mesh, std::span<const Label> cellFaces, Label cell);

/// Recognises a face graph: what `close` accepted. None when no acceptable shape has it.
/// Where several bases have it, the first in their order is taken; where a shape is symmetrical,
/// any of the equivalent orders of vertices. sammTrim1 and sammTrim3 have one graph, and it comes
/// out as sammTrim1: fitToParent (parentFit.h) tells them apart.
/// Cost: some 100 ns: one walk over the graph and one look into a table.
std::optional<Recognition> recognise(const FaceGraph& graph);

/// The same for a cell of a mesh with the faces `cellFaces` (a row of mesh/topology.h).
std::optional<Recognition>
recognise(const PolyMesh& mesh, std::span<const Label> cellFaces, Label cell);

/// The same for faces given as loops of points, outward.
std::optional<Recognition> recognise(const Rows<Label>& outwardFaces);

} // namespace polymesh
