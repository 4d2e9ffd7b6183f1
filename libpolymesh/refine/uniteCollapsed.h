// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/refine/collapsedEdges.h"
#include "libpolymesh/refine/pointTable.h"
#include "libpolymesh/refine/refine.h"

namespace polymesh {

/// Makes points of a refined mesh one that coincide because sides have collapsed, and leaves out
/// boundary faces that have no area then. The other points keep their order.
/// Throws WorkError when a face between two cells has no area: by the construction none has.
/// Cost: linear in the mesh, n log n in the points of collapsed.trees().
void uniteCollapsed(const CollapsedEdges& collapsed, const PointTable& table, RefinedMesh& refined);

} // namespace polymesh
