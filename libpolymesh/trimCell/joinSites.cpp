// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trimCell/joinSites.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/trimCell/meetings.h"

#include <algorithm>
#include <tuple>

namespace polymesh {

namespace {

bool isSame(const EdgeCrossing& a, const EdgeCrossing& b) {
    return a.triangle == b.triangle && a.sign == b.sign && a.zeros == b.zeros;
}

bool isSame(const FacePierce& a, const FacePierce& b) {
    return a.edge == b.edge && a.facet == b.facet && a.sign == b.sign && a.zeros == b.zeros;
}

/// Where a pierce comes in its facet: by the triangle that uses its edge forwards, then by side.
std::pair<Label, std::ptrdiff_t> orderInFacet(const CuttingSurface& cutter, Label surfaceEdge) {
    const Label left = cutter.edges.edges[index(surfaceEdge)].left;
    const auto& sides = cutter.edges.ofTriangle[index(left)];
    return {left, std::ranges::find(sides, surfaceEdge) - sides.begin()};
}

/// Turns the sizes in offsets[1 ...] into offsets, and makes room for the values.
template<class T>
void makeRoom(Rows<T>& rows) {
    for (std::size_t i = 1; i < rows.offsets.size(); ++i)
        rows.offsets[i] += rows.offsets[i - 1];
    rows.values.resize(index(rows.offsets.back()));
}

class SiteJoiner {
public:
    explicit SiteJoiner(const JoinInputs& inputs)
        : probe_(inputs.probe), cutter_(inputs.cutter), cuts_(inputs.cuts) {}

    Arrangement run() {
        joined_.nodeCount = probe_.nodeCount();
        joinCrossings();
        joinNodes();
        joinPierces();
        orderPierces();
        joinVertices();
        return std::move(joined_);
    }

private:
    template<class Use>
    void forEdges(Use&& use) const { // (cell, edge, its crossings)
        for (const CellCut& cut : cuts_)
            for (Label i = 0; i < cut.sites.crossings.size(); ++i)
                use(cut.sites.cell, cut.sites.edges[index(i)].edge, cut.sites.crossings[i]);
    }

    /// One cell of each edge says what the others have to agree to.
    void joinCrossings() {
        joined_.crossings.offsets.assign(index(probe_.edgeCount()) + 1, 0);
        const auto isSpeaker = [&](Label cell, Label e) {
            return probe_.edgeCell[index(e)] == cell;
        };
        forEdges([&](Label cell, Label e, const auto& row) {
            if (isSpeaker(cell, e)) joined_.crossings.offsets[index(e) + 1] = toLabel(row.size());
        });
        makeRoom(joined_.crossings);
        forEdges([&](Label cell, Label e, const auto& row) {
            if (isSpeaker(cell, e)) std::ranges::copy(row, joined_.crossings[e].begin());
        });
        forEdges([&](Label, Label e, const auto& row) {
            const auto known = joined_.crossings[e];
            if (!std::ranges::equal(
                    row, known, [](const auto& a, const auto& b) { return isSame(a, b); }))
                refuseDifference("a mesh edge",
                                 probe_.nodePoints[index(probe_.edges[index(e)][0])]);
        });
    }

    void joinNodes() {
        joined_.winding.assign(index(probe_.nodeCount()), 0);
        std::vector<std::uint8_t> isKnown(index(probe_.nodeCount()), 0);
        for (const CellCut& cut : cuts_)
            for (const auto& [node, winding] : cut.sites.nodes) {
                auto& known = joined_.winding[index(node)];
                if (isKnown[index(node)] != 0 && known != winding)
                    refuseDifference("a node", probe_.nodePoints[index(node)]);
                known = static_cast<std::int8_t>(winding);
                isKnown[index(node)] = 1;
            }
    }

    template<class Use>
    void forFacets(Use&& use) const { // (facet, its pierces, whether the cell speaks for it)
        std::vector<FacePierce> row;
        for (const CellCut& cut : cuts_)
            for (Label i = 0; i < cut.sites.pierces.size(); ++i) {
                const CellFacet& facet = cut.sites.facets[index(i)];
                const auto found = cut.sites.pierces[i];
                row.assign(found.begin(), found.end());
                std::ranges::sort(row, {}, [&](const FacePierce& pierce) {
                    return orderInFacet(cutter_, pierce.edge);
                });
                const Label owner = probe_.faceCells[index(facet.face)][0];
                use(facet.facet, row, owner < 0 || owner == cut.sites.cell);
            }
    }

