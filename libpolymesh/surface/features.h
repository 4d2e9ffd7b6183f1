// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/edges.h"
#include "libpolymesh/surface/triSurface.h"

#include <vector>

namespace polymesh {

/// The edges and points of a surface that a mesh should keep.
struct SurfaceFeatures {
    std::vector<char> isFeature; // 1 or 0, one per SurfaceEdge
    std::vector<char> isCorner;  // 1 or 0, one per point
};

/// Finds the sharp edges, the borders between regions, and their corners.
///
/// An edge is a feature when its triangles' normals differ by more than `featureAngle` [rad] or its
/// triangles belong to different regions. A triangle without area counts with the normal of the
/// triangle across its longest side. A point is a corner when it ends or joins feature edges (other
/// than two of them), or when its two feature edges turn by more than `featureAngle`; edges with
/// the same end points count once.
///
/// Cost: O(n) in parallel.
SurfaceFeatures
findFeatures(const TriSurface& surface, const SurfaceEdges& edges, double featureAngle);

/// True when the two triangles of the edge lie in one plane, exactly, and on opposite sides of the
/// edge. False when one has no area.
bool isExactlyFlat(const TriSurface& surface, const SurfaceEdge& edge);

} // namespace polymesh
