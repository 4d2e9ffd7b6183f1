// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/trim/loops.h"

#include <algorithm>

namespace polymesh {

namespace {

/// The point of the line a b in the plane through `on` with the given normal; inside the segment.
Vec3 onLine(const Vec3& a, const Vec3& b, const Vec3& on, const Vec3& normal) {
    const double da = dot(normal, a - on);
    const double db = dot(normal, b - on);
    const double t = da == db ? 0.5 : std::clamp(da / (da - db), 0.0, 1.0);
    // From the nearer end, so that a coordinate that both ends share stays as it is.
    return t <= 0.5 ? a + t * (b - a) : b + (1 - t) * (a - b);
}

Vec3 placeCrossing(const Probe& probe,
                   const CuttingSurface& cutter,
                   Label edge,
                   const EdgeCrossing& crossing) {
    const Vec3& a = probe.nodePoints[index(probe.edges[index(edge)][0])];
    const Vec3& b = probe.nodePoints[index(probe.edges[index(edge)][1])];
    if ((crossing.zeros & 1) != 0) return a;
    if ((crossing.zeros & 2) != 0) return b;
    const auto t = cutter.triangle(crossing.triangle);
    return onLine(a, b, t[0], cross(t[1] - t[0], t[2] - t[0]));
}

Vec3 placePierce(const Probe& probe, const CuttingSurface& cutter, const FacePierce& pierce) {
    const SurfaceEdge& edge = cutter.edges.edges[index(pierce.edge)];
    const Vec3& p = cutter.surface->points[index(edge.start)];
    const Vec3& q = cutter.surface->points[index(edge.end)];
    if ((pierce.zeros & 1) != 0) return p;
    if ((pierce.zeros & 2) != 0) return q;
    const auto nodes = probe.facetNodes[pierce.facet];
    const auto at = [&](std::size_t i) -> const Vec3& { return probe.nodePoints[index(nodes[i])]; };
    Vec3 normal;
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        normal += cross(at(i) - at(0), at(i + 1) - at(0));
    Vec3 place = onLine(p, q, at(0), normal);
    for (int axis = 0; axis < 3; ++axis)
        if (std::ranges::all_of(
                nodes, [&](Label n) { return probe.nodePoints[index(n)][axis] == at(0)[axis]; }))
            place[axis] = at(0)[axis];
    return place;
}

} // namespace

PointPositions
placePoints(const Probe& probe, const CuttingSurface& cutter, const Arrangement& arrangement) {
    PointPositions points(index(arrangement.firstVertex()) + cutter.surface->points.size());
    std::ranges::copy(probe.nodePoints, points.begin());
    std::ranges::copy(cutter.surface->points, points.begin() + arrangement.firstVertex());
    parallelFor(probe.edgeCount(), [&](Label e) {
        for (Label x = arrangement.crossings.offsets[index(e)];
             x < arrangement.crossings.offsets[index(e) + 1];
             ++x)
            points[index(arrangement.firstCrossing() + x)] =
                placeCrossing(probe, cutter, e, arrangement.crossings.values[index(x)]);
    });
    parallelFor(arrangement.pierceCount(), [&](Label x) {
        points[index(arrangement.firstPierce() + x)] =
            placePierce(probe, cutter, arrangement.pierces.values[index(x)]);
    });
    return points;
}

} // namespace polymesh
