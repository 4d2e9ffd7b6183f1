// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/meshEditor.h"

namespace polymesh {

/// What the boundary faces at an edge say about it.
struct EdgeKind {
    bool boundary = false; // it is an edge of the boundary
    bool feature = false;  // its two boundary faces are on two patches, or turn by 5 degrees
};

EdgeKind edgeKind(MeshEditor& editor, Label a, Label b);

/// True when the point `from` may be moved onto `to` along their edge: no fixed point moves,
/// corners and points of a feature edge move along feature edges, points of the surface in it.
bool mayCollapse(MeshEditor& editor, Label from, Label to);

/// Moves the point `from` onto `to`, along their edge; faces and cells that vanish go. False when a
/// cell would be pinched or torn; the caller then undoes. The cells round `from` are those changed.
bool collapseEdge(MeshEditor& editor, Label from, Label to);

/// Collapses the edge in the allowed direction that leaves the cells round it better, if they are
/// then no worse than before. Returns the point that went, or -1 when both directions were refused.
Label collapseBestWay(MeshEditor& editor, Label a, Label b);

/// Collapses edges shorter than minEdge times the size of the smallest cell round them, the
/// shortest first, unless that makes cells worse. Returns the number of edges collapsed. Cost:
/// linear, small constant for edges that are long enough.
Label collapseShortEdges(MeshEditor& editor, double minEdge);

} // namespace polymesh
