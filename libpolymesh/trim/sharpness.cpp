// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/sharpness.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/surface/coplanar.h"

#include <algorithm>
#include <cmath>

namespace polymesh {

namespace {

constexpr double flat = -1;
constexpr double border = borderSharpness + 1;

/// The longest side of a triangle without area; -1 for one with an area.
int foldedSide(const TriSurface& surface, Label t) {
    const Vec3& a = surface.corner(t, 0);
    const Vec3& b = surface.corner(t, 1);
    const Vec3& c = surface.corner(t, 2);
    if (!areCollinear(a, b, c)) return -1;
    const double ab = squaredNorm(b - a);
    const double bc = squaredNorm(c - b);
    const double ca = squaredNorm(a - c);
    if (ab >= bc && ab >= ca) return 0;
    return bc >= ca ? 1 : 2;
}

/// The triangle whose normal stands for t's: t, or where it has no area the first one with an area
/// that is reached over longest sides.
Label normalHolder(const std::vector<int>& folded, const SurfaceEdges& edges, Label t) {
    for (int steps = 0; steps < 64 && folded[index(t)] >= 0; ++steps) {
        const auto side = static_cast<std::size_t>(folded[index(t)]);
        const SurfaceEdge& edge = edges.edges[index(edges.ofTriangle[index(t)][side])];
        t = edge.left == t ? edge.right : edge.left;
    }
    return t;
}

Vec3 normal(const TriSurface& surface, Label t) {
    return cross(surface.corner(t, 1) - surface.corner(t, 0),
                 surface.corner(t, 2) - surface.corner(t, 0));
}

} // namespace

std::vector<double> edgeSharpness(const TriSurface& surface,
                                  const SurfaceEdges& edges,
                                  const SurfaceFeatures& features) {
    std::vector<int> folded(surface.triangles.size());
    parallelFor(surface.triangleCount(),
                [&](Label t) { folded[index(t)] = foldedSide(surface, t); });
    std::vector<double> sharpness(edges.edges.size());
    parallelFor(toLabel(edges.edges.size()), [&](Label e) {
        const SurfaceEdge& edge = edges.edges[index(e)];
        double& value = sharpness[index(e)];
        if (surface.region[index(edge.left)] != surface.region[index(edge.right)]) {
            value = border;
            return;
        }
        const auto isFoldedSide = [&](Label t) {
            const int side = folded[index(t)];
            return side >= 0 && edges.ofTriangle[index(t)][static_cast<std::size_t>(side)] == e;
        };
        if (isFoldedSide(edge.left) || isFoldedSide(edge.right) || isExactlyFlat(surface, edge)) {
            value = flat;
            return;
        }
        const Vec3 n = normal(surface, normalHolder(folded, edges, edge.left));
        const Vec3 m = normal(surface, normalHolder(folded, edges, edge.right));
        value = std::atan2(norm(cross(n, m)), dot(n, m));
        if (features.isFeature[index(e)] != 0) value += featureSharpness;
    });
    return sharpness;
}

} // namespace polymesh
