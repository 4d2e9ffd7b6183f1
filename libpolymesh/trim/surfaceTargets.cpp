// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/surfaceTargets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polymesh {

namespace {

Vec3 areaNormal(const TriSurface& surface, Label t) {
    return cross(surface.corner(t, 1) - surface.corner(t, 0),
                 surface.corner(t, 2) - surface.corner(t, 0));
}

Vec3 unit(const Vec3& v) {
    const double length = norm(v);
    return length > 0 ? v / length : Vec3{};
}

Box boxRound(const Vec3& p, double reach) {
    const Vec3 way{reach, reach, reach};
    return {p - way, p + way};
}

template<class Ends>
std::vector<Box> boxes(const TriSurface& surface, const std::vector<Label>& items, Ends&& ends) {
    std::vector<Box> result(items.size());
    for (std::size_t i = 0; i < items.size(); ++i)
        for (const Label v : ends(items[i]))
            result[i].add(surface.points[index(v)]);
    return result;
}

} // namespace

SurfaceTargets::SurfaceTargets(const CuttingSurface& cutter, const SurfaceFeatures& features)
    : surface_(*cutter.surface),
      edges_(cutter.edges.edges),
      features_(features),
      corners_(listed(features.isCorner)),
      featureEdges_(listed(features.isFeature)),
      tree_(cutter.triangleBoxes),
      cornerTree_(boxes(surface_,
                        corners_,
                        [&](Label v) {
                            return std::array<Label, 2>{v, v};
                        })),
      edgeTree_(boxes(surface_, featureEdges_, [&](Label e) {
          return std::array<Label, 2>{edges_[index(e)].start, edges_[index(e)].end};
      })) {
    sumCornerNormals();
}

ClosestPoint SurfaceTargets::closest(const Vec3& p, double reach) const {
    ClosestPoint best;
    double best2 = reach * reach;
    tree_.forEachNear(boxRound(p, reach), [&](Label t) {
        const Vec3 q =
            closestPoint({surface_.corner(t, 0), surface_.corner(t, 1), surface_.corner(t, 2)}, p);
        const double d2 = squaredNorm(q - p);
        if (d2 > best2 || (d2 == best2 && best.triangle >= 0 && t > best.triangle)) return;
        best2 = d2;
        best = {q, 0, t};
    });
    best.distance = std::sqrt(best2);
    return best;
}

Vec3 SurfaceTargets::normal(Label triangle) const {
    return unit(areaNormal(surface_, triangle));
}

Label SurfaceTargets::nearestCorner(const Vec3& p, double reach) const {
    Label best = -1;
    double best2 = 3 * reach * reach; // as where three faces meet at right angles
    const auto isWithin = [&](Label v) {
        const Vec3 way = surface_.points[index(v)] - p;
        return std::ranges::all_of(cornerTriangles_[placeOf(v)],
                                   [&](Label t) { return std::abs(dot(normal(t), way)) <= reach; });
    };
    cornerTree_.forEachNear(boxRound(p, std::sqrt(best2)), [&](Label i) {
        const Label v = corners_[index(i)];
        const double d2 = squaredNorm(surface_.points[index(v)] - p);
        if ((d2 < best2 || (d2 == best2 && v < best)) && isWithin(v)) {
            best2 = d2;
            best = v;
        }
    });
    return best;
}

NodeMove SurfaceTargets::onCorner(Label v) const {
    NodeMove move;
    move.target = AdjustTarget::corner;
    move.place = surface_.points[index(v)];
    move.inward = -cornerNormals_[index(placeOf(v))];
    return move;
}

std::optional<NodeMove>
SurfaceTargets::onEdge(const Vec3& p, double reach, const NodeFreedom& freedom) const {
    Label best = -1;
    double best2 = 2 * reach * reach; // as where two faces meet at right angles
    const auto isWithin = [&](Label e, const Vec3& way) {
        return std::abs(dot(normal(edges_[index(e)].left), way)) <= reach &&
               std::abs(dot(normal(edges_[index(e)].right), way)) <= reach;
    };
    NodeMove move;
    move.target = AdjustTarget::edge;
    edgeTree_.forEachNear(boxRound(p, std::sqrt(best2)), [&](Label i) {
        const Label e = featureEdges_[index(i)];
        const auto place = placeOnEdge(edges_[index(e)], p, freedom);
        if (!place) return;
        const double d2 = squaredNorm(*place - p);
        if ((d2 < best2 || (d2 == best2 && e < best)) && isWithin(e, *place - p)) {
            best2 = d2;
            best = e;
            move.place = *place;
        }
    });
    if (best < 0) return std::nullopt;
    const SurfaceEdge& edge = edges_[index(best)];
    move.inward = -unit(normal(edge.left) + normal(edge.right));
    return move;
}

