// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"

#include <array>
#include <vector>

namespace polymesh {

/// How often a defect occurs, and the place of the first [m] (the origin when it does not).
struct Finding {
    Label count = 0;
    Vec3 first;

    void add(const Vec3& place) {
        if (count++ == 0) first = place;
    }
};

/// What is wrong, or unusual, with a surface. Edges are located by their middle, triangles by their
/// centroid.
struct SurfaceDefects {
    Finding openEdges;          // used by an odd number of triangles: there is a gap
    Finding misorientedEdges;   // used by an even number, but not equally often both ways
    Finding nonManifoldEdges;   // used by more than two triangles; not wrong in itself
    Finding duplicateTriangles; // triangles with the points of an earlier one, in any order
    Finding zeroAreaTriangles;  // with collinear points; harmless, often needed to close a surface

    /// True when the surface bounds something: pairEdges will take it.
    bool isClosed() const { return openEdges.count == 0 && misorientedEdges.count == 0; }
};

/// Looks for all of these; O(n log n) in the number of triangles at a point.
SurfaceDefects checkSurface(const TriSurface& surface);

/// Two triangles that meet elsewhere than in a corner or side that they share.
struct SelfIntersections {
    Label count = 0;                         // of pairs
    std::vector<std::array<Label, 2>> first; // some pairs, in ascending order
};

/// Finds the pairs of triangles that intersect, exactly; lists at most `most` of them. Triangles
/// without area are passed over. Cost: O(n log n) for ordinary surfaces, in parallel; 0.25 M
/// triangles in under a second.
SelfIntersections findSelfIntersections(const TriSurface& surface, Label most);

} // namespace polymesh
