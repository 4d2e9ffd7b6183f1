// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trimCell/cellSites.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/trimCell/meetings.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace polymesh {

namespace {

[[noreturn]] void refuse(const char* what, const Vec3& p) {
    throw WorkError(fmt::format("{} at ({} {} {})", what, p.x, p.y, p.z));
}

void keepEachOnce(std::vector<Label>& labels) {
    std::ranges::sort(labels);
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
}

class SiteFinder {
public:
    SiteFinder(const CellInputs& inputs, Label cell)
        : probe_(inputs.probe),
          surface_(inputs.surface),
          cutter_(inputs.surface.cutter()),
          shift_(inputs.shift) {
        sites_.cell = cell;
    }

    CellSites run() {
        listFacets();
        pairEdgesOfCell();
        surface_.findNear(box_, sites_.triangles);
        listSurfaceEdges();
        crossEdgesOfCell();
        windNodesOfCell();
        pierceFacetsOfCell();
        findVertices();
        return std::move(sites_);
    }

private:
    const Vec3& at(Label node) const { return probe_.nodePoints[index(node)]; }

    const std::vector<Vec3>& polygonOf(Label facet) {
        polygon_.clear();
        for (const Label n : probe_.facetNodes[facet])
            polygon_.push_back(at(n));
        return polygon_;
    }

    void listFacets() {
        for (const Label f : probe_.cellFaces[sites_.cell])
            for (Label k = probe_.facetOffsets[index(f)]; k < probe_.facetOffsets[index(f) + 1];
                 ++k) {
                const bool isTurned = probe_.faceCells[index(f)][0] != sites_.cell;
                sites_.facets.push_back({k, f, isTurned});
                for (const Vec3& p : polygonOf(k))
                    box_.add(p);
            }
    }

    /// Lists the cell's edges; each must be used once in either direction.
    void pairEdgesOfCell() {
        std::vector<CellEdge> uses;
        for (std::size_t i = 0; i < sites_.facets.size(); ++i) {
            const CellFacet& facet = sites_.facets[i];
            const auto nodes = probe_.facetNodes[facet.facet];
            const Label first = probe_.facetNodes.offsets[index(facet.facet)];
            for (std::size_t k = 0; k < nodes.size(); ++k) {
                const Label e = probe_.facetEdges[index(first) + k];
                const bool isForward = (probe_.edges[index(e)][0] == nodes[k]) != facet.isTurned;
                uses.push_back({e, isForward ? toLabel(i) : -1, isForward ? -1 : toLabel(i)});
            }
        }
        std::ranges::stable_sort(uses, {}, &CellEdge::edge);
        for (std::size_t i = 0; i < uses.size(); i += 2) {
            const bool isPair = i + 1 < uses.size() && uses[i].edge == uses[i + 1].edge &&
                                (uses[i].forward < 0) != (uses[i + 1].forward < 0) &&
                                (i + 2 == uses.size() || uses[i + 2].edge != uses[i].edge);
            if (!isPair)
                refuse("a mesh cell with an edge that has not two faces",
                       at(probe_.edges[index(uses[i].edge)][0]));
            sites_.edges.push_back({uses[i].edge,
                                    std::max(uses[i].forward, uses[i + 1].forward),
                                    std::max(uses[i].backward, uses[i + 1].backward)});
        }
    }

    void listSurfaceEdges() {
        for (const Label t : sites_.triangles)
            for (const Label e : cutter_.edges.ofTriangle[index(t)])
                sites_.surfaceEdges.push_back(e);
        keepEachOnce(sites_.surfaceEdges);
    }

    void crossEdgesOfCell() {
        std::vector<EdgeCrossing> found;
        for (const CellEdge& use : sites_.edges) {
            const Vec3& low = at(probe_.edges[index(use.edge)][0]);
            const Vec3& high = at(probe_.edges[index(use.edge)][1]);
            Box box;
            box.add(low);
            box.add(high);
            found.clear();
            for (const Label t : sites_.triangles) {
                if (!overlaps(cutter_.triangleBoxes[index(t)], box)) continue;
                if (auto crossing = meetTriangle(low, high, cutter_.triangle(t))) {
                    crossing->triangle = t;
                    found.push_back(*crossing);
                }
            }
            // Crossings of triangles in one plane keep the order of their triangles.
            std::ranges::stable_sort(found, [&](const EdgeCrossing& s, const EdgeCrossing& t) {
                return compareAlongMeshEdge(
                           low, high, cutter_.triangle(s.triangle), cutter_.triangle(t.triangle)) <
                       0;
            });
            sites_.crossings.add(found);
        }
    }

