// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/farCells.h"

#include "libpolymesh/base/disjointSets.h"
#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/internalFaces.h"
#include "libpolymesh/trim/nodes.h"

#include <algorithm>
#include <utility>

namespace polymesh {

namespace {

/// For each cell the lowest one of its region: far cells that hang together by faces.
using Regions = std::vector<Label>;

Regions joinFarCells(const PolyMesh& mesh, const Probe& probe) {
    DisjointSets regions(mesh.cellCount);
    forInternalFaces(mesh, [&](Label f) {
        const Label a = mesh.owner[index(f)];
        const Label b = mesh.neighbour[index(f)];
        if (probe.localCell[index(a)] < 0 && probe.localCell[index(b)] < 0) regions.join(a, b);
    });
    return std::move(regions).lowestOfEach();
}

/// A point of the lowest cell of each region, as (cell, point).
std::vector<std::pair<Label, Label>>
pointsOfRegions(const PolyMesh& mesh, const Probe& probe, const Regions& regions) {
    std::vector<std::uint8_t> isWanted = freshList<std::uint8_t>(index(mesh.cellCount));
    parallelFor(mesh.cellCount, [&](Label c) {
        isWanted[index(c)] = probe.localCell[index(c)] < 0 && regions[index(c)] == c;
    });
    auto left = std::ranges::count(isWanted, std::uint8_t{1});
    std::vector<std::pair<Label, Label>> points;
    const auto visit = [&](Label cell, Label f) {
        if (isWanted[index(cell)] == 0) return;
        isWanted[index(cell)] = 0;
        --left;
        points.emplace_back(cell, mesh.faces[f][0]);
    };
    for (Label f = 0; f < mesh.faceCount() && left > 0; ++f) {
        visit(mesh.owner[index(f)], f);
        if (mesh.isInternal(f)) visit(mesh.neighbour[index(f)], f);
    }
    return points;
}

} // namespace

std::vector<std::int8_t>
windFarCells(const PolyMesh& mesh, const Probe& probe, const CuttingSurface& cutter, int shift) {
    const Regions regions = joinFarCells(mesh, probe);
    const auto points = pointsOfRegions(mesh, probe, regions);
    std::vector<std::int8_t> winding = freshList<std::int8_t>(index(mesh.cellCount));
    parallelBlocks(toLabel(points.size()), 1, [&](Label i, Label, Label) {
        const auto& [cell, point] = points[index(i)];
        winding[index(cell)] =
            static_cast<std::int8_t>(windingNumber(cutter, mesh.points[index(point)]) + shift);
    });
    parallelFor(mesh.cellCount, [&](Label c) {
        const Label lowest = regions[index(c)];
        if (lowest != c) winding[index(c)] = winding[index(lowest)];
    });
    return winding;
}

} // namespace polymesh
