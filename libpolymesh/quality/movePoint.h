// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

namespace polymesh {

/// Moves a point: the faces get a new point with that place and rank, which is returned.
Label movePoint(MeshEditor& editor, Label p, const Vec3& position, PointRank rank);

/// True when a point may move along the edge to a neighbour: inside anywhere, on the surface along
/// edges of the surface, on a feature along feature edges; corners and fixed points stay.
bool maySlide(MeshEditor& editor, Label from, Label to);

/// An edge, and how far from it [m] a point may be that goes into it.
struct PinchEdge {
    Label a = -1;
    Label b = -1;
    double reach = 0;
};

/// True when the point is near the inner part of the edge, neither is fixed, and they are not
/// joined by an edge.
bool mayPinch(MeshEditor& editor, Label p, const PinchEdge& edge);

/// Puts a point into the edge from a to b, for all cells round both: the point goes onto the edge,
/// or the edge comes to the point when the point has the higher rank; what was between them goes.
/// False when cells would be torn; the caller then undoes.
bool pinchIntoEdge(MeshEditor& editor, Label p, Label a, Label b);

} // namespace polymesh
