// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/valences.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace polymesh {

namespace {

/// A node of a cell, once for each of its faces there: as many as edges.
struct CellNode {
    Label cell = 0;
    Label point = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr): what the compiler makes of it
    auto operator<=>(const CellNode&) const = default;
};

} // namespace

ValenceCounts countValences(const PolyMesh& mesh, Label first) {
    std::vector<std::uint8_t> isCounted(index(mesh.cellCount), 0);
    for (Label f = std::max(first, mesh.internalFaceCount()); f < mesh.faceCount(); ++f)
        isCounted[index(mesh.owner[index(f)])] = 1;
    std::vector<CellNode> nodes;
    const auto add = [&](Label cell, Label f) {
        if (isCounted[index(cell)] == 0) return;
        for (const Label p : mesh.faces[f])
            nodes.push_back({cell, p});
    };
    for (Label f = 0; f < mesh.faceCount(); ++f) {
        add(mesh.owner[index(f)], f);
        if (mesh.isInternal(f)) add(mesh.neighbour[index(f)], f);
    }
    std::ranges::sort(nodes);
    ValenceCounts counts;
    for (std::size_t i = 0; i < nodes.size();) {
        std::size_t end = i + 1;
        while (end < nodes.size() && nodes[end] == nodes[i])
            ++end;
        ++(end - i == 2 ? counts.bends : end - i == 3 ? counts.trivalent : counts.more);
        i = end;
    }
    return counts;
}

} // namespace polymesh
