// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/coincident.h"

#include "libpolymesh/base/disjointSets.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/trim/chains.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace polymesh {

namespace {

/// Where a mesh edge and a surface edge cross each other exactly.
struct EdgeMeeting {
    Label meshEdge;
    Label surfaceEdge;
    Label point;
};

class Coincidence {
public:
    Coincidence(const Probe& probe, const CuttingSurface& cutter, const Arrangement& arrangement)
        : probe_(probe),
          cutter_(cutter),
          arrangement_(arrangement),
          sets_(arrangement.firstVertex() + cutter.surface->pointCount()),
          nodeOf_(cutter.surface->points.size(), -1) {}

    std::vector<Label> run(std::span<const std::array<Label, 2>> joined) {
        for (Label e = 0; e < probe_.edgeCount(); ++e)
            for (Label x = arrangement_.crossings.offsets[index(e)];
                 x < arrangement_.crossings.offsets[index(e) + 1];
                 ++x)
                if (arrangement_.crossings.values[index(x)].zeros != 0) classifyCrossing(e, x);
        for (Label x = 0; x < arrangement_.pierceCount(); ++x)
            if (arrangement_.pierces.values[index(x)].zeros != 0) classifyPierce(x);
        parallelFor(cutter_.surface->pointCount(), [&](Label v) { joinNode(v); });
        joinMeetings();
        for (const auto& [a, b] : joined)
            sets_.join(a, b);
        return standIns();
    }

private:
    /// For each point the one that stands for its set: the lowest, which is a node if there is
    /// one, unless that is a crossing or a pierce and the set has a surface point.
    std::vector<Label> standIns() {
        std::vector<Label> lowest = std::move(sets_).lowestOfEach();
        std::vector<Label> standIn = lowest; // for each lowest point
        for (Label v = toLabel(lowest.size()) - 1; v >= arrangement_.firstVertex(); --v)
            if (!arrangement_.isNode(lowest[index(v)])) standIn[index(lowest[index(v)])] = v;
        parallelFor(toLabel(lowest.size()), [&](Label p) {
            Label& point = lowest[index(p)];
            point = standIn[index(point)];
        });
        return lowest;
    }

    Label vertex(Label v) const { return arrangement_.firstVertex() + v; }

    /// The first of the records that an edge with more than two triangles has.
    Label firstRecord(Label edge) const {
        const auto& edges = cutter_.edges.edges;
        while (edge > 0 && edges[index(edge) - 1].start == edges[index(edge)].start &&
               edges[index(edge) - 1].end == edges[index(edge)].end)
            --edge;
        return edge;
    }

    void classifyCrossing(Label e, Label x) {
        const EdgeCrossing& crossing = arrangement_.crossings.values[index(x)];
        const Label point = arrangement_.firstCrossing() + x;
        if ((crossing.zeros & 3) != 0) {
            sets_.join(point, probe_.edges[index(e)][(crossing.zeros & 1) != 0 ? 0 : 1]);
            return;
        }
        const unsigned sides = crossing.zeros >> 2U;
        const auto& corners = cutter_.surface->triangles[index(crossing.triangle)];
        if (std::popcount(sides) == 1) {
            const auto side = static_cast<std::size_t>(std::countr_zero(sides));
            const Label s = cutter_.edges.ofTriangle[index(crossing.triangle)][side];
            meetings_.push_back({e, firstRecord(s), point});
        } else if ((sides & 3) == 3) {
            sets_.join(point, vertex(corners[1]));
        } else if ((sides & 6) == 6) {
            sets_.join(point, vertex(corners[2]));
        } else {
            sets_.join(point, vertex(corners[0]));
        }
    }

    bool isOnEdge(Label node, const SurfaceEdge& edge) const {
        const Vec3& p = cutter_.surface->points[index(edge.start)];
        const Vec3& q = cutter_.surface->points[index(edge.end)];
        for (int axis = 0; axis < 3; ++axis)
            if (normalSign(p, q, probe_.nodePoints[index(node)], axis) != 0) return false;
        return true;
    }

