// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trimCell/cellGraph.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/trimCell/meetings.h"

#include <algorithm>

namespace polymesh {

namespace {

using Kind = PointName::Kind;

bool isInside(int winding) {
    return winding >= 1;
}

class GraphBuilder {
public:
    GraphBuilder(const CellInputs& inputs,
                 const CellSites& sites,
                 const std::vector<std::uint8_t>& isByFacets)
        : inputs_(inputs),
          probe_(inputs.probe),
          cutter_(inputs.surface.cutter()),
          sites_(sites),
          isByFacets_(isByFacets) {}

    CellGraph run() {
        listCarriers();
        for (std::size_t i = 0; i < sites_.edges.size(); ++i)
            addOutlines(i);
        for (std::size_t i = 0; i < sites_.facets.size(); ++i)
            addSegments(i);
        listPierces();
        for (const Label e : sites_.surfaceEdges)
            addSurfaceEdge(e);
        return std::move(graph_);
    }

private:
    void listCarriers() {
        for (std::size_t i = 0; i < sites_.facets.size(); ++i) {
            const CellFacet& facet = sites_.facets[i];
            const bool isSame =
                i > 0 && isByFacets_[i] == 0 && sites_.facets[i - 1].face == facet.face;
            if (!isSame)
                graph_.carriers.push_back({facet.face, isByFacets_[i] != 0 ? facet.facet : -1, -1});
            carrierOfFacet_.push_back(toLabel(graph_.carriers.size()) - 1);
        }
        firstTriangle_ = toLabel(graph_.carriers.size());
        for (const Label t : sites_.triangles)
            graph_.carriers.push_back({-1, -1, t});
    }

    Label carrierOf(Label triangle) const {
        const auto found = std::ranges::lower_bound(sites_.triangles, triangle);
        if (found == sites_.triangles.end() || *found != triangle) return -1;
        return firstTriangle_ + toLabel(static_cast<std::size_t>(found - sites_.triangles.begin()));
    }

    int windingAt(Label node) const {
        return std::ranges::lower_bound(sites_.nodes, node, {}, &NodeWinding::node)->winding;
    }

    /// Adds the parts of an edge of the cell that are inside the surface (the paper's part 2).
    void addOutlines(std::size_t i) {
        const CellEdge& use = sites_.edges[i];
        const std::array<Label, 2> carriers{carrierOfFacet_[index(use.forward)],
                                            carrierOfFacet_[index(use.backward)]};
        if (carriers[0] == carriers[1]) return; // within a face
        const auto& [low, high] = probe_.edges[index(use.edge)];
        int winding = windingAt(low);
        PointName from{Kind::node, low, -1};
        const auto add = [&](const PointName& to) {
            graph_.edges.push_back({GraphEdge::Kind::outline, {from, to}, carriers, use.edge});
        };
        for (const EdgeCrossing& crossing : sites_.crossings[toLabel(i)]) {
            const bool wasInside = isInside(winding);
            winding += crossing.sign;
            if (wasInside == isInside(winding)) continue; // where parts of the surface overlap
            const PointName point{Kind::crossing, use.edge, crossing.triangle};
            if (wasInside) add(point);
            from = point;
        }
        if (isInside(winding)) add({Kind::node, high, -1});
    }

    struct SegmentEnd {
        Label triangle;
        PointName point;
    };

    /// Adds the lines in which a facet meets the triangles (the paper's part 1).
    void addSegments(std::size_t i) {
        std::vector<SegmentEnd> ends;
        const Label facet = sites_.facets[i].facet;
        const Label first = probe_.facetNodes.offsets[index(facet)];
        for (Label k = 0; k < probe_.facetNodes.rowSize(facet); ++k) {
            const Label e = probe_.facetEdges[index(first + k)];
            for (const EdgeCrossing& crossing : crossingsOf(e))
                ends.push_back({crossing.triangle, {Kind::crossing, e, crossing.triangle}});
        }
        for (const FacePierce& pierce : sites_.pierces[toLabel(i)]) {
            const SurfaceEdge& edge = cutter_.edges.edges[index(pierce.edge)];
            for (const Label t : {edge.left, edge.right})
                ends.push_back({t, {Kind::pierce, facet, pierce.edge}});
        }
        std::ranges::stable_sort(ends, {}, &SegmentEnd::triangle);
        for (std::size_t k = 0; k < ends.size(); k += 2) {
            if (k + 1 == ends.size() || ends[k].triangle != ends[k + 1].triangle)
                refuseSurfaceAt(inputs_, ends[k].point);
            graph_.edges.push_back({GraphEdge::Kind::segment,
                                    {ends[k].point, ends[k + 1].point},
                                    {carrierOfFacet_[i], carrierOf(ends[k].triangle)},
                                    facet});
        }
    }