    /// The side of every node by its own rays; crossings have to agree.
    void windNodesOfCell() {
        std::vector<Label> nodes;
        for (const CellEdge& use : sites_.edges)
            for (const Label n : probe_.edges[index(use.edge)])
                nodes.push_back(n);
        keepEachOnce(nodes);
        for (const Label n : nodes)
            sites_.nodes.push_back({n, surface_.windingOf(at(n)) + shift_});
        for (std::size_t i = 0; i < sites_.edges.size(); ++i) {
            const auto& [low, high] = probe_.edges[index(sites_.edges[i].edge)];
            int winding = windingAt(low);
            for (const EdgeCrossing& crossing : sites_.crossings[toLabel(i)])
                winding += crossing.sign;
            if (winding != windingAt(high))
                refuse("rays and crossings disagree about inside and outside", at(low));
        }
    }

    int windingAt(Label node) const {
        return std::ranges::lower_bound(sites_.nodes, node, {}, &NodeWinding::node)->winding;
    }

    void pierceFacetsOfCell() {
        std::vector<FacePierce> found;
        for (const CellFacet& facet : sites_.facets) {
            const std::vector<Vec3>& polygon = polygonOf(facet.facet);
            const Box box = boundingBox(polygon);
            found.clear();
            for (const Label e : sites_.surfaceEdges) {
                const auto& [p, q] = endsOf(e);
                Box ofEdge;
                ofEdge.add(p);
                ofEdge.add(q);
                if (!overlaps(ofEdge, box)) continue;
                if (auto pierce = meetFacet(polygon, p, q)) {
                    pierce->facet = facet.facet;
                    pierce->edge = e;
                    found.push_back(*pierce);
                }
            }
            sites_.pierces.add(found);
        }
    }

    std::array<Vec3, 2> endsOf(Label surfaceEdge) const {
        const SurfaceEdge& edge = cutter_.edges.edges[index(surfaceEdge)];
        return {cutter_.surface->points[index(edge.start)],
                cutter_.surface->points[index(edge.end)]};
    }

    void findVertices() {
        std::vector<Label> near;
        for (const Label t : sites_.triangles)
            for (const Label v : cutter_.surface->triangles[index(t)])
                if (box_.contains(cutter_.surface->points[index(v)])) near.push_back(v);
        keepEachOnce(near);
        for (const Label v : near)
            if (isInCell(cutter_.surface->points[index(v)])) sites_.vertices.push_back(v);
    }

    /// Whether the moved surface point lies in the cell: what a ray along x leaves and enters.
    bool isInCell(const Vec3& p) {
        const Vec3 far{box_.max.x + std::abs(box_.max.x) + 1, p.y, p.z};
        int ways = 0;
        for (const CellFacet& facet : sites_.facets) {
            const std::vector<Vec3>& polygon = polygonOf(facet.facet);
            // A face that the surface does not come near need not be plane: by triangles it is one
            // surface with one outline all the same, and that is all that a ray asks for.
            for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
                const std::array<Vec3, 3> triangle{polygon[0], polygon[i], polygon[i + 1]};
                if (const auto way = meetFacet(triangle, p, far))
                    ways += facet.isTurned ? -way->sign : way->sign;
            }
        }
        if (ways != 0 && ways != 1) refuse("a mesh cell that overlaps itself", p);
        return ways == 1;
    }

    const Probe& probe_;
    const SearchedSurface& surface_;
    const CuttingSurface& cutter_;
    int shift_;
    CellSites sites_;
    Box box_;
    std::vector<Vec3> polygon_;
};

} // namespace

CellSites findSites(const CellInputs& inputs, Label cell) {
    return SiteFinder(inputs, cell).run();
}

} // namespace polymesh
