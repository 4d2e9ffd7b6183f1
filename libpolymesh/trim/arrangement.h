// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/rows.h"
#include "libpolymesh/geometry/box.h"
#include "libpolymesh/surface/edges.h"
#include "libpolymesh/surface/triSurface.h"
#include "libpolymesh/trim/probe.h"

#include <array>
#include <cstdint>
#include <vector>

namespace polymesh {

/// The surface with what the trim needs of it. Closed and consistently oriented; the domain is on
/// the side away from the normals.
struct CuttingSurface {
    const TriSurface* surface = nullptr;
    SurfaceEdges edges;
    std::vector<Box> triangleBoxes;

    std::array<Vec3, 3> triangle(Label t) const {
        return {surface->corner(t, 0), surface->corner(t, 1), surface->corner(t, 2)};
    }
};

/// Where a mesh edge passes through a triangle of the moved surface.
struct EdgeCrossing {
    Label triangle = -1;
    std::int8_t sign = 0; // 1: into the domain when going from the edge's lower node
    /// What the point coincides with on the surface as given. Bit 0, 1: lower, higher node of the
    /// edge; bit 2 + i: side i of the triangle.
    std::uint8_t zeros = 0;
};

/// Where an edge of the moved surface passes through a facet of the mesh.
struct FacePierce {
    Label edge = -1; // of the surface
    Label facet = -1;
    std::int8_t sign = 0; // 1: along the facet's normal when going from the edge's start
    /// Bit 0, 1: start, end of the surface edge; bit 2 + i: edge i of the facet (the last bit
    /// stands for all further ones).
    std::uint32_t zeros = 0;
};

/// The line in which a facet and a triangle meet. Its ends are point labels (see Arrangement); the
/// domain is on the left of from -> to, seen against the facet's normal.
struct Segment {
    Label triangle = -1;
    Label from = -1;
    Label to = -1;
};

/// How the moved surface and the probed cells meet: the paper's hierarchy of information (2.3),
/// every entry found once and named by how it is made.
///
/// Points have labels in one sequence: local nodes, edge crossings, face pierces, surface points.
/// Laws: (1) in each facet, a triangle has no segment or one; (2) each crossing and each pierce
/// ends one segment of a facet and begins another.
struct Arrangement {
    Rows<EdgeCrossing> crossings;     // probe edge -> crossings from its lower node on
    std::vector<std::int8_t> winding; // local node -> winding number; 1 inside, 0 outside
    Rows<FacePierce> pierces;         // facet -> pierces
    Rows<Segment> segments;           // facet -> segments, by ascending `from`
    Rows<Label> surfacePierces;       // surface edge -> pierces (places in pierces.values)
    std::vector<Label> pierceRank;    // pierce -> place in its surface edge's row
    std::vector<Label> vertexCell;    // surface point -> local cell, -1: outside the mesh
    Label nodeCount = 0;

    Label crossingCount() const { return toLabel(crossings.values.size()); }

    Label pierceCount() const { return toLabel(pierces.values.size()); }

    Label firstCrossing() const { return nodeCount; }

    Label firstPierce() const { return nodeCount + crossingCount(); }

    Label firstVertex() const { return firstPierce() + pierceCount(); }

    bool isNode(Label point) const { return point < nodeCount; }

    bool isCrossing(Label point) const { return point >= nodeCount && point < firstPierce(); }

    bool isPierce(Label point) const { return point >= firstPierce() && point < firstVertex(); }

    const EdgeCrossing& crossing(Label point) const {
        return crossings.values[index(point - nodeCount)];
    }

    const FacePierce& pierce(Label point) const {
        return pierces.values[index(point - firstPierce())];
    }
};

/// 1D: crosses the probe's edges with the surface and orders the crossings along each edge, with
/// exact signs. Fills `crossings`. Cost: O(pairs whose boxes overlap).
void crossEdges(const Probe& probe, const CuttingSurface& cutter, Arrangement& arrangement);

/// 2D: finds where surface edges pierce facets, and the segments. Fills `pierces` and `segments`.
/// Requires crossings. Throws WorkError where a segment has not two ends (a bug, never the input).
void pierceFacets(const Probe& probe, const CuttingSurface& cutter, Arrangement& arrangement);

/// Orders the pierces along each surface edge, and finds the cell of each surface point by walking
/// from them. Fills `surfacePierces`, `pierceRank` and `vertexCell`.
void locateVertices(const PolyMesh& mesh,
                    const Probe& probe,
                    const CuttingSurface& cutter,
                    Arrangement& arrangement);

/// Where mesh and surface meet, and what meets there.
struct Intersection {
    const Probe& probe;
    const CuttingSurface& cutter;
    const Arrangement& arrangement;
};

} // namespace polymesh
