// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/check.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/base/parallelSort.h"
#include "libpolymesh/surface/coplanar.h"
#include "libpolymesh/surface/edgeUses.h"

#include <algorithm>
#include <numeric>

namespace polymesh {

namespace {

Vec3 centroid(const TriSurface& surface, Label t) {
    return (surface.corner(t, 0) + surface.corner(t, 1) + surface.corner(t, 2)) / 3;
}

void checkEdges(const TriSurface& surface, SurfaceDefects& defects) {
    const Rows<SurfaceEdgeUse> uses = collectEdgeUses(surface);
    for (Label lower = 0; lower < uses.size(); ++lower) {
        forEachEdge(uses[lower], [&](std::span<const SurfaceEdgeUse> edge) {
            const auto ascending =
                static_cast<std::size_t>(std::ranges::count_if(edge, &SurfaceEdgeUse::ascending));
            const Vec3 middle =
                0.5 * (surface.points[index(lower)] + surface.points[index(edge.front().upper)]);
            if (edge.size() % 2 == 1)
                defects.openEdges.add(middle);
            else if (2 * ascending != edge.size())
                defects.misorientedEdges.add(middle);
            if (edge.size() > 2) defects.nonManifoldEdges.add(middle);
        });
    }
}

void checkDuplicates(const TriSurface& surface, SurfaceDefects& defects) {
    std::vector<std::array<Label, 4>> keys(surface.triangles.size()); // sorted corners, triangle
    for (Label t = 0; t < surface.triangleCount(); ++t) {
        const auto& corners = surface.triangles[index(t)];
        keys[index(t)] = {corners[0], corners[1], corners[2], t};
        std::sort(keys[index(t)].begin(), keys[index(t)].begin() + 3);
    }
    parallelSort(keys);
    std::vector<Label> duplicates;
    for (std::size_t i = 1; i < keys.size(); ++i)
        if (std::equal(keys[i].begin(), keys[i].begin() + 3, keys[i - 1].begin()))
            duplicates.push_back(keys[i][3]);
    std::ranges::sort(duplicates);
    for (Label t : duplicates)
        defects.duplicateTriangles.add(centroid(surface, t));
}

void checkAreas(const TriSurface& surface, SurfaceDefects& defects) {
    std::vector<char> isFlat(surface.triangles.size());
    parallelFor(surface.triangleCount(), [&](Label t) {
        isFlat[index(t)] =
            areCollinear(surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)) ? 1 : 0;
    });
    for (Label t = 0; t < surface.triangleCount(); ++t)
        if (isFlat[index(t)] != 0) defects.zeroAreaTriangles.add(centroid(surface, t));
}

} // namespace

SurfaceDefects checkSurface(const TriSurface& surface) {
    SurfaceDefects defects;
    checkEdges(surface, defects);
    checkDuplicates(surface, defects);
    checkAreas(surface, defects);
    return defects;
}

} // namespace polymesh
