// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trimCell/sidedness.h"

#include <vector>

namespace polymesh {

/// A facet of one cell.
struct CellFacet {
    Label facet = -1;      // of the probe
    Label face = -1;       // local face
    bool isTurned = false; // its normal points into the cell
};

/// An edge of one cell between two of its facets (places in CellSites::facets), of which `forward`
/// runs from the edge's lower node when seen from outside.
struct CellEdge {
    Label edge = -1; // of the probe
    Label forward = -1;
    Label backward = -1;
};

struct NodeWinding {
    Label node = -1;
    int winding = 0;

    bool operator==(const NodeWinding&) const = default;
};

/// Where one cell and the surface meet: all that the cell's part of the intersection is made of.
/// Found from the cell's own faces and the triangles near it, and from nothing else.
struct CellSites {
    Label cell = -1; // local
    std::vector<CellFacet> facets;
    std::vector<CellEdge> edges;     // ascending
    std::vector<NodeWinding> nodes;  // ascending; their sides of the surface
    std::vector<Label> triangles;    // near the cell, ascending
    std::vector<Label> surfaceEdges; // theirs, ascending
    std::vector<Label> vertices;     // surface points in the cell, ascending
    Rows<EdgeCrossing> crossings;    // beside edges: in order from the lower node
    Rows<FacePierce> pierces;        // beside facets: by ascending surface edge
};

/// What all cells read.
struct CellInputs {
    const Probe& probe;
    const SearchedSurface& surface;
    int shift; // added to winding numbers: 1 for a surface turned inside out
};

/// Finds the sites of a cell. Throws WorkError where the cell is not closed or overlaps itself, and
/// where the sides of two nodes contradict the crossings between them.
/// Cost: O((facets + edges) x triangles near the cell).
CellSites findSites(const CellInputs& inputs, Label cell);

} // namespace polymesh
