// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"
#include "libpolymesh/trim/adjustOptions.h"

namespace polymesh {

/// Where a node of the mesh should go.
struct NodeMove {
    Label node = -1;
    AdjustTarget target = AdjustTarget::face;
    Vec3 place;      // [m]
    Vec3 inward;     // unit vector into the domain; zero where there is none, or no way to go
    double size = 0; // shortest edge at the node [m]
    double way = 0;  // how far it moves, fraction of size
};

} // namespace polymesh
