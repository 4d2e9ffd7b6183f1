// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/base/rows.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <array>
#include <cstdint>
#include <map>
#include <string_view>

namespace polymesh {

/// The shapes that OpenFOAM's checkMesh counts, in the order in which it prints them.
enum class StandardShape : std::uint8_t {
    hexahedron,
    prism,
    wedge,
    pyramid,
    tetWedge,
    tetrahedron,
    polyhedron
};

inline constexpr std::size_t standardShapeCount = 7;

/// Plural names: hexahedra, prisms, wedges, pyramids, tetWedges, tetrahedra, polyhedra.
std::string_view pluralName(StandardShape shape);

/// The shape of a cell as OpenFOAM sees it: by the sizes of its faces, for prisms and wedges also
/// by its number of points and by which faces meet. O(face corners of the cell).
StandardShape standardShape(const PolyMesh& mesh, Label cell, const Rows<Label>& cellFaces);

/// How many cells have each shape, and how many polyhedra each number of faces.
struct ShapeCounts {
    std::array<Label, standardShapeCount> cells{};
    std::map<Label, Label> polyhedraByFaceCount;

    Label operator[](StandardShape shape) const { return cells[static_cast<std::size_t>(shape)]; }
};

ShapeCounts countShapes(const PolyMesh& mesh, const Rows<Label>& cellFaces);

} // namespace polymesh
