// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"

#include <array>
#include <vector>

namespace polymesh {

/// Two triangles at an edge, or one where the surface ends (second -1).
struct TriangleEdge {
    std::array<Label, 2> points{};
    std::array<Label, 2> triangles{-1, -1};
    double angle = 0; // between the normals [rad]
};

/// All edges of a surface; of more than two triangles at an edge the pairs that follow each other.
std::vector<TriangleEdge> triangleEdges(const TriSurface& surface);

/// The largest curvature of each triangle [1/m], as the surface bends at its edges and at those of
/// its neighbours; edges that bend by more than `featureAngle` [rad] are sharp and do not count.
/// Cost: linear.
/// Source: Cohen-Steiner and Morvan (2003), Restricted Delaunay triangulations and normal cycle.
std::vector<double> largestCurvatures(const TriSurface& surface, double featureAngle);

} // namespace polymesh
