// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/vec3.h"

#include <functional>
#include <vector>

namespace polymesh {

/// A cell that might be divided.
struct RefineCell {
    Vec3 centre;       // mean of the corners [m]
    double radius = 0; // of the ball about the centre that holds the corners [m]
    double size = 0;   // longest edge [m]
    int level = 0;     // how often an initial cell was halved to get it
    Label initialCell = 0;
};

/// Says whether a cell is too large. "Near" means near the ball of the cell: what is far from that
/// is far from all that the cell may become, so a cell must be wanted when any of its children is.
/// Thread-safe.
using Criterion = std::function<bool(const RefineCell&)>;

/// Wants cells up to a distance from something to have a level at least.
struct Shell {
    double distance = 0; // [m]
    int level = 0;
};

/// Cells of the initial mesh that are to have a level.
Criterion cellCriterion(std::vector<Label> cells, int level);

} // namespace polymesh
