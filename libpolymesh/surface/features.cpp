// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/features.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/surface/coplanar.h"

#include <algorithm>
#include <cmath>

namespace polymesh {

namespace {

double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(norm(cross(a, b)), dot(a, b));
}

/// The right-hand normal, not of unit length; exactly zero for a triangle without area.
Vec3 areaNormal(const TriSurface& surface, Label t) {
    const Vec3& a = surface.corner(t, 0);
    const Vec3& b = surface.corner(t, 1);
    const Vec3& c = surface.corner(t, 2);
    if (areCollinear(a, b, c)) return {};
    return cross(b - a, c - a);
}

Label neighbourAcrossLongestSide(const TriSurface& surface, const SurfaceEdges& edges, Label t) {
    std::array<double, 3> lengths{};
    for (int i = 0; i < 3; ++i)
        lengths[static_cast<std::size_t>(i)] =
            squaredNorm(surface.corner(t, (i + 1) % 3) - surface.corner(t, i));
    const auto longest = std::ranges::max_element(lengths) - lengths.begin();
    const auto& edge =
        edges.edges[index(edges.ofTriangle[index(t)][static_cast<std::size_t>(longest)])];
    return edge.left == t ? edge.right : edge.left;
}

/// One normal a triangle; those without area borrow one, unless a dozen in a row have none.
std::vector<Vec3> findNormals(const TriSurface& surface, const SurfaceEdges& edges) {
    std::vector<Vec3> own(surface.triangles.size());
    parallelFor(surface.triangleCount(), [&](Label t) { own[index(t)] = areaNormal(surface, t); });
    std::vector<Vec3> normals(own);
    parallelFor(surface.triangleCount(), [&](Label t) {
        Label lender = t;
        for (int steps = 0; steps < 12 && own[index(lender)] == Vec3{}; ++steps)
            lender = neighbourAcrossLongestSide(surface, edges, lender);
        normals[index(t)] = own[index(lender)];
    });
    return normals;
}

/// What a point knows of its feature edges: how many, and the other ends of the first two.
struct FeatureStar {
    Label count = 0;
    std::array<Label, 2> ends{};

    void add(Label end) {
        if (count < 2) ends[index(count)] = end;
        ++count;
    }
};

std::vector<FeatureStar> findStars(const TriSurface& surface,
                                   const SurfaceEdges& edges,
                                   const std::vector<char>& isFeature) {
    std::vector<FeatureStar> stars(surface.points.size());
    const SurfaceEdge* last = nullptr; // edges with the same end points follow one another
    for (std::size_t e = 0; e < edges.edges.size(); ++e) {
        const SurfaceEdge& edge = edges.edges[e];
        if (isFeature[e] == 0) continue;
        if (last != nullptr && last->start == edge.start && last->end == edge.end) continue;
        stars[index(edge.start)].add(edge.end);
        stars[index(edge.end)].add(edge.start);
        last = &edge;
    }
    return stars;
}

} // namespace

SurfaceFeatures
findFeatures(const TriSurface& surface, const SurfaceEdges& edges, double featureAngle) {
    const std::vector<Vec3> normals = findNormals(surface, edges);
    SurfaceFeatures features;
    features.isFeature.resize(edges.edges.size());
    parallelFor(toLabel(edges.edges.size()), [&](Label e) {
        const SurfaceEdge& edge = edges.edges[index(e)];
        const bool isBorder = surface.region[index(edge.left)] != surface.region[index(edge.right)];
        const bool isSharp =
            angleBetween(normals[index(edge.left)], normals[index(edge.right)]) > featureAngle;
        features.isFeature[index(e)] = isBorder || isSharp ? 1 : 0;
    });

    const auto stars = findStars(surface, edges, features.isFeature);
    features.isCorner.resize(surface.points.size());
    parallelFor(surface.pointCount(), [&](Label p) {
        const FeatureStar& star = stars[index(p)];
        bool isCorner = star.count != 0 && star.count != 2;
        if (star.count == 2) {
            const Vec3& here = surface.points[index(p)];
            isCorner = angleBetween(here - surface.points[index(star.ends[0])],
                                    surface.points[index(star.ends[1])] - here) > featureAngle;
        }
        features.isCorner[index(p)] = isCorner ? 1 : 0;
    });
    return features;
}

bool isExactlyFlat(const TriSurface& surface, const SurfaceEdge& edge) {
    const auto apex = [&](Label t) {
        for (Label corner : surface.triangles[index(t)])
            if (corner != edge.start && corner != edge.end) return surface.points[index(corner)];
        return Vec3{};
    };
    const Vec3& a = surface.points[index(edge.start)];
    const Vec3& b = surface.points[index(edge.end)];
    const Vec3 left = apex(edge.left);
    const Vec3 right = apex(edge.right);
    return orient3d(a, b, left, right) == 0 && !areCollinear(a, b, left) &&
           sideOfLine(a, b, left, right) < 0;
}

} // namespace polymesh
