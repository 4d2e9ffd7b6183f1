// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/edgeUses.h"
#include "libpolymesh/surface/triSurface.h"

#include <vector>

namespace polymesh {

/// Triangles connected across sides that exactly two of them share.
struct Components {
    Label count = 0;
    std::vector<Label> ofTriangle; // numbered by their first triangles
    std::vector<char> isAgainst;   // one per triangle: 1 when it runs against its component's first
    std::vector<char> isOrientable; // one per component
};

/// Requires: `uses` of this surface. O(n).
Components findComponents(const TriSurface& surface, const Rows<SurfaceEdgeUse>& uses);

} // namespace polymesh
