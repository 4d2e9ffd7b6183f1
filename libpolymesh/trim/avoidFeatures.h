// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/trim/closestOnSegments.h"
#include "libpolymesh/trim/nearNodes.h"
#include "libpolymesh/trim/nodeMove.h"
#include "libpolymesh/trim/surfaceTargets.h"

#include <array>
#include <span>
#include <vector>

namespace polymesh {

/// Keeps edges of the mesh away from the feature edges of the surface, and faces of the mesh from
/// its corners, by 0.4 times `options.distance` of the shortest edge there, with Adjust::avoid; and
/// both from `options.avoided`.
class FeatureAvoidance {
public:
    /// `near` must hold all nodes of faces near the surface. All arguments must outlive the object.
    /// Cost: a pass over the faces, in parallel.
    FeatureAvoidance(const PolyMesh& mesh,
                     const SurfaceTargets& targets,
                     const std::vector<NearNode>& near,
                     const AdjustOptions& options);

    /// How many edges and faces of the mesh, as it is now, are nearer than that.
    CloseCounts count();

    /// Changes moves away from the surface (findMoves); nodes that are moved onto it stay there.
    /// Moves that are in each other's way are made in turn, some rounds of all, so that not all get
    /// what they want. No node goes farther than 1.4 times the distance from where it is. Returned
    /// by ascending node; the same with any number of threads. Cost: some microseconds for an edge
    /// near a feature edge.
    std::vector<NodeMove> extended(const std::vector<NodeMove>& moves);

private:
    /// An edge of the mesh by its places among the near nodes, the lower first.
    using NearEdge = std::array<Label, 2>;

    /// The edges and faces of the mesh that features may come near.
    struct Passed {
        std::vector<NearEdge> edges; // ascending
        Rows<Label> faces;           // places among the near nodes
    };

    template<class Visit>
    void forAvoided(const Box& box, Visit&& visit) const;
    std::vector<StraightEdge> featuresNear(const Box& box) const;
    std::vector<Vec3> cornersNear(const Box& box) const;
    void findPassed();
    void addFace(Label f, const std::vector<Label>& nearOf, Passed& part) const;
    void placeNodes();
    double clearanceOf(std::span<const Label> nodes) const;
    std::vector<Vec3> pointsOf(std::span<const Label> nodes) const;
    void push(Label i, const Vec3& way);
    void clearEdge(const NearEdge& edge);
    void clearFace(std::span<const Label> nodes);
    void clearNode(std::size_t i);
    std::vector<NodeMove> finished() const;

    const PolyMesh& mesh_;
    const SurfaceTargets& targets_;
    const std::vector<NearNode>& near_;
    const AdjustOptions& options_;
    std::vector<Vec3> avoided_;           // by x
    std::vector<Vec3> places_;            // of the near nodes [m]
    std::vector<std::uint8_t> isSettled_; // those that are on the surface
    Passed passed_;
};

} // namespace polymesh
