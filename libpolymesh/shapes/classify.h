// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/rows.h"
#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/shapes/catalogue.h"

#include <string>
#include <utility>
#include <vector>

namespace polymesh {

/// The shape of a cell, if the catalogue has it.
struct CellShape {
    static constexpr ShapeId unrecognised = 0xff;

    ShapeId shape = unrecognised;
    /// The base of the shape; sammTrim3 where the catalogue, which has one entry for both, says
    /// sammTrim1, but the cell's faces lie as in the other.
    BaseShape base = BaseShape::tetrahedron;

    bool isRecognised() const { return shape != unrecognised; }

    // NOLINTNEXTLINE(modernize-use-nullptr): what the compiler makes of it compares with 0
    auto operator<=>(const CellShape&) const = default;
};

/// The name of a recognised shape: the catalogue's, or sammTrim3.
std::string nameOf(const CellShape& shape);

/// The shape of each cell, from the faces of each cell (mesh/topology.h).
/// Cost: some 100 ns a cell, in parallel; no memory but the result.
std::vector<CellShape> classifyCells(const PolyMesh& mesh, const Rows<Label>& cellFaces);

/// How many cells have each shape that occurs, in the order of the catalogue.
struct ShapeCensus {
    std::vector<std::pair<CellShape, Label>> counts;
    Label unrecognised = 0;
};

ShapeCensus census(const std::vector<CellShape>& shapes);

} // namespace polymesh
