// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/surfaceCurvature.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/refine/nearTriangles.h"
#include "libpolymesh/surface/edgeUses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polymesh {
namespace {

/// A symmetric matrix: xx, yy, zz, xy, yz, zx.
using Tensor = std::array<double, 6>;

void addOuter(Tensor& sum, double weight, const Vec3& a) {
    const Tensor product{a.x * a.x, a.y * a.y, a.z * a.z, a.x * a.y, a.y * a.z, a.z * a.x};
    for (std::size_t i = 0; i < 6; ++i)
        sum[i] += weight * product[i];
}

/// The largest magnitude of an eigenvalue, by the trigonometric solution of the cubic.
double largestEigenvalue(const Tensor& m) {
    const double mean = (m[0] + m[1] + m[2]) / 3;
    const Vec3 diagonal{m[0] - mean, m[1] - mean, m[2] - mean};
    const Vec3 rest{m[3], m[4], m[5]};
    const double p2 = (squaredNorm(diagonal) + 2 * squaredNorm(rest)) / 6;
    if (!(p2 > 0)) return std::abs(mean);
    const double p = std::sqrt(p2);
    const Vec3 d = diagonal / p;
    const Vec3 o = rest / p;
    const double half = 0.5 * (d.x * (d.y * d.z - o.y * o.y) - o.x * (o.x * d.z - o.y * o.z) +
                               o.z * (o.x * o.y - d.y * o.z));
    const double angle = std::acos(std::clamp(half, -1.0, 1.0)) / 3;
    const double high = mean + 2 * p * std::cos(angle);
    const double low = mean + 2 * p * std::cos(angle + 2 * std::numbers::pi / 3);
    return std::max(std::abs(high), std::abs(low));
}

double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(norm(cross(a, b)), dot(a, b));
}

} // namespace

std::vector<TriangleEdge> triangleEdges(const TriSurface& surface) {
    std::vector<Vec3> normals(surface.triangles.size());
    parallelFor(surface.triangleCount(), [&](Label t) {
        normals[index(t)] =
            unitNormal({surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)});
    });
    std::vector<TriangleEdge> edges;
    const Rows<SurfaceEdgeUse> uses = collectEdgeUses(surface);
    for (Label p = 0; p < uses.size(); ++p)
        forEachEdge(uses[p], [&](std::span<const SurfaceEdgeUse> at) {
            const std::array<Label, 2> ends{p, at[0].upper};
            if (at.size() == 1) edges.push_back({ends, {at[0].triangle, -1}, 0});
            for (std::size_t i = 1; i < at.size(); ++i) {
                const Vec3& a = normals[index(at[i - 1].triangle)];
                const Vec3& b = normals[index(at[i].triangle)];
                const bool agree = at[i - 1].ascending != at[i].ascending;
                const bool hasNoArea = a == Vec3{} || b == Vec3{};
                edges.push_back({ends,
                                 {at[i - 1].triangle, at[i].triangle},
                                 hasNoArea ? 0 : angleBetween(a, agree ? b : -b)});
            }
        });
    return edges;
}

std::vector<double> largestCurvatures(const TriSurface& surface, double featureAngle) {
    std::vector<TriangleEdge> edges = triangleEdges(surface);
    std::erase_if(edges, [&](const TriangleEdge& edge) {
        return edge.triangles[1] < 0 || edge.angle > featureAngle;
    });
    const std::size_t count = surface.triangles.size();
    std::vector<Tensor> bends(count, Tensor{}); // of a triangle: half of what its edges bend
    std::vector<double> areas(count);
    for (Label t = 0; t < toLabel(count); ++t)
        areas[index(t)] = 0.5 * norm(cross(surface.corner(t, 1) - surface.corner(t, 0),
                                           surface.corner(t, 2) - surface.corner(t, 0)));
    for (const TriangleEdge& edge : edges) {
        const Vec3 way =
            surface.points[index(edge.points[1])] - surface.points[index(edge.points[0])];
        const double length = norm(way);
        if (!(length > 0)) continue;
        for (const Label t : edge.triangles)
            addOuter(bends[index(t)], 0.5 * edge.angle / length, way);
    }
    std::vector<Tensor> sums = bends; // with the neighbours
    std::vector<double> sumAreas = areas;
    for (const TriangleEdge& edge : edges)
        for (const std::size_t side : {0U, 1U}) {
            const std::size_t t = index(edge.triangles[side]);
            const std::size_t other = index(edge.triangles[1 - side]);
            for (std::size_t i = 0; i < 6; ++i)
                sums[t][i] += bends[other][i];
            sumAreas[t] += areas[other];
        }
    std::vector<double> result(count, 0);
    for (std::size_t t = 0; t < count; ++t)
        if (sumAreas[t] > 0) result[t] = largestEigenvalue(sums[t]) / sumAreas[t];
    return result;
}

} // namespace polymesh