    void joinPierces() {
        joined_.pierces.offsets.assign(index(probe_.facetCount()) + 1, 0);
        forFacets([&](Label k, const auto& row, bool isSpeaker) {
            if (isSpeaker) joined_.pierces.offsets[index(k) + 1] = toLabel(row.size());
        });
        makeRoom(joined_.pierces);
        forFacets([&](Label k, const auto& row, bool isSpeaker) {
            if (isSpeaker) std::ranges::copy(row, joined_.pierces[k].begin());
        });
        forFacets([&](Label k, const auto& row, bool) {
            if (!std::ranges::equal(row, joined_.pierces[k], [](const auto& a, const auto& b) {
                    return isSame(a, b);
                }))
                refuseDifference("a mesh face", probe_.nodePoints[index(probe_.facetNodes[k][0])]);
        });
    }

    std::array<Vec3, 3> planeOfPierce(Label pierce) const {
        std::vector<Vec3> polygon;
        for (const Label n : probe_.facetNodes[joined_.pierces.values[index(pierce)].facet])
            polygon.push_back(probe_.nodePoints[index(n)]);
        return planeOf(polygon);
    }

    void orderPierces() {
        auto& rows = joined_.surfacePierces;
        rows.offsets.assign(cutter_.edges.edges.size() + 1, 0);
        for (const FacePierce& pierce : joined_.pierces.values)
            ++rows.offsets[index(pierce.edge) + 1];
        makeRoom(rows);
        std::vector<Label> next(rows.offsets.begin(), rows.offsets.end() - 1);
        for (Label x = 0; x < joined_.pierceCount(); ++x)
            rows.values[index(next[index(joined_.pierces.values[index(x)].edge)]++)] = x;
        joined_.pierceRank.resize(rows.values.size());
        parallelFor(rows.size(), [&](Label e) {
            const auto row = rows[e];
            const SurfaceEdge& edge = cutter_.edges.edges[index(e)];
            const Vec3& p = cutter_.surface->points[index(edge.start)];
            const Vec3& q = cutter_.surface->points[index(edge.end)];
            std::ranges::stable_sort(row, [&](Label x, Label y) {
                return compareAlongSurfaceEdge(p, q, planeOfPierce(x), planeOfPierce(y)) < 0;
            });
            for (std::size_t i = 0; i < row.size(); ++i)
                joined_.pierceRank[index(row[i])] = toLabel(i);
        });
    }

    void joinVertices() {
        joined_.vertexCell.assign(cutter_.surface->points.size(), -1);
        for (const CellCut& cut : cuts_)
            for (const Label v : cut.sites.vertices) {
                Label& cell = joined_.vertexCell[index(v)];
                if (cell >= 0)
                    refuseDifference("a point of the surface", cutter_.surface->points[index(v)]);
                cell = cut.sites.cell;
            }
    }

    const Probe& probe_;
    const CuttingSurface& cutter_;
    std::span<const CellCut> cuts_;
    Arrangement joined_;
};

} // namespace

Arrangement joinSites(const JoinInputs& inputs) {
    return SiteJoiner(inputs).run();
}

Label labelOf(const JoinInputs& inputs, const Arrangement& arrangement, const PointName& point) {
    switch (point.kind) {
    case PointName::Kind::node:
        return point.first;
    case PointName::Kind::vertex:
        return arrangement.firstVertex() + point.first;
    case PointName::Kind::crossing: {
        const auto row = arrangement.crossings[point.first];
        const auto found = std::ranges::find(row, point.second, &EdgeCrossing::triangle);
        return arrangement.firstCrossing() + arrangement.crossings.offsets[index(point.first)] +
               toLabel(static_cast<std::size_t>(found - row.begin()));
    }
    default: {
        const auto order = [&](Label e) { return orderInFacet(inputs.cutter, e); };
        const auto row = arrangement.pierces[point.first];
        const auto found =
            std::ranges::lower_bound(row, order(point.second), {}, [&](const FacePierce& pierce) {
                return order(pierce.edge);
            });
        return arrangement.firstPierce() + arrangement.pierces.offsets[index(point.first)] +
               toLabel(static_cast<std::size_t>(found - row.begin()));
    }
    }
}

void refuseDifference(const char* about, const Vec3& place) {
    throw WorkError(fmt::format("two cells disagree about {} at ({} {} {}): the mesh overlaps "
                                "itself there (checkMesh tells); else please report this surface "
                                "and mesh",
                                about,
                                place.x,
                                place.y,
                                place.z));
}

} // namespace polymesh
