// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/farCells.h"

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/internalFaces.h"
#include "libpolymesh/trim/nodes.h"

#include <algorithm>

namespace polymesh {

namespace {

/// Regions of cells, each known by its lowest cell.
class Regions {
public:
    explicit Regions(Label cellCount) : lower_(freshList<Label>(index(cellCount))) {
        parallelFor(cellCount, [&](Label c) { lower_[index(c)] = c; });
    }

    void join(Label a, Label b) {
        a = lowest(a);
        b = lowest(b);
        if (a != b) lower_[index(std::max(a, b))] = std::min(a, b);
    }

    /// Lets every cell point to its lowest one straight away.
    void flatten() {
        for (Label& lower : lower_)
            lower = lower_[index(lower)]; // that one has been done
    }

    Label operator[](Label cell) const { return lower_[index(cell)]; }

private:
    Label lowest(Label cell) {
        while (lower_[index(cell)] != cell) {
            Label& lower = lower_[index(cell)];
            lower = lower_[index(lower)];
            cell = lower;
        }
        return cell;
    }

    std::vector<Label> lower_;
};

Regions joinFarCells(const PolyMesh& mesh, const Probe& probe) {
    Regions regions(mesh.cellCount);
    forInternalFaces(mesh, [&](Label f) {
        const Label a = mesh.owner[index(f)];
        const Label b = mesh.neighbour[index(f)];
        if (probe.localCell[index(a)] < 0 && probe.localCell[index(b)] < 0) regions.join(a, b);
    });
    regions.flatten();
    return regions;
}

/// A point of the lowest cell of each region, as (cell, point).
std::vector<std::pair<Label, Label>>
pointsOfRegions(const PolyMesh& mesh, const Probe& probe, const Regions& regions) {
    std::vector<std::uint8_t> isWanted = freshList<std::uint8_t>(index(mesh.cellCount));
    parallelFor(mesh.cellCount, [&](Label c) {
        isWanted[index(c)] = probe.localCell[index(c)] < 0 && regions[c] == c;
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
        if (regions[c] != c) winding[index(c)] = winding[index(regions[c])];
    });
    return winding;
}

} // namespace polymesh