    void classifyPierce(Label x) {
        const FacePierce& pierce = arrangement_.pierces.values[index(x)];
        const SurfaceEdge& edge = cutter_.edges.edges[index(pierce.edge)];
        const Label point = arrangement_.firstPierce() + x;
        const bool isAtEnd = (pierce.zeros & 3) != 0;
        if (isAtEnd) sets_.join(point, vertex((pierce.zeros & 1) != 0 ? edge.start : edge.end));
        const std::uint32_t sides = pierce.zeros >> 2U;
        if (sides == 0) return;
        const auto nodes = probe_.facetNodes[pierce.facet];
        if (std::popcount(sides) > 1)
            for (const Label n : nodes)
                if (isOnEdge(n, edge)) {
                    sets_.join(point, n);
                    return;
                }
        if (!isAtEnd)
            meetings_.push_back({meetingEdge(pierce, sides), firstRecord(pierce.edge), point});
    }

    /// The facet's edge on which the pierce lies; of collinear ones, the one that holds it.
    Label meetingEdge(const FacePierce& pierce, std::uint32_t sides) const {
        const Label first = probe_.facetNodes.offsets[index(pierce.facet)];
        if (std::popcount(sides) == 1)
            return probe_.facetEdges[index(first + std::countr_zero(sides))];
        const SurfaceEdge& edge = cutter_.edges.edges[index(pierce.edge)];
        const Vec3& p = cutter_.surface->points[index(edge.start)];
        const Vec3& q = cutter_.surface->points[index(edge.end)];
        Label best = -1;
        double bestDistance = Box::inf;
        for (Label i = 0; i < probe_.facetNodes.rowSize(pierce.facet); ++i) {
            if (((sides >> static_cast<unsigned>(std::min<Label>(i, 29))) & 1U) == 0) continue;
            const Label e = probe_.facetEdges[index(first + i)];
            const Vec3& a = probe_.nodePoints[index(probe_.edges[index(e)][0])];
            const Vec3& b = probe_.nodePoints[index(probe_.edges[index(e)][1])];
            const double distance = distanceToSegment(0.5 * (a + b), p, q) / norm(b - a);
            if (distance < bestDistance) {
                bestDistance = distance;
                best = e;
            }
        }
        return best;
    }

    /// A surface point that is a node without any edge to tell so: both are in the same cell.
    void joinNode(Label v) {
        const Label cell = arrangement_.vertexCell[index(v)];
        if (cell < 0) return;
        const Vec3& p = cutter_.surface->points[index(v)];
        for (const Label f : probe_.cellFaces[cell])
            for (const Label n : probe_.faceNodes[f])
                if (probe_.nodePoints[index(n)] == p) nodeOf_[index(v)] = n;
    }

    void joinMeetings() {
        for (std::size_t v = 0; v < nodeOf_.size(); ++v)
            if (nodeOf_[v] >= 0) sets_.join(vertex(toLabel(v)), nodeOf_[v]);
        std::ranges::sort(meetings_, [](const EdgeMeeting& a, const EdgeMeeting& b) {
            return a.meshEdge != b.meshEdge ? a.meshEdge < b.meshEdge
                                            : a.surfaceEdge < b.surfaceEdge;
        });
        for (std::size_t i = 1; i < meetings_.size(); ++i)
            if (meetings_[i].meshEdge == meetings_[i - 1].meshEdge &&
                meetings_[i].surfaceEdge == meetings_[i - 1].surfaceEdge)
                sets_.join(meetings_[i - 1].point, meetings_[i].point);
    }

    const Probe& probe_;
    const CuttingSurface& cutter_;
    const Arrangement& arrangement_;
    DisjointSets sets_;         // of points that are one
    std::vector<Label> nodeOf_; // surface point -> node at the same place, or -1
    std::vector<EdgeMeeting> meetings_;
};

} // namespace

std::vector<Label> mergeCoincident(const Probe& probe,
                                   const CuttingSurface& cutter,
                                   const Arrangement& arrangement,
                                   std::span<const std::array<Label, 2>> joined) {
    return Coincidence(probe, cutter, arrangement).run(joined);
}

} // namespace polymesh
