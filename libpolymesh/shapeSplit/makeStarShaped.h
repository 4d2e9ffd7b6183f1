// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace polymesh {

/// How much may be tried.
struct CutEffort {
    int cuts = 6;               // for one cell
    std::size_t candidates = 6; // for one cut
    std::int64_t tries = 200;   // looks at planes for one cut
    bool alongRims = false;     // cuts off points, edges and faces where planes do not help
    bool mayFold = false;       // a point behind all faces is enough, though it does not see them
};

/// Cuts a cell of which no point sees all faces until each part is acceptable or has such a point.
/// Boundary faces that are not plane become triangles first, of the same volume; then cuts run
/// along planes through the edges at which it is concave, and faces that they cross are cut for the
/// cells beyond too. Returns the parts; none, and nothing is changed, when that does not lead
/// there.
std::vector<Label> makeStarShaped(MeshEditor& editor, Label cell, const CutEffort& effort);

} // namespace polymesh
