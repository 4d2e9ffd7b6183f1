// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/extrude.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/initial/blockGrid.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polymesh {
namespace {

using Quad = std::array<Label, 4>;

/// A corner whose triangle, seen along the vector, has less than this of the size that its edges
/// could give it, is flat.
constexpr double flatCorner = 1e-9;

std::string shown(const Vec3& p) {
    return fmt::format("({:.6g} {:.6g} {:.6g})", p.x, p.y, p.z);
}

void requireDifferent(const SheetQuad& quad) {
    Quad sorted = quad.points;
    std::ranges::sort(sorted);
    require(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end(),
            "{}: the quadrilateral ({}) has a point twice; give it four different ones",
            quad.where,
            fmt::join(quad.points, " "));
}

/// The quadrilateral with its normal along the vector and its first edge where it was.
Quad turned(const ExtrusionSpec& extrusion, const SheetQuad& quad) {
    requireDifferent(quad);
    const auto point = [&](std::size_t i) { return extrusion.points[index(quad.points[i % 4])]; };
    int ahead = 0;
    int back = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 to = point(i + 1) - point(i);
        const Vec3 from = point(i + 3) - point(i);
        const double turn = dot(extrusion.vector, cross(to, from));
        const double hair = flatCorner * norm(extrusion.vector) * norm(to) * norm(from);
        if (turn > hair) ++ahead;
        if (turn < -hair) ++back;
    }
    require(ahead == 4 || back == 4,
            "{}: the quadrilateral ({}) near {} is concave or stands along the vector; it must be "
            "convex as seen along {}",
            quad.where,
            fmt::join(quad.points, " "),
            shown(point(0)),
            shown(extrusion.vector));
    const auto& p = quad.points;
    return ahead == 4 ? p : Quad{p[1], p[0], p[3], p[2]};
}

/// An edge of a quadrilateral, the lower point first.
struct SheetEdge {
    std::array<Label, 2> points{};
    bool isReversed = false; // the quadrilateral goes from the higher point to the lower one
    std::size_t quad = 0;
    std::size_t side = 0; // from corner `side` to the next one
};

std::vector<SheetEdge> sortedEdges(const std::vector<Quad>& quads) {
    std::vector<SheetEdge> edges;
    for (std::size_t q = 0; q < quads.size(); ++q)
        for (std::size_t side = 0; side < 4; ++side) {
            const Label from = quads[q][side];
            const Label to = quads[q][(side + 1) % 4];
            edges.push_back({{std::min(from, to), std::max(from, to)}, from > to, q, side});
        }
    std::ranges::sort(edges, [](const SheetEdge& a, const SheetEdge& b) {
        return std::pair(a.points, a.quad) < std::pair(b.points, b.quad);
    });
    return edges;
}

/// The edges that only one quadrilateral has. Two must go along an edge in opposite directions:
/// all of them are seen from the same side.
std::vector<SheetEdge> openEdges(const ExtrusionSpec& extrusion, const std::vector<Quad>& quads) {
    const std::vector<SheetEdge> edges = sortedEdges(quads);
    std::vector<SheetEdge> open;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && edges[end].points == edges[i].points)
            ++end;
        if (end - i == 1) open.push_back(edges[i]);
        const bool isFold =
            end - i > 2 || (end - i == 2 && edges[i].isReversed == edges[i + 1].isReversed);
        require(!isFold,
                "{}: as seen along {} this quadrilateral lies over the one at {}, with which it "
                "has the edge from {} to {}; a sheet must not fold",
                extrusion.quads[edges[end - 1].quad].where,
                shown(extrusion.vector),
                extrusion.quads[edges[i].quad].where,
                shown(extrusion.points[index(edges[i].points[0])]),
                shown(extrusion.points[index(edges[i].points[1])]));
        i = end;
    }
    return open;
}

BlockSide sideOf(const Block& block, std::size_t side) {
    BlockSide result;
    for (std::size_t c = 0; c < 4; ++c)
        result.vertices[c] = block.vertices[hexSides[side][c]];
    result.where = block.where;
    return result;
}

} // namespace

BlockMeshDescription extrudedBlocks(const ExtrusionSpec& extrusion) {
    // The side of a block on the edge from each corner of its quadrilateral to the next.
    constexpr std::array<std::size_t, 4> sideOfEdge{2, 1, 3, 0};
    const Label pointCount = toLabel(extrusion.points.size());
    BlockMeshDescription mesh;
    mesh.vertices = extrusion.points;
    for (const Vec3& p : extrusion.points)
        mesh.vertices.push_back(p + extrusion.vector);
    mesh.patches = {{{"start", "patch", 0, 0, {}}, {}},
                    {{"end", "patch", 0, 0, {}}, {}},
                    {{"side", "patch", 0, 0, {}}, {}}};
    std::vector<Quad> quads;
    for (const SheetQuad& quad : extrusion.quads) {
        quads.push_back(turned(extrusion, quad));
        Block block;
        for (std::size_t c = 0; c < 4; ++c) {
            block.vertices[c] = quads.back()[c];
            block.vertices[c + 4] = quads.back()[c] + pointCount;
        }
        block.cells = {extrusion.cells[0], extrusion.cells[1], extrusion.layers};
        for (std::size_t e = 8; e < 12; ++e)
            block.grading[e] = extrusion.grading;
        block.where = quad.where;
        mesh.patches[0].sides.push_back(sideOf(block, 4));
        mesh.patches[1].sides.push_back(sideOf(block, 5));
        mesh.blocks.push_back(std::move(block));
    }
    std::vector<SheetEdge> open = openEdges(extrusion, quads);
    std::ranges::sort(open, {}, [](const SheetEdge& e) { return std::pair(e.quad, e.side); });
    for (const SheetEdge& edge : open)
        mesh.patches[2].sides.push_back(sideOf(mesh.blocks[edge.quad], sideOfEdge[edge.side]));
    return mesh;
}

} // namespace polymesh
