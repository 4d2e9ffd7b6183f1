// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/adjustTargets.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/surface/boxTree.h"
#include "libpolymesh/surface/distance.h"
#include "libpolymesh/trim/nodeFreedom.h"
#include "libpolymesh/trim/triangleBins.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <optional>

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
            shorten(p, length2);
            shorten(before, length2);
            before = p;
        }
    });
    parallelFor(mesh.pointCount(),
                [&](Label p) { shortest[index(p)] = std::sqrt(shortest[index(p)]); });
    return shortest;
}

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

/// What of the surface a node can be put onto. Edges and corners have trees of their own.
class Targets {
public:
    Targets(const CuttingSurface& cutter, const SurfaceFeatures& features)
        : surface_(*cutter.surface),
          edges_(cutter.edges.edges),
          features_(features),
          corners_(listed(features.isCorner)),
          featureEdges_(listed(features.isFeature)),
          tree_(cutter.triangleBoxes),
          cornerTree_(boxes(corners_,
                            [&](Label v) {
                                return std::array<Label, 2>{v, v};
                            })),
          edgeTree_(boxes(featureEdges_, [&](Label e) {
              return std::array<Label, 2>{edges_[index(e)].start, edges_[index(e)].end};
          })) {
        sumCornerNormals();
    }

    /// The closest point of the surface within reach of p; triangle -1: there is none.
    ClosestPoint closest(const Vec3& p, double reach) const {
        ClosestPoint best;
        double best2 = reach * reach;
        tree_.forEachNear(boxRound(p, reach), [&](Label t) {
            const Vec3 q = closestPoint(
                {surface_.corner(t, 0), surface_.corner(t, 1), surface_.corner(t, 2)}, p);
            const double d2 = squaredNorm(q - p);
            if (d2 > best2 || (d2 == best2 && best.triangle >= 0 && t > best.triangle)) return;
            best2 = d2;
            best = {q, 0, t};
        });
        best.distance = std::sqrt(best2);
        return best;
    }

    Vec3 normal(Label triangle) const { return unit(areaNormal(surface_, triangle)); }