std::optional<NodeMove>
SurfaceTargets::onFace(const Vec3& p, double reach, const NodeFreedom& freedom) const {
    ClosestPoint found = closest(p, reach);
    if (found.triangle < 0) return std::nullopt;
    Vec3 place = flush(found, found.point);
    if (!freedom.isFree()) {
        place = p;
        // On along the boundary to the plane of the closest triangle, until that is it.
        for (int step = 0; step < 4 && found.distance > 0; ++step) {
            const Vec3 n = normal(found.triangle);
            const Vec3 way = freedom.along(n);
            const double slope = dot(way, n);
            if (slope < 0.1) return std::nullopt;
            place += (dot(found.point - place, n) / slope) * way;
            place = freedom.held(flush(found, place), p);
            found = closest(place, reach);
            if (found.triangle < 0) return std::nullopt;
        }
        if (found.distance > 1e-12 * norm(place) + 1e-9 * reach) return std::nullopt;
    }
    if (norm(place - p) > reach) return std::nullopt;
    NodeMove move;
    move.place = place;
    move.inward = -normal(found.triangle);
    return move;
}

std::vector<Label> SurfaceTargets::listed(const std::vector<char>& flags) {
    std::vector<Label> list;
    for (std::size_t i = 0; i < flags.size(); ++i)
        if (flags[i] != 0) list.push_back(toLabel(i));
    return list;
}

/// Of the corner v in corners_.
Label SurfaceTargets::placeOf(Label v) const {
    return toLabel(
        static_cast<std::size_t>(std::ranges::lower_bound(corners_, v) - corners_.begin()));
}

/// The triangles of each corner and their normals' sum: angle-weighted, so that they do not
/// depend on how flat parts are cut into triangles.
void SurfaceTargets::sumCornerNormals() {
    std::vector<std::array<Label, 2>> pairs;
    cornerNormals_.resize(corners_.size());
    for (Label t = 0; t < surface_.triangleCount(); ++t)
        for (int i = 0; i < 3; ++i) {
            const Label v = surface_.triangles[index(t)][static_cast<std::size_t>(i)];
            if (features_.isCorner[index(v)] == 0) continue;
            const Vec3 a = surface_.corner(t, (i + 1) % 3) - surface_.corner(t, i);
            const Vec3 b = surface_.corner(t, (i + 2) % 3) - surface_.corner(t, i);
            pairs.push_back({placeOf(v), t});
            cornerNormals_[index(placeOf(v))] +=
                std::atan2(norm(cross(a, b)), dot(a, b)) * normal(t);
        }
    std::ranges::sort(pairs);
    std::vector<Label> triangles;
    std::size_t next = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        cornerNormals_[i] = unit(cornerNormals_[i]);
        triangles.clear();
        for (; next < pairs.size() && pairs[next][0] == toLabel(i); ++next)
            triangles.push_back(pairs[next][1]);
        cornerTriangles_.add(triangles);
    }
}

std::optional<Vec3> SurfaceTargets::placeOnEdge(const SurfaceEdge& edge,
                                                const Vec3& p,
                                                const NodeFreedom& freedom) const {
    const Vec3& a = surface_.points[index(edge.start)];
    const Vec3 ab = surface_.points[index(edge.end)] - a;
    const double length2 = squaredNorm(ab);
    if (!(length2 > 0)) return std::nullopt;
    double s = dot(p - a, ab) / length2;
    if (!freedom.isFree()) {
        if (!freedom.isPlane()) return std::nullopt;
        const double slope = dot(ab, freedom.normal());
        const double height = dot(p - a, freedom.normal());
        const double hair = 1e-9 * std::sqrt(length2);
        if (std::abs(slope) > hair) {
            s = height / slope;
            if (s < 0 || s > 1) return std::nullopt;
        } else if (std::abs(height) > hair) {
            return std::nullopt;
        }
    }
    s = std::clamp(s, 0.0, 1.0);
    return freedom.held(s == 1 ? surface_.points[index(edge.end)] : a + s * ab, p);
}

/// A place on an axis-parallel triangle has that coordinate to the bit.
Vec3 SurfaceTargets::flush(const ClosestPoint& on, Vec3 place) const {
    const Vec3& a = surface_.corner(on.triangle, 0);
    for (int axis = 0; axis < 3; ++axis)
        if (surface_.corner(on.triangle, 1)[axis] == a[axis] &&
            surface_.corner(on.triangle, 2)[axis] == a[axis])
            place[axis] = a[axis];
    return place;
}

} // namespace polymesh
