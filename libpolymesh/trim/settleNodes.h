// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/adjustNodes.h"
#include "libpolymesh/trim/arrangement.h"
#include "libpolymesh/trim/loops.h"

#include <array>
#include <vector>

namespace polymesh {

/// The nodes that the probe holds, by their local labels.
std::vector<SettledNode> probedNodes(const Probe& probe, const std::vector<SettledNode>& settled);

/// Pairs of points that are one because a node is on the surface: what the surface makes of the
/// edges, facets and cells round a settled node within its radius, and that node.
/// Labels are those of the arrangement, nodes local. Cost: linear in edges, pierces, surface
/// points.
std::vector<std::array<Label, 2>> pointsAtNodes(const Probe& probe,
                                                const Arrangement& arrangement,
                                                const PointPositions& positions,
                                                const std::vector<SettledNode>& settled);

/// Puts settled nodes (local labels) where they belong: exactly there, or as near as doubles are.
void placeSettled(const std::vector<SettledNode>& settled,
                  PolyMesh& mesh,
                  Probe& probe,
                  PointPositions& positions);

} // namespace polymesh
