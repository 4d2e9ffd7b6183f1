// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/surfaceCriteria.h"

#include "libpolymesh/refine/surfaceCurvature.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polymesh {
namespace {

/// The largest distance that matters to a cell of this level; -1 when none does.
double reachOf(const std::vector<Shell>& shells, int level) {
    double reach = -1;
    for (const Shell& shell : shells)
        if (shell.level > level) reach = std::max(reach, shell.distance);
    return reach;
}

Vec3 closestOnSegment(const Vec3& a, const Vec3& b, const Vec3& p) {
    return closestPoint({a, b, b}, p);
}

/// A half of the cosine between normals up to which parts of a surface face each other.
constexpr double facing = -0.5;

/// The width of the gap that a ray from a point of the surface crosses, up to `atMost`; infinite
/// when nothing faces the point there.
double gapWidth(const NearTriangles& near,
                Label triangle,
                const Vec3& from,
                const Vec3& direction,
                double atMost) {
    const Vec3 normal = unitNormal(near.cornersOf(triangle));
    const auto hit = near.firstHit(from, from + atMost * direction, [&](Label t) {
        return t != triangle && dot(unitNormal(near.cornersOf(t)), normal) <= facing;
    });
    return hit ? *hit * atMost : std::numeric_limits<double>::infinity();
}

} // namespace

Criterion cellCriterion(std::vector<Label> cells, int level) {
    std::ranges::sort(cells);
    return [cells = std::move(cells), level](const RefineCell& cell) {
        return cell.level < level && std::ranges::binary_search(cells, cell.initialCell);
    };
}

Criterion distanceCriterion(std::shared_ptr<const NearTriangles> near, std::vector<Shell> shells) {
    return [near = std::move(near), shells = std::move(shells)](const RefineCell& cell) {
        // The farthest shell of a higher level than the cell has is the only one that matters.
        const double reach = reachOf(shells, cell.level);
        return reach >= 0 && near->closest(cell.centre, reach + cell.radius).has_value();
    };
}

Criterion curvatureCriterion(std::shared_ptr<const NearTriangles> near,
                             const CurvatureLimits& limits) {
    const std::vector<double> curvatures = largestCurvatures(near->surface(), limits.featureAngle);
    std::vector<double> sizes(curvatures.size());
    for (std::size_t t = 0; t < sizes.size(); ++t)
        sizes[t] = curvatures[t] > 0 ? 1 / (curvatures[t] * limits.cellsPerRadius) : Box::inf;
    return [near = std::move(near), sizes = std::move(sizes), level = limits.level](
               const RefineCell& cell) {
        if (cell.level >= level) return false;
        bool isTooLarge = false;
        near->forNear(cell.centre, cell.radius, [&](Label t, const Vec3&) {
            isTooLarge = isTooLarge || cell.size > sizes[index(t)];
        });
        return isTooLarge;
    };
}

Criterion featureCriterion(const TriSurface& surface, const FeatureLimits& limits) {
    struct Segments {
        std::vector<std::array<Vec3, 2>> ends;
        std::unique_ptr<BoxTree> tree;
    };

    auto segments = std::make_shared<Segments>();
    std::vector<Box> boxes;
    for (const TriangleEdge& edge : triangleEdges(surface)) {
        if (edge.triangles[1] >= 0 && !(edge.angle > limits.angle)) continue;
        const Vec3& a = surface.points[index(edge.points[0])];
        const Vec3& b = surface.points[index(edge.points[1])];
        segments->ends.push_back({a, b});
        boxes.push_back(boundingBox(segments->ends.back()));
    }
    segments->tree = std::make_unique<BoxTree>(boxes);
    return [segments, shell = limits.shell](const RefineCell& cell) {
        if (cell.level >= shell.level) return false;
        const double reach = shell.distance + cell.radius;
        const double reach2 = std::nextafter(reach * reach, Box::inf);
        bool isNear = false;
        segments->tree->searchNearest(
            cell.centre,
            [&](Label s) {
                const auto& [a, b] = segments->ends[index(s)];
                const double d2 = squaredNorm(closestOnSegment(a, b, cell.centre) - cell.centre);
                isNear = isNear || d2 < reach2;
                return isNear ? 0 : d2; // one is enough
            },
            reach2);
        return isNear;
    };
}

Criterion gapCriterion(std::shared_ptr<const NearTriangles> near, const GapLimits& limits) {
    return [near = std::move(near), limits](const RefineCell& cell) {
        if (cell.level >= limits.level) return false;
        const double widest = limits.cells * cell.size; // wider gaps have enough cells
        bool isTooLarge = false;
        const auto look = [&](Label triangle, const Vec3& from, const Vec3& direction) {
            isTooLarge = isTooLarge || gapWidth(*near, triangle, from, direction, widest) < widest;
        };
        near->forNear(cell.centre, cell.radius, [&](Label t, const Vec3& q) {
            const Vec3 normal = unitNormal(near->cornersOf(t));
            if (normal == Vec3{}) return;
            look(t, q, normal);
            look(t, q, -normal);
        });
        if (isTooLarge) return true;
        // A cell between the walls that touches neither.
        const auto wall = near->closest(cell.centre, widest);
        if (!wall || wall->distance <= cell.radius) return false;
        look(wall->triangle, wall->point, (cell.centre - wall->point) / wall->distance);
        return isTooLarge;
    };
}

} // namespace polymesh
