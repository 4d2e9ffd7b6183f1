// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/edges.h"
#include "libpolymesh/surface/features.h"

#include <vector>

namespace polymesh {

/// Edges with at least this sharpness are features.
constexpr double featureSharpness = 3.2;

/// Edges with more than this sharpness part two regions.
constexpr double borderSharpness = 7;

/// How much each surface edge is worth keeping: the angle between the normals of its triangles
/// [rad]; more than pi for features; -1 where the four points lie
/// exactly in one plane, and on the longest side of a triangle without area, which thus goes with
/// its neighbour there.
std::vector<double> edgeSharpness(const TriSurface& surface,
                                  const SurfaceEdges& edges,
                                  const SurfaceFeatures& features);

} // namespace polymesh
