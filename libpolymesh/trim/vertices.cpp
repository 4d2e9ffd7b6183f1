// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/trim/arrangement.h"

#include <algorithm>

namespace polymesh {

namespace {

std::array<Vec3, 3> facetPlane(const Probe& probe, Label facet) {
    const auto nodes = probe.facetNodes[facet];
    const auto at = [&](std::size_t i) { return probe.nodePoints[index(nodes[i])]; };
    for (std::size_t i = 2; i < nodes.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            if (normalSign(at(0), at(1), at(i), axis) != 0) return {at(0), at(1), at(i)};
    return {at(0), at(1), at(2)};
}

void orderPierces(const Probe& probe, const CuttingSurface& cutter, Arrangement& arrangement) {
    const auto& pierces = arrangement.pierces.values;
    auto& rows = arrangement.surfacePierces;
    rows.offsets.assign(cutter.edges.edges.size() + 1, 0);
    for (const FacePierce& pierce : pierces)
        ++rows.offsets[index(pierce.edge) + 1];
    for (std::size_t e = 1; e < rows.offsets.size(); ++e)
        rows.offsets[e] += rows.offsets[e - 1];
    rows.values.resize(pierces.size());
    std::vector<Label> next(rows.offsets.begin(), rows.offsets.end() - 1);
    for (std::size_t i = 0; i < pierces.size(); ++i)
        rows.values[index(next[index(pierces[i].edge)]++)] = toLabel(i);
    arrangement.pierceRank.resize(pierces.size());
    parallelFor(rows.size(), [&](Label e) {
        const auto row = rows[e];
        if (row.size() > 1) {
            const SurfaceEdge& edge = cutter.edges.edges[index(e)];
            const Vec3& p = cutter.surface->points[index(edge.start)];
            const Vec3& q = cutter.surface->points[index(edge.end)];
            std::ranges::sort(row, [&](Label i, Label j) {
                const int order =
                    compareAlongSurfaceEdge(p,
                                            q,
                                            facetPlane(probe, pierces[index(i)].facet),
                                            facetPlane(probe, pierces[index(j)].facet));
                return order != 0 ? order < 0 : i < j;
            });
        }
        for (std::size_t i = 0; i < row.size(); ++i)
            arrangement.pierceRank[index(row[i])] = toLabel(i);
    });
}

/// The cell before (end 0) or after (end 1) a pierce, when going from the edge's start.
Label cellBeside(const Probe& probe, const FacePierce& pierce, int end) {
    const auto& cells = probe.faceCells[index(probe.facetFace[index(pierce.facet)])];
    return cells[(pierce.sign > 0) == (end == 0) ? 0 : 1];
}

constexpr Label unknown = -2;

/// Gives each surface point with a pierced edge its cell. Throws where two edges disagree.
void locateFromPierces(const Probe& probe, const CuttingSurface& cutter, Arrangement& arrangement) {
    const auto set = [&](Label vertex, Label cell) {
        Label& known = arrangement.vertexCell[index(vertex)];
        if (known != unknown && known != cell) {
            const Vec3& p = cutter.surface->points[index(vertex)];
            throw WorkError(
                fmt::format("the surface point ({} {} {}) seems to be in two cells: the "
                            "mesh overlaps itself there; check it with checkMesh",
                            p.x,
                            p.y,
                            p.z));
        }
        known = cell;
    };
    for (Label e = 0; e < arrangement.surfacePierces.size(); ++e) {
        const auto row = arrangement.surfacePierces[e];
        if (row.empty()) continue;
        const SurfaceEdge& edge = cutter.edges.edges[index(e)];
        set(edge.start, cellBeside(probe, arrangement.pierces.values[index(row.front())], 0));
        set(edge.end, cellBeside(probe, arrangement.pierces.values[index(row.back())], 1));
    }
}

/// Whether the line between the moved surface points p and q passes through a triangle of the mesh.
bool passesThrough(const std::array<Vec3, 3>& triangle, const Vec3& p, const Vec3& q) {
    if (sideOfMeshPlane(triangle, p).sign == sideOfMeshPlane(triangle, q).sign) return false;
    const int side = passingSide(triangle[0], triangle[1], p, q).sign;
    return passingSide(triangle[1], triangle[2], p, q).sign == side &&
           passingSide(triangle[2], triangle[0], p, q).sign == side;
}

/// Whether the moved surface point lies in the cell: parity of its facets along a ray. A facet that
/// the surface does not come near need not be plane, but any triangles of it do: they have the same
/// outline, and the point is not between them.
bool isInCell(const Probe& probe, Label cell, const Vec3& p, double far) {
    const Vec3 q{far, p.y, p.z};
    bool isInside = false;
    for (const Label f : probe.cellFaces[cell])
        for (Label k = probe.facetOffsets[index(f)]; k < probe.facetOffsets[index(f) + 1]; ++k) {
            const auto nodes = probe.facetNodes[k];
            const auto at = [&](std::size_t i) { return probe.nodePoints[index(nodes[i])]; };
            for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
                if (passesThrough({at(0), at(i), at(i + 1)}, p, q)) isInside = !isInside;
        }
    return isInside;
}

/// The cell of a surface point none of whose connected points has a pierced edge.
Label searchCell(const Probe& probe, Label triangle, const Vec3& p, double far) {
    for (Label c = 0; c < probe.cellCount(); ++c)
        if (std::ranges::binary_search(probe.triangles[c], triangle) && isInCell(probe, c, p, far))
            return c;
    return -1;
}

/// Carries cells over edges without pierces.
void spread(const CuttingSurface& cutter,
            const Arrangement& arrangement,
            std::vector<Label>& front,
            const Rows<Label>& edgesOf,
            std::vector<Label>& vertexCell) {
    while (!front.empty()) {
        const Label v = front.back();
        front.pop_back();
        for (const Label e : edgesOf[v]) {
            if (arrangement.surfacePierces.rowSize(e) != 0) continue;
            const SurfaceEdge& edge = cutter.edges.edges[index(e)];
            const Label other = edge.start == v ? edge.end : edge.start;
            if (vertexCell[index(other)] != unknown) continue;
            vertexCell[index(other)] = vertexCell[index(v)];
            front.push_back(other);
        }
    }
}

Rows<Label> edgesOfPoints(const CuttingSurface& cutter) {
    Rows<Label> rows;
    rows.offsets.assign(cutter.surface->points.size() + 1, 0);
    for (const SurfaceEdge& edge : cutter.edges.edges) {
        ++rows.offsets[index(edge.start) + 1];
        ++rows.offsets[index(edge.end) + 1];
    }
    for (std::size_t v = 1; v < rows.offsets.size(); ++v)
        rows.offsets[v] += rows.offsets[v - 1];
    rows.values.resize(index(rows.offsets.back()));
    std::vector<Label> next(rows.offsets.begin(), rows.offsets.end() - 1);
    for (std::size_t e = 0; e < cutter.edges.edges.size(); ++e) {
        const SurfaceEdge& edge = cutter.edges.edges[e];
        rows.values[index(next[index(edge.start)]++)] = toLabel(e);
        rows.values[index(next[index(edge.end)]++)] = toLabel(e);
    }
    return rows;
}

} // namespace

void locateVertices(const PolyMesh& mesh,
                    const Probe& probe,
                    const CuttingSurface& cutter,
                    Arrangement& arrangement) {
    orderPierces(probe, cutter, arrangement);
    arrangement.vertexCell.assign(cutter.surface->points.size(), unknown);
    locateFromPierces(probe, cutter, arrangement);
    const Rows<Label> edgesOf = edgesOfPoints(cutter);
    std::vector<Label> front;
    for (Label v = 0; v < cutter.surface->pointCount(); ++v)
        if (arrangement.vertexCell[index(v)] != unknown) front.push_back(v);
    spread(cutter, arrangement, front, edgesOf, arrangement.vertexCell);

    double far = -Box::inf;
    for (const Vec3& p : mesh.points)
        far = std::max(far, p.x);
    for (const Vec3& p : cutter.surface->points)
        far = std::max(far, p.x);
    far += std::max(1.0, std::abs(far));
    for (Label t = 0; t < cutter.surface->triangleCount(); ++t) {
        const Label v = cutter.surface->triangles[index(t)][0];
        if (arrangement.vertexCell[index(v)] != unknown) continue;
        arrangement.vertexCell[index(v)] =
            searchCell(probe, t, cutter.surface->points[index(v)], far);
        front.assign(1, v);
        spread(cutter, arrangement, front, edgesOf, arrangement.vertexCell);
    }
}

} // namespace polymesh
