// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/settleNodes.h"

#include "libpolymesh/trim/chains.h"

#include <algorithm>
#include <cmath>

namespace polymesh {

namespace {

class Gathering {
public:
    Gathering(const Probe& probe,
              const CuttingSurface& cutter,
              const SurfaceFeatures& features,
              const ArrangedPoints& points,
              const std::vector<SettledNode>& settled)
        : arrangement_(points.arrangement),
          positions_(points.positions),
          probe_(probe),
          cutter_(cutter),
          features_(features),
          settled_(settled),
          settledAt_(index(probe.nodeCount()), -1) {
        for (std::size_t i = 0; i < settled.size(); ++i)
            settledAt_[index(settled[i].node)] = toLabel(i);
    }

    std::vector<std::array<Label, 2>> run() {
        for (Label e = 0; e < probe_.edgeCount(); ++e)
            for (Label x = arrangement_.crossings.offsets[index(e)];
                 x < arrangement_.crossings.offsets[index(e) + 1];
                 ++x)
                joinCrossing(e, arrangement_.firstCrossing() + x);
        for (Label facet = 0; facet < probe_.facetCount(); ++facet)
            for (Label x = arrangement_.pierces.offsets[index(facet)];
                 x < arrangement_.pierces.offsets[index(facet) + 1];
                 ++x)
                joinPierce(facet, arrangement_.firstPierce() + x);
        for (std::size_t v = 0; v < arrangement_.vertexCell.size(); ++v) {
            const Label cell = arrangement_.vertexCell[v];
            if (cell < 0) continue;
            for (const Label f : probe_.cellFaces[cell])
                join(arrangement_.firstVertex() + toLabel(v),
                     probe_.faceNodes[f],
                     1,
                     [](const SettledNode&) { return true; });
        }
        return std::move(pairs_);
    }

private:
    static constexpr double reach = 4; // in depths

    bool isInPlane(const SettledNode& node, Label triangle) const {
        const auto t = cutter_.triangle(triangle);
        const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
        return std::abs(dot(n, node.place - t[0])) <= node.depth * norm(n);
    }

    void joinCrossing(Label edge, Label point) {
        join(point, probe_.edges[index(edge)], reach, [&](const SettledNode& node) {
            return isInPlane(node, arrangement_.crossing(point).triangle);
        });
    }

    void joinPierce(Label facet, Label point) {
        const Label e = arrangement_.pierce(point).edge;
        const SurfaceEdge& edge = cutter_.edges.edges[index(e)];
        const bool isFeature = features_.isFeature[index(e)] != 0;
        join(point, probe_.facetNodes[facet], reach, [&](const SettledNode& node) {
            if (!isInPlane(node, edge.left) || !isInPlane(node, edge.right)) return false;
            const auto& points = cutter_.surface->points;
            return !isFeature || distanceToSegment(node.place,
                                                   points[index(edge.start)],
                                                   points[index(edge.end)]) <= node.depth;
        });
    }

    /// Joins the point with the nearest of the nodes that has it within so many depths and belongs
    /// to it.
    template<class Belongs>
    void join(Label point, std::span<const Label> nodes, double depths, Belongs&& belongs) {
        Label best = -1;
        double bestDistance = Box::inf;
        for (const Label n : nodes) {
            const Label i = settledAt_[index(n)];
            if (i < 0) continue;
            const SettledNode& node = settled_[index(i)];
            const double distance = norm(positions_[index(point)] - node.place);
            if (distance > depths * node.depth || distance >= bestDistance || !belongs(node))
                continue;
            best = n;
            bestDistance = distance;
        }
        if (best >= 0) pairs_.push_back({point, best});
    }

    const Arrangement& arrangement_;
    const PointPositions& positions_;
    const Probe& probe_;
    const CuttingSurface& cutter_;
    const SurfaceFeatures& features_;
    const std::vector<SettledNode>& settled_;
    std::vector<Label> settledAt_; // local node -> place in settled_, or -1
    std::vector<std::array<Label, 2>> pairs_;
};

} // namespace

std::vector<SettledNode> probedNodes(const Probe& probe, const std::vector<SettledNode>& settled) {
    std::vector<SettledNode> local;
    for (SettledNode node : settled) {
        const auto at = std::ranges::lower_bound(probe.nodes, node.node);
        if (at == probe.nodes.end() || *at != node.node) continue;
        node.node = toLabel(static_cast<std::size_t>(at - probe.nodes.begin()));
        local.push_back(node);
    }
    return local;
}

std::vector<std::array<Label, 2>> pointsAtNodes(const Probe& probe,
                                                const CuttingSurface& cutter,
                                                const SurfaceFeatures& features,
                                                const ArrangedPoints& points,
                                                const std::vector<SettledNode>& settled) {
    if (settled.empty()) return {};
    return Gathering(probe, cutter, features, points, settled).run();
}

void placeSettled(const std::vector<SettledNode>& settled,
                  PolyMesh& mesh,
                  Probe& probe,
                  PointPositions& positions) {
    for (const SettledNode& node : settled) {
        positions[index(node.node)] = probe.nodePoints[index(node.node)] = node.place;
        const Label meshPoint = probe.nodes[index(node.node)];
        if (meshPoint >= 0) mesh.points[index(meshPoint)] = node.place;
    }
}

} // namespace polymesh