    /// The closest corner all of whose faces are within reach of p, or -1.
    Label nearestCorner(const Vec3& p, double reach) const {
        Label best = -1;
        double best2 = 3 * reach * reach; // as where three faces meet at right angles
        const auto isWithin = [&](Label v) {
            const Vec3 way = surface_.points[index(v)] - p;
            return std::ranges::all_of(cornerTriangles_[placeOf(v)], [&](Label t) {
                return std::abs(dot(normal(t), way)) <= reach;
            });
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

    NodeMove onCorner(Label v) const {
        NodeMove move;
        move.target = AdjustTarget::corner;
        move.place = surface_.points[index(v)];
        move.inward = -cornerNormals_[index(placeOf(v))];
        return move;
    }

    /// The closest place on a feature edge, with both faces within reach, that a node at p may go
    /// to.
    std::optional<NodeMove> onEdge(const Vec3& p, double reach, const NodeFreedom& freedom) const {
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

    /// The closest place on a triangle that a node at p may go to.
    std::optional<NodeMove> onFace(const Vec3& p, double reach, const NodeFreedom& freedom) const {
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

private:
    static std::vector<Label> listed(const std::vector<char>& flags) {
        std::vector<Label> list;
        for (std::size_t i = 0; i < flags.size(); ++i)
            if (flags[i] != 0) list.push_back(toLabel(i));
        return list;
    }

    template<class Ends>
    std::vector<Box> boxes(const std::vector<Label>& items, Ends&& ends) const {
        std::vector<Box> result(items.size());
        for (std::size_t i = 0; i < items.size(); ++i)
            for (const Label v : ends(items[i]))
                result[i].add(surface_.points[index(v)]);
        return result;
    }

    /// Of the corner v in corners_.
    Label placeOf(Label v) const {
        return toLabel(
            static_cast<std::size_t>(std::ranges::lower_bound(corners_, v) - corners_.begin()));
    }

    /// The triangles of each corner and their normals' sum: angle-weighted, so that they do not
    /// depend on how flat parts are cut into triangles.
    void sumCornerNormals() {
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

    std::optional<Vec3>
    placeOnEdge(const SurfaceEdge& edge, const Vec3& p, const NodeFreedom& freedom) const {
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
    Vec3 flush(const ClosestPoint& on, Vec3 place) const {
        const Vec3& a = surface_.corner(on.triangle, 0);
        for (int axis = 0; axis < 3; ++axis)
            if (surface_.corner(on.triangle, 1)[axis] == a[axis] &&
                surface_.corner(on.triangle, 2)[axis] == a[axis])
                place[axis] = a[axis];
        return place;
    }

    const TriSurface& surface_;
    const std::vector<SurfaceEdge>& edges_;
    const SurfaceFeatures& features_;
    std::vector<Label> corners_;
    std::vector<Label> featureEdges_;
    BoxTree tree_;
    BoxTree cornerTree_;
    BoxTree edgeTree_;
    std::vector<Vec3> cornerNormals_; // beside corners_
    Rows<Label> cornerTriangles_;     // beside corners_
};

/// A point of the mesh within reach of a bin with triangles.
struct NearNode {
    Label node = -1;
    Label corner = -1; // of the surface, within reach
    double size = 0;
    NodeFreedom freedom;
};

class MoveFinder {
public:
    MoveFinder(const PolyMesh& mesh,
               const CuttingSurface& cutter,
               const SurfaceFeatures& features,
               const AdjustOptions& options)
        : mesh_(mesh), options_(options), targets_(cutter, features) {
        findNear(*cutter.surface);
        restrictBoundary();
    }

    std::vector<NodeMove> run() {
        if (options_.how == Adjust::project) claimCorners();
        std::vector<NodeMove> moves(near_.size());
        parallelFor(toLabel(near_.size()), [&](Label i) {
            const auto move =
                options_.how == Adjust::project ? project(near_[index(i)]) : repel(near_[index(i)]);
            if (move) moves[index(i)] = finished(*move, near_[index(i)]);
        });
        std::erase_if(moves, [](const NodeMove& move) { return move.node < 0; });
        return moves;
    }

private:
    void findNear(const TriSurface& surface) {
        const std::vector<double> sizes = shortestEdges(mesh_);
        const double mean =
            parallelSum(mesh_.pointCount(), 0.0, [&](Label p) { return sizes[index(p)]; }) /
            static_cast<double>(std::max<std::size_t>(sizes.size(), 1));
        const TriangleBins bins(surface, mean);
        const double farthest =
            options_.distance * (options_.how == Adjust::project ? std::numbers::sqrt3 : 1);
        constexpr Label block = 4096;
        std::vector<std::vector<NearNode>> parts(index((mesh_.pointCount() + block - 1) / block));
        parallelBlocks(mesh_.pointCount(), block, [&](Label b, Label first, Label last) {
            for (Label p = first; p < last; ++p) {
                const double reach = farthest * sizes[index(p)];
                const Vec3& at = mesh_.points[index(p)];
                TriangleBins::Range range;
                range.add(bins.binOf(at - Vec3{reach, reach, reach}));
                range.add(bins.binOf(at + Vec3{reach, reach, reach}));
                if (bins.isOccupied(range))
                    parts[index(b)].push_back({p, -1, sizes[index(p)], NodeFreedom()});
            }
        });
        for (const auto& part : parts)
            near_.insert(near_.end(), part.begin(), part.end());
    }

    void restrictBoundary() {
        std::vector<Label> nearOf(mesh_.points.size(), -1);
        for (std::size_t i = 0; i < near_.size(); ++i)
            nearOf[index(near_[i].node)] = toLabel(i);
        for (Label f = mesh_.internalFaceCount(); f < mesh_.faceCount(); ++f) {
            const auto face = mesh_.faces[f];
            if (std::ranges::all_of(face, [&](Label p) { return nearOf[index(p)] < 0; })) continue;
            const Vec3 normal = unit(faceGeometry(mesh_.points, face).area);
            for (const Label p : face)
                if (nearOf[index(p)] >= 0) near_[index(nearOf[index(p)])].freedom.addPlane(normal);
        }
    }

    const Vec3& at(const NearNode& near) const { return mesh_.points[index(near.node)]; }

    double reach(const NearNode& near) const { return options_.distance * near.size; }

    /// Each corner of the surface takes the nearest of the nodes that have it nearest.
    void claimCorners() {
        parallelFor(toLabel(near_.size()), [&](Label i) {
            NearNode& near = near_[index(i)];
            near.corner = targets_.nearestCorner(at(near), reach(near));
            if (near.corner < 0) return;
            const Vec3 way = targets_.onCorner(near.corner).place - at(near);
            if (norm(way - near.freedom.along(way)) > 1e-9 * near.size) near.corner = -1;
        });

        struct Claim {
            Label corner;
            double distance;
            std::size_t near;
        };

        std::vector<Claim> claims;
        for (std::size_t i = 0; i < near_.size(); ++i)
            if (near_[i].corner >= 0)
                claims.push_back({near_[i].corner,
                                  norm(targets_.onCorner(near_[i].corner).place - at(near_[i])),
                                  i});
        std::ranges::sort(claims, [](const Claim& a, const Claim& b) {
            if (a.corner != b.corner) return a.corner < b.corner;
            return a.distance != b.distance ? a.distance < b.distance : a.near < b.near;
        });
        for (std::size_t i = 1; i < claims.size(); ++i)
            if (claims[i].corner == claims[i - 1].corner) near_[claims[i].near].corner = -1;
    }

    std::optional<NodeMove> project(const NearNode& near) const {
        if (near.corner >= 0) return targets_.onCorner(near.corner);
        if (near.freedom.isFixed()) return std::nullopt;
        if (auto move = targets_.onEdge(at(near), reach(near), near.freedom)) return move;
        return targets_.onFace(at(near), reach(near), near.freedom);
    }

    std::optional<NodeMove> repel(const NearNode& near) const {
        const ClosestPoint closest = targets_.closest(at(near), reach(near));
        if (closest.triangle < 0) return std::nullopt;
        const Vec3 way = at(near) - closest.point;
        const bool isOn = closest.distance < 1e-9 * near.size;
        const Vec3 direction = isOn ? targets_.normal(closest.triangle) : unit(way);
        NodeMove move;
        move.target = AdjustTarget::away;
        move.place = near.freedom.held(
            at(near) + near.freedom.along((reach(near) - closest.distance) * direction), at(near));
        return move;
    }

    NodeMove finished(NodeMove move, const NearNode& near) const {
        if (move.place == at(near)) return {};
        move.node = near.node;
        move.size = near.size;
        move.way = norm(move.place - at(near)) / near.size;
        move.inward = near.freedom.held(unit(near.freedom.along(move.inward)), Vec3{});
        return move;
    }

    const PolyMesh& mesh_;
    const AdjustOptions& options_;
    Targets targets_;
    std::vector<NearNode> near_;
};

} // namespace

std::vector<NodeMove> findMoves(const PolyMesh& mesh,
                                const CuttingSurface& surface,
                                const SurfaceFeatures& features,
                                const AdjustOptions& options) {
    return MoveFinder(mesh, surface, features, options).run();
}

} // namespace polymesh
