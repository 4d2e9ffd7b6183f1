// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/blockNumbering.h"

#include "libpolymesh/base/disjointSets.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polymesh {
namespace {

/// Points of a block that are nearer than this share of its size coincide.
constexpr double coincidence = 1e-14;

/// Calls visit(u, v, neighbour u, neighbour v) for neighbouring points along u and along v.
template<class Visit>
void forNeighbours(const SideGrid& side, Visit&& visit) {
    for (Label v = 0; v <= side.counts[1]; ++v)
        for (Label u = 0; u <= side.counts[0]; ++u) {
            if (u < side.counts[0]) visit(side.point(u, v), side.point(u + 1, v));
            if (v < side.counts[1]) visit(side.point(u, v), side.point(u, v + 1));
        }
}

double coincidence2(std::span<const Vec3> points) {
    const double tolerance = coincidence * norm(boundingBox(points).size());
    return tolerance * tolerance;
}

/// Whether an edge of the block has no length. Only then points of the block coincide.
bool hasCollapsedEdge(const BlockMeshDescription& description, const Block& block) {
    std::array<Vec3, 8> corners;
    for (std::size_t c = 0; c < 8; ++c)
        corners[c] = description.vertices[index(block.vertices[c])];
    const double tolerance2 = coincidence2(corners);
    return std::ranges::any_of(hexEdges, [&](const auto& edge) {
        return squaredNorm(corners[edge[0]] - corners[edge[1]]) <= tolerance2;
    });
}

void uniteCollapsed(const Block& block,
                    const std::vector<Vec3>& points,
                    Label firstPoint,
                    DisjointSets& sets) {
    const double tolerance2 = coincidence2(points);
    for (std::size_t s = 0; s < 6; ++s)
        forNeighbours(sideGrid({block.cells}, s), [&](Label p, Label q) {
            if (squaredNorm(points[index(p)] - points[index(q)]) <= tolerance2)
                sets.join(firstPoint + p, firstPoint + q);
        });
}

/// The squared distance up to which points of two blocks on a common side are one: a tenth of the
/// least one between neighbours there.
double gapLimit2(const SideGrid& side, const std::vector<Vec3>& points) {
    const double collapsed = coincidence2(points);
    double least = std::numeric_limits<double>::infinity();
    forNeighbours(side, [&](Label p, Label q) {
        const double distance2 = squaredNorm(points[index(p)] - points[index(q)]);
        if (distance2 > collapsed) least = std::min(least, distance2);
    });
    return least / 10;
}

void uniteShared(const BlockMeshDescription& description,
                 const SharedSide& shared,
                 const BlockNumbering& numbering,
                 DisjointSets& sets) {
    const auto [a, b] = shared.blocks;
    const std::vector<Vec3>& pointsA = numbering.points[index(a)];
    const std::vector<Vec3>& pointsB = numbering.points[index(b)];
    const double limit2 = gapLimit2(shared.grids[0], pointsA);
    for (Label v = 0; v <= shared.grids[0].counts[1]; ++v)
        for (Label u = 0; u <= shared.grids[0].counts[0]; ++u) {
            const Label p = shared.grids[0].point(u, v);
            const Label q = shared.grids[1].point(u, v);
            const Vec3& x = pointsA[index(p)];
            const Vec3& y = pointsB[index(q)];
            require(squaredNorm(x - y) <= limit2,
                    "{}: the points on the side that this block shares with the block at {} differ "
                    "by {:.3g} near ({:.6g} {:.6g} {:.6g}); give both the same grading there",
                    description.blocks[index(b)].where,
                    description.blocks[index(a)].where,
                    norm(x - y),
                    x.x,
                    x.y,
                    x.z);
            sets.join(numbering.firstPoint[index(a)] + p, numbering.firstPoint[index(b)] + q);
        }
}

/// Where the points and cells of each block begin; returns the number of points.
Label layOut(const std::vector<Block>& blocks, BlockNumbering& numbering) {
    Label point = 0;
    Label cell = 0;
    for (const Block& block : blocks) {
        numbering.firstPoint.push_back(point);
        numbering.firstCell.push_back(cell);
        point += BlockGrid{block.cells}.pointCount();
        cell += BlockGrid{block.cells}.cellCount();
    }
    numbering.firstCell.push_back(cell);
    return point;
}

} // namespace

BlockNumbering numberPoints(const BlockMeshDescription& description,
                            const BlockTopology& topology) {
    BlockNumbering numbering;
    const Label pointCount = layOut(description.blocks, numbering);
    DisjointSets sets(pointCount);
    for (std::size_t b = 0; b < description.blocks.size(); ++b) {
        const Block& block = description.blocks[b];
        numbering.points.push_back(blockPoints(description, block));
        numbering.collapsed.push_back(hasCollapsedEdge(description, block));
        if (numbering.collapsed.back())
            uniteCollapsed(block, numbering.points.back(), numbering.firstPoint[b], sets);
    }
    for (const SharedSide& shared : topology.shared)
        uniteShared(description, shared, numbering, sets);
    DisjointSets::Numbers numbers = std::move(sets).numbers();
    numbering.meshPointCount = numbers.count;
    numbering.meshPoint = std::move(numbers.of);
    return numbering;
}

std::vector<Vec3> meshPoints(std::vector<std::vector<Vec3>> blockPoints,
                             const BlockNumbering& numbering,
                             double scale) {
    if (blockPoints.size() == 1 && !numbering.collapsed[0]) {
        std::vector<Vec3> points = std::move(blockPoints[0]);
        if (scale != 1)
            parallelFor(toLabel(points.size()),
                        [&](Label p) { points[index(p)] = scale * points[index(p)]; });
        return points;
    }
    std::vector<Vec3> points = freshList<Vec3>(index(numbering.meshPointCount));
    for (std::size_t b = 0; b < blockPoints.size(); ++b) {
        const std::vector<Vec3>& own = blockPoints[b];
        const Label first = numbering.firstPoint[b];
        const auto place = [&](Label p) {
            points[index(numbering.meshPoint[index(first + p)])] = scale * own[index(p)];
        };
        // Points that coincide are written more than once: not from several threads.
        if (numbering.collapsed[b])
            for (Label p = 0; p < toLabel(own.size()); ++p)
                place(p);
        else
            parallelFor(toLabel(own.size()), place);
        blockPoints[b] = {}; // its memory may serve elsewhere
    }
    return points;
}

} // namespace polymesh
