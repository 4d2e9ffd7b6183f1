// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/adjustTargets.h"

#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <numbers>
#include <optional>

namespace polymesh {

namespace {

Vec3 unit(const Vec3& v) {
    const double length = norm(v);
    return length > 0 ? v / length : Vec3{};
}

class MoveFinder {
public:
    MoveFinder(const PolyMesh& mesh,
               const SurfaceTargets& targets,
               const std::vector<NearNode>& near,
               const AdjustOptions& options)
        : mesh_(mesh),
          options_(options),
          targets_(targets),
          near_(near),
          corner_(near.size(), -1) {}

    std::vector<NodeMove> run() {
        if (options_.how == Adjust::project) claimCorners();
        std::vector<NodeMove> moves(near_.size());
        parallelFor(toLabel(near_.size()), [&](Label i) {
            const auto move =
                options_.how == Adjust::project ? project(index(i)) : repel(near_[index(i)]);
            if (move) moves[index(i)] = finished(*move, near_[index(i)]);
        });
        std::erase_if(moves, [](const NodeMove& move) { return move.node < 0; });
        return moves;
    }

private:
    const Vec3& at(const NearNode& near) const { return mesh_.points[index(near.node)]; }

    double reach(const NearNode& near) const { return options_.distance * near.size; }

    /// Each corner of the surface takes the nearest of the nodes that have it nearest.
    void claimCorners() {
        parallelFor(toLabel(near_.size()), [&](Label i) {
            const NearNode& near = near_[index(i)];
            Label& corner = corner_[index(i)];
            corner = targets_.nearestCorner(at(near), reach(near));
            if (corner < 0) return;
            const Vec3 way = targets_.onCorner(corner).place - at(near);
            if (norm(way - near.freedom.along(way)) > 1e-9 * near.size) corner = -1;
        });

        struct Claim {
            Label corner;
            double distance;
            std::size_t near;
        };

        std::vector<Claim> claims;
        for (std::size_t i = 0; i < near_.size(); ++i)
            if (corner_[i] >= 0)
                claims.push_back(
                    {corner_[i], norm(targets_.onCorner(corner_[i]).place - at(near_[i])), i});
        std::ranges::sort(claims, [](const Claim& a, const Claim& b) {
            if (a.corner != b.corner) return a.corner < b.corner;
            return a.distance != b.distance ? a.distance < b.distance : a.near < b.near;
        });
        for (std::size_t i = 1; i < claims.size(); ++i)
            if (claims[i].corner == claims[i - 1].corner) corner_[claims[i].near] = -1;
    }

    std::optional<NodeMove> project(std::size_t i) const {
        const NearNode& near = near_[i];
        if (std::ranges::binary_search(options_.repelled, near.node)) return repel(near);
        if (corner_[i] >= 0) return targets_.onCorner(corner_[i]);
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
    const SurfaceTargets& targets_;
    const std::vector<NearNode>& near_;
    std::vector<Label> corner_; // of the surface, within reach; beside near_
};

} // namespace

double farthestReach(const AdjustOptions& options) {
    // A corner may be farther away than its three planes.
    return options.distance * (options.how == Adjust::project ? std::numbers::sqrt3 : 1);
}

std::vector<NodeMove> findMoves(const PolyMesh& mesh,
                                const SurfaceTargets& targets,
                                const std::vector<NearNode>& near,
                                const AdjustOptions& options) {
    return MoveFinder(mesh, targets, near, options).run();
}

} // namespace polymesh