    std::span<const EdgeCrossing> crossingsOf(Label edge) const {
        const auto found = std::ranges::lower_bound(sites_.edges, edge, {}, &CellEdge::edge);
        return sites_.crossings[toLabel(static_cast<std::size_t>(found - sites_.edges.begin()))];
    }

    /// Sorts the cell's pierces by surface edge.
    void listPierces() {
        for (const FacePierce& pierce : sites_.pierces.values)
            pierces_.push_back(pierce);
        std::ranges::stable_sort(pierces_, {}, &FacePierce::edge);
    }

    std::array<Vec3, 3> planeOfFacet(Label facet) const {
        std::vector<Vec3> polygon;
        for (const Label n : probe_.facetNodes[facet])
            polygon.push_back(probe_.nodePoints[index(n)]);
        return planeOf(polygon);
    }

    bool isVertexInside(Label v) const { return std::ranges::binary_search(sites_.vertices, v); }

    /// Adds the parts of a surface edge that are inside the cell (the paper's part 3).
    void addSurfaceEdge(Label e) {
        const SurfaceEdge& edge = cutter_.edges.edges[index(e)];
        const std::span<FacePierce> row(
            std::ranges::lower_bound(pierces_, e, {}, &FacePierce::edge),
            std::ranges::upper_bound(pierces_, e, {}, &FacePierce::edge));
        if (row.size() > 1) {
            const Vec3& p = cutter_.surface->points[index(edge.start)];
            const Vec3& q = cutter_.surface->points[index(edge.end)];
            std::ranges::stable_sort(row, [&](const FacePierce& f, const FacePierce& g) {
                return compareAlongSurfaceEdge(p, q, planeOfFacet(f.facet), planeOfFacet(g.facet)) <
                       0;
            });
        }
        bool isIn = isVertexInside(edge.start);
        PointName from{Kind::vertex, edge.start, -1};
        const auto add = [&](const PointName& to) {
            graph_.edges.push_back({GraphEdge::Kind::surface,
                                    {from, to},
                                    {carrierOf(edge.left), carrierOf(edge.right)},
                                    e});
        };
        for (const FacePierce& pierce : row) {
            const PointName point{Kind::pierce, pierce.facet, e};
            if (isIn) add(point);
            isIn = !isIn;
            from = point;
        }
        const PointName end{Kind::vertex, edge.end, -1};
        if (isIn) add(end);
        if (isIn != isVertexInside(edge.end)) refuseSurfaceAt(inputs_, end);
    }

    const CellInputs& inputs_;
    const Probe& probe_;
    const CuttingSurface& cutter_;
    const CellSites& sites_;
    const std::vector<std::uint8_t>& isByFacets_;
    std::vector<Label> carrierOfFacet_; // beside the facets of the sites
    Label firstTriangle_ = 0;           // carrier of the first triangle
    std::vector<FacePierce> pierces_;
    CellGraph graph_;
};

} // namespace

CellGraph buildGraph(const CellInputs& inputs,
                     const CellSites& sites,
                     const std::vector<std::uint8_t>& isByFacets) {
    return GraphBuilder(inputs, sites, isByFacets).run();
}

Vec3 placeOf(const CellInputs& inputs, const PointName& point) {
    const CuttingSurface& cutter = inputs.surface.cutter();
    const auto& points = cutter.surface->points;
    switch (point.kind) {
    case Kind::node:
        return inputs.probe.nodePoints[index(point.first)];
    case Kind::crossing:
        return inputs.probe.nodePoints[index(inputs.probe.edges[index(point.first)][0])];
    case Kind::pierce:
        return points[index(cutter.edges.edges[index(point.second)].start)];
    default:
        return points[index(point.first)];
    }
}

void refuseSurfaceAt(const CellInputs& inputs, const PointName& point) {
    const Vec3 p = placeOf(inputs, point);
    throw InputError(fmt::format(
        "the surface intersects itself near ({} {} {}), or the mesh overlaps itself there, so that "
        "inside and outside are not defined; repair the surface (unite overlapping parts) and try "
        "again, or the mesh (checkMesh tells)",
        p.x,
        p.y,
        p.z));
}

} // namespace polymesh
