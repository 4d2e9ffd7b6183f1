// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/blocks.h"

#include <array>
#include <string>
#include <vector>

namespace polymesh {

/// A quadrilateral of a sheet by its points, going round it either way.
struct SheetQuad {
    std::array<Label, 4> points{};
    std::string where; // for messages: "file:line", or the face of a patch
};

/// A sheet of quadrilaterals, which need not be plane, and how it is drawn out into blocks.
struct ExtrusionSpec {
    std::vector<Vec3> points; // [m]
    std::vector<SheetQuad> quads;
    Vec3 vector;                      // from the sheet to its other end [m]
    std::array<Label, 2> cells{1, 1}; // of each quadrilateral: from its first point to the second,
                                      // and from the second to the third
    Label layers = 1;
    Grading grading; // along the vector
};

/// One block for each quadrilateral. Patches: start (the sheet), end, side.
/// Requires: point labels in range, a vector with a length, cells and layers at least 1.
/// Throws InputError, which begins with the place of a quadrilateral: it repeats a point, is
/// concave or stands along the vector; or the sheet folds back over itself along one of its edges.
BlockMeshDescription extrudedBlocks(const ExtrusionSpec& extrusion);

} // namespace polymesh
