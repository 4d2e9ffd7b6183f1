// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/nearNodes.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/box.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/surface/triangleBins.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace polymesh {

namespace {

/// Shortest edge at each point [m].
std::vector<double> shortestEdges(const PolyMesh& mesh) {
    std::vector<double> shortest(mesh.points.size(), Box::inf);
    const auto shorten = [&](Label p, double length2) {
        const std::atomic_ref<double> known(shortest[index(p)]);
        double seen = known.load(std::memory_order_relaxed);
        while (length2 < seen &&
               !known.compare_exchange_weak(seen, length2, std::memory_order_relaxed)) {
        }
    };
    parallelFor(mesh.faceCount(), [&](Label f) {
        const auto face = mesh.faces[f];
        Label before = face.back();
        for (const Label p : face) {
            const double length2 = squaredNorm(mesh.points[index(p)] - mesh.points[index(before)]);
            shorten(p, length2); // and `before` in a face that runs the other way
            before = p;
        }
    });
    parallelFor(mesh.pointCount(),
                [&](Label p) { shortest[index(p)] = std::sqrt(shortest[index(p)]); });
    return shortest;
}

void mark(std::vector<std::uint8_t>& flags, Label p) {
    std::atomic_ref<std::uint8_t>(flags[index(p)]).store(1, std::memory_order_relaxed);
}

bool isNear(const TriangleBins& bins, const Vec3& low, const Vec3& high) {
    TriangleBins::Range range;
    range.add(bins.binOf(low));
    range.add(bins.binOf(high));
    return bins.isOccupied(range);
}

void restrictBoundary(const PolyMesh& mesh, std::vector<NearNode>& near) {
    std::vector<Label> nearOf(mesh.points.size(), -1);
    for (std::size_t i = 0; i < near.size(); ++i)
        nearOf[index(near[i].node)] = toLabel(i);
    for (Label f = mesh.internalFaceCount(); f < mesh.faceCount(); ++f) {
        const auto face = mesh.faces[f];
        if (std::ranges::all_of(face, [&](Label p) { return nearOf[index(p)] < 0; })) continue;
        const Vec3 area = faceGeometry(mesh.points, face).area;
        const double size = norm(area);
        const Vec3 normal = size > 0 ? area / size : Vec3{};
        for (const Label p : face)
            if (nearOf[index(p)] >= 0) near[index(nearOf[index(p)])].freedom.addPlane(normal);
    }
}

} // namespace

std::vector<NearNode>
findNearNodes(const PolyMesh& mesh, const TriSurface& surface, double reach, bool wholeFaces) {
    const std::vector<double> sizes = shortestEdges(mesh);
    const double mean =
        parallelSum(mesh.pointCount(), 0.0, [&](Label p) { return sizes[index(p)]; }) /
        static_cast<double>(std::max<std::size_t>(sizes.size(), 1));
    const TriangleBins bins(surface, mean);
    std::vector<std::uint8_t> flags(mesh.points.size(), 0);
    parallelFor(mesh.pointCount(), [&](Label p) {
        const double r = reach * sizes[index(p)];
        const Vec3& at = mesh.points[index(p)];
        if (isNear(bins, at - Vec3{r, r, r}, at + Vec3{r, r, r})) flags[index(p)] = 1;
    });
    if (wholeFaces)
        parallelFor(mesh.faceCount(), [&](Label f) {
            const auto face = mesh.faces[f];
            Box box;
            for (const Label p : face)
                box.add(mesh.points[index(p)]);
            if (!isNear(bins, box.min, box.max)) return;
            for (const Label p : face)
                mark(flags, p);
        });
    std::vector<NearNode> near;
    for (Label p = 0; p < mesh.pointCount(); ++p)
        if (flags[index(p)] != 0) near.push_back({p, sizes[index(p)], NodeFreedom()});
    restrictBoundary(mesh, near);
    return near;
}

} // namespace polymesh
