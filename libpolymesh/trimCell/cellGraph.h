// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trimCell/cellSites.h"

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

namespace polymesh {

/// What makes a point. Cells that share the point give it the same name.
struct PointName {
    enum class Kind : std::uint8_t {
        node,     // first: local node
        crossing, // of mesh edge `first` and triangle `second`
        pierce,   // of facet `first` and surface edge `second`
        vertex    // first: surface point
    };
    Kind kind = Kind::node;
    Label first = -1;
    Label second = -1;

    // NOLINTNEXTLINE(modernize-use-nullptr): what the compiler makes of it compares with 0
    auto operator<=>(const PointName&) const = default;
};

/// What a face of the trimmed cell lies on: a face of the mesh, a facet of it, or a triangle.
struct Carrier {
    Label face = -1;  // local; -1: on the surface
    Label facet = -1; // -1: the whole face
    Label triangle = -1;
};

/// An edge of the trimmed cell: the line in which its two carriers meet.
struct GraphEdge {
    enum class Kind : std::uint8_t {
        outline, // part of a mesh edge
        segment, // of a facet and a triangle
        surface  // part of a surface edge
    };
    Kind kind = Kind::outline;
    std::array<PointName, 2> points;
    /// Seen from outside, the face on the first one runs from points[0] to points[1], that on the
    /// second one back; of a segment this is not known.
    std::array<Label, 2> carriers{-1, -1};
    Label source = -1; // mesh edge, facet, or surface edge
};

/// The nodes and edges of a trimmed cell: L in the paper's equation 3.
struct CellGraph {
    std::vector<GraphEdge> edges;
    std::vector<Carrier> carriers;
};

/// Builds the graph of a cell from its sites. `isByFacets` tells for each facet of the sites
/// whether its face is taken facet by facet. Throws InputError where the surface intersects itself
/// so that a segment has not two ends.
CellGraph buildGraph(const CellInputs& inputs,
                     const CellSites& sites,
                     const std::vector<std::uint8_t>& isByFacets);

/// A place to name in messages: of the node, the edge or the vertex that makes the point.
Vec3 placeOf(const CellInputs& inputs, const PointName& point);

/// Throws InputError: surface or mesh overlap themselves near the point.
[[noreturn]] void refuseSurfaceAt(const CellInputs& inputs, const PointName& point);

} // namespace polymesh
