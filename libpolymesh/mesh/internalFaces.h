// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace polymesh {

/// Calls body(face) for every internal face, in parallel where it can: two calls at the same time
/// never have a cell in common, so that a body may change what belongs to its two cells. The order
/// depends on the mesh alone.
///
/// Internal faces are in the order of their owners, so that a block of cells finds the faces that
/// it owns at once; those whose neighbour belongs to another block come afterwards. In a mesh
/// without that order all faces come one after the other.
template<class Body>
void forInternalFaces(const PolyMesh& mesh, Body&& body) {
    const Label count = mesh.internalFaceCount();
    const Label disordered = parallelSum(std::max(count - 1, Label{0}), Label{0}, [&](Label f) {
        return mesh.owner[index(f)] > mesh.owner[index(f) + 1] ? Label{1} : Label{0};
    });
    if (disordered > 0) {
        for (Label f = 0; f < count; ++f)
            body(f);
        return;
    }
    constexpr Label blocks = 16;
    const auto owners = std::span(mesh.owner).first(index(count));
    const auto firstOf = [&](Label cell) {
        const auto found = std::ranges::lower_bound(owners, cell);
        return toLabel(static_cast<std::size_t>(found - owners.begin()));
    };
    std::array<std::vector<Label>, blocks> crossing;
    parallelBlocks(mesh.cellCount,
                   mesh.cellCount / blocks + 1,
                   [&](Label block, Label firstCell, Label lastCell) {
                       const Label last = firstOf(lastCell);
                       for (Label f = firstOf(firstCell); f < last; ++f) {
                           const Label other = mesh.neighbour[index(f)];
                           if (firstCell <= other && other < lastCell)
                               body(f);
                           else
                               crossing[index(block)].push_back(f);
                       }
                   });
    for (const std::vector<Label>& faces : crossing)
        for (const Label f : faces)
            body(f);
}

} // namespace polymesh
