// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"

#include <algorithm>
#include <string>
#include <vector>

namespace polymesh {

/// Cells of a mesh that are described together, up to the first cell of the next part.
struct MeshPart {
    Label firstCell = 0;
    std::string where; // "file:line", for messages
};

/// The part of a cell; the parts are in the order of their cells, the first begins with cell 0.
inline Label partOf(const std::vector<MeshPart>& parts, Label cell) {
    const auto after = std::ranges::upper_bound(parts, cell, {}, &MeshPart::firstCell);
    return toLabel(static_cast<std::size_t>(after - parts.begin())) - 1;
}

} // namespace polymesh
