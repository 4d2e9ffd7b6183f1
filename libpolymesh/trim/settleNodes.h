// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/adjustNodes.h"
#include "libpolymesh/trim/arrangement.h"
#include "libpolymesh/trim/loops.h"

#include <array>
#include <vector>

namespace polymesh {

/// An arrangement and where its points are.
struct ArrangedPoints {
    const Arrangement& arrangement;
    const PointPositions& positions;
};

/// The nodes that the probe holds, by their local labels.
std::vector<SettledNode> probedNodes(const Probe& probe, const std::vector<SettledNode>& settled);

/// Pairs of points that are one because a node is on the surface: what the surface makes of the
/// edges, facets and cells round a settled node, and that node. Taken are crossings and pierces
/// within four times its depth (where edges to nodes that are not near the surface cross it) of
/// triangles whose planes pass it within its depth; pierces of feature edges that do so; and
/// surface points within its depth.
/// Labels are those of the arrangement, nodes local. Cost: linear in edges, pierces, surface
/// points.
std::vector<std::array<Label, 2>> pointsAtNodes(const Probe& probe,
                                                const CuttingSurface& cutter,
                                                const SurfaceFeatures& features,
                                                const ArrangedPoints& points,
                                                const std::vector<SettledNode>& settled);

/// Puts settled nodes (local labels) where they belong: exactly there, or as near as doubles are.
void placeSettled(const std::vector<SettledNode>& settled,
                  PolyMesh& mesh,
                  Probe& probe,
                  PointPositions& positions);

} // namespace polymesh
