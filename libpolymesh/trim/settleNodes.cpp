// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/settleNodes.h"

#include <algorithm>

namespace polymesh {

namespace {

class Gathering {
public:
    Gathering(const Probe& probe,
              const Arrangement& arrangement,
              const PointPositions& positions,
              const std::vector<SettledNode>& settled)
        : arrangement_(arrangement),
          probe_(probe),
          positions_(positions),
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
                join(arrangement_.firstCrossing() + x, probe_.edges[index(e)]);
        for (Label facet = 0; facet < probe_.facetCount(); ++facet)
            for (Label x = arrangement_.pierces.offsets[index(facet)];
                 x < arrangement_.pierces.offsets[index(facet) + 1];
                 ++x)
                join(arrangement_.firstPierce() + x, probe_.facetNodes[facet]);
        for (std::size_t v = 0; v < arrangement_.vertexCell.size(); ++v) {
            const Label cell = arrangement_.vertexCell[v];
            if (cell < 0) continue;
            for (const Label f : probe_.cellFaces[cell])
                join(arrangement_.firstVertex() + toLabel(v), probe_.faceNodes[f]);
        }
        return std::move(pairs_);
    }

private:
    /// Joins the point with the nearest of the nodes that has it within its radius.
    void join(Label point, std::span<const Label> nodes) {
        Label best = -1;
        double bestDistance = Box::inf;
        for (const Label n : nodes) {
            const Label i = settledAt_[index(n)];
            if (i < 0) continue;
            const double distance = norm(positions_[index(point)] - settled_[index(i)].place);
            if (distance > settled_[index(i)].radius || distance >= bestDistance) continue;
            best = n;
            bestDistance = distance;
        }
        if (best >= 0) pairs_.push_back({point, best});
    }

    const Arrangement& arrangement_;
    const Probe& probe_;
    const PointPositions& positions_;
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
                                                const Arrangement& arrangement,
                                                const PointPositions& positions,
                                                const std::vector<SettledNode>& settled) {
    if (settled.empty()) return {};
    return Gathering(probe, arrangement, positions, settled).run();
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
