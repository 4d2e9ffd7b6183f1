// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/arrangement.h"

#include <cstdint>
#include <vector>

namespace polymesh {

/// The parts of each probed face that lie in the domain, as polygons of points of the arrangement,
/// in the direction of the face. Every polygon is a disc: holes are cut open by two bridges.
struct FaceLoops {
    Rows<Label> polygons;       // point labels
    std::vector<Label> offsets; // local face -> its polygons: [offsets[f], offsets[f + 1])
    /// Per crossing and pierce (point label minus the node count): 1 where a face needs the point,
    /// whatever the simplification does.
    std::vector<std::uint8_t> isNeeded;
    Label holeCount = 0;
};

/// Position of a point of the arrangement [m].
using PointPositions = std::vector<Vec3>;

/// Positions of all points of the arrangement: on the mesh edge for crossings, in the facet's plane
/// and on the surface edge for pierces. Axis-aligned edges and facets keep their coordinate bit for
/// bit.
PointPositions
placePoints(const Probe& probe, const CuttingSurface& cutter, const Arrangement& arrangement);

/// 2D: walks "domain part of the outline, crossing, curve, crossing, ..." round every face, and the
/// closed curves inside it. Throws InputError where the walk does not close, which happens where
/// the surface intersects itself. Cost: O(points on cut faces).
FaceLoops
walkFaces(const Probe& probe, const Arrangement& arrangement, const PointPositions& positions);

} // namespace polymesh
