// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/rows.h"
#include "libpolymesh/geometry/box.h"
#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/surface/triSurface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace polymesh {

/// The cells of a mesh that the surface may touch, as the paper's probe of the surface (section
/// 2.3): numbered anew ("local"), with their edges, and with faces cut into convex planar facets.
///
/// A face whose points lie in one plane and form a convex polygon is one facet; any other is the
/// fan of triangles round the mean of its points (paper, 2.1), whose inner edges are edges too.
/// Laws: (1) local cells and faces are in ascending order of their labels in the mesh;
/// (2) facets keep the direction of their face; (3) each edge runs from its lower local node.
struct Probe {
    std::vector<Label> cells;     // local cell -> mesh cell
    std::vector<Label> localCell; // mesh cell -> local cell or -1
    Rows<Label> triangles;        // local cell -> triangles that may touch it, ascending
    Rows<Label> cellFaces;        // local cell -> local faces, ascending

    std::vector<Label> faces;                    // local face -> mesh face
    std::vector<std::array<Label, 2>> faceCells; // owner and neighbour as local cells, or -1
    Rows<Label> faceNodes;                       // local face -> local nodes, in the face's order
    std::vector<Label> faceEdges;                // beside faceNodes.values: edge to the next node

    std::vector<Label> facetOffsets; // local face -> its facets: [offsets[f], offsets[f + 1])
    std::vector<Label> facetFace;    // facet -> local face
    Rows<Label> facetNodes;          // facet -> local nodes
    std::vector<Label> facetEdges;   // beside facetNodes.values

    std::vector<Label> nodes;     // local node -> mesh point; fan centres follow the mesh points
    std::vector<Vec3> nodePoints; // local node, fan centres included
    std::vector<std::array<Label, 2>> edges; // local nodes
    std::vector<Label> edgeCell;             // one local cell round the edge
    std::vector<std::uint8_t> isFanEdge;     // inside a face

    Label cellCount() const { return toLabel(cells.size()); }

    Label faceCount() const { return toLabel(faces.size()); }

    Label facetCount() const { return toLabel(facetFace.size()); }

    Label edgeCount() const { return toLabel(edges.size()); }

    Label meshNodeCount() const { return toLabel(nodes.size()); }

    Label nodeCount() const { return toLabel(nodePoints.size()); }
};

/// Finds the cells that the surface may touch, their faces and nodes. `triangleBoxes` holds the
/// bounding box of each triangle. Conservative: a cell left out is not touched, however the surface
/// is moved by an infinitesimal. Cost: O(cells + triangles + pairs found).
Probe findProbe(const PolyMesh& mesh,
                const TriSurface& surface,
                const std::vector<Box>& triangleBoxes);

/// Adds the facets and edges of a probe, and the fan centres to its nodes. Needs no mesh: what is
/// far from the probe may be gone by then. Cost: O(probe).
void addFacets(const std::vector<Box>& triangleBoxes, Probe& probe);

} // namespace polymesh
