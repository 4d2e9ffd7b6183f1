// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/base/rows.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace polymesh {

/// The polyhedra that STAR-CD accepts: the four regular cells and the six trimmed ones, what one
/// plane (hexagonalPrism: two) leaves of a hexahedron. In the order in which a recogniser prefers
/// them: fewer points first, the regular ones before the trimmed.
enum class BaseShape : std::uint8_t {
    tetrahedron,
    pyramid,
    prism,
    hexahedron,
    sammTrim5,
    sammTrim1,
    sammTrim2,
    sammTrim3,
    sammTrim4,
    hexagonalPrism
};

inline constexpr std::size_t baseShapeCount = 10;
inline constexpr std::size_t maxShapePoints = 12;
inline constexpr std::size_t maxShapeFaces = 8;
inline constexpr std::size_t maxShapeFacePoints = 6;

/// Number of a vertex of a base shape, from 0.
using ShapeVertex = std::uint8_t;

/// A face of a base shape: its vertices, anticlockwise seen from outside.
using ShapeFace = std::span<const ShapeVertex>;

/// A base shape as OpenFOAM's cell models number its vertices and faces.
struct BaseShapeTable {
    std::string_view name;
    std::size_t pointCount = 0;
    std::span<const ShapeFace> faces;
    /// Faces that lie on opposite sides of the hexahedron that the shape was cut from.
    std::span<const std::array<std::uint8_t, 2>> oppositeFaces;
    /// Faces made by the cut, not by the hexahedron.
    std::span<const std::uint8_t> cutFaces;
};

/// Source: the cell models of OpenFOAM (etc/cellModels), which are those of pro-STAR.
const BaseShapeTable& tableOf(BaseShape shape);

std::array<BaseShape, baseShapeCount> allBaseShapes();

/// The faces, outward, of a base shape whose vertices are these points; points that are repeated
/// are edges that have collapsed: a face names each point once, and faces with fewer than three
/// points left are gone. Requires: one point for each vertex of the shape.
Rows<Label> collapsedFaces(BaseShape shape, std::span<const Label> points);

} // namespace polymesh
