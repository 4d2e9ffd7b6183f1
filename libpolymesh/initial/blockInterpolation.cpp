// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/blockInterpolation.h"

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"

#include <algorithm>

namespace polymesh {
namespace {

/// The curve between two vertices, and whether it runs from the second to the first.
struct FoundCurve {
    const BlockEdge* edge = nullptr;
    bool backwards = false;
};

FoundCurve findCurve(const std::vector<BlockEdge>& edges, Label from, Label to) {
    for (const BlockEdge& edge : edges) {
        if (edge.vertices[0] == from && edge.vertices[1] == to) return {&edge, false};
        if (edge.vertices[0] == to && edge.vertices[1] == from) return {&edge, true};
    }
    return {};
}

Vec3 along(const Vec3& a, const Vec3& b, double t) {
    return (1 - t) * a + t * b;
}

} // namespace

BlockInterpolation::DividedEdge BlockInterpolation::divided(const BlockMeshDescription& description,
                                                            const Block& block,
                                                            std::size_t edge,
                                                            Label parts) {
    const Label from = block.vertices[hexEdges[edge][0]];
    const Label to = block.vertices[hexEdges[edge][1]];
    const Label cells = block.cells[edge / 4];
    const FoundCurve found = findCurve(description.edges, from, to);
    const Grading& grading = block.grading[edge];
    DividedEdge result;
    result.parameters =
        gradedParameters(cells, found.backwards ? reversed(grading) : grading, parts);
    if (found.edge == nullptr) return result;
    const std::vector<Vec3>& vertices = description.vertices;
    result.points = found.edge->curve(vertices[index(found.edge->vertices[0])],
                                      vertices[index(found.edge->vertices[1])],
                                      result.parameters);
    if (found.backwards) {
        std::ranges::reverse(result.points);
        std::ranges::reverse(result.parameters);
        for (double& t : result.parameters)
            t = 1 - t;
    }
    return result;
}

BlockInterpolation::BlockInterpolation(const BlockMeshDescription& description,
                                       const Block& block,
                                       Label parts)
    : grid_{{block.cells[0] * parts, block.cells[1] * parts, block.cells[2] * parts}} {
    for (std::size_t c = 0; c < 8; ++c)
        corners_[c] = description.vertices[index(block.vertices[c])];
    for (std::size_t e = 0; e < 12; ++e)
        edges_[e] = divided(description, block, e, parts);
    isTrilinear_ = isLinear();
}

bool BlockInterpolation::isLinear() const {
    for (std::size_t e = 0; e < 12; ++e)
        if (!edges_[e].points.empty() || edges_[e].parameters != edges_[e / 4 * 4].parameters)
            return false;
    return true;
}

BlockInterpolation::Parameters BlockInterpolation::parameters(Label i, Label j, Label k) const {
    Parameters t;
    const std::array<Label, 3> ijk{i, j, k};
    for (std::size_t e = 0; e < 12; ++e)
        t[e] = edges_[e].parameters[index(ijk[e / 4])];
    return t;
}

BlockWeights BlockInterpolation::weights(const Parameters& t) {
    BlockWeights weights;
    weights.fill(1);
    for (std::size_t e = 0; e < 12; ++e) {
        weights[hexEdges[e][0]] *= 1 - t[e];
        weights[hexEdges[e][1]] *= t[e];
    }
    double sum = 0;
    for (const double w : weights)
        sum += w;
    for (double& w : weights)
        w /= sum;
    return weights;
}

Vec3 BlockInterpolation::transfinite(Label i, Label j, Label k) const {
    const Parameters t = parameters(i, j, k);
    const BlockWeights weight = weights(t);
    const std::array<Label, 3> ijk{i, j, k};
    Vec3 straight;
    Vec3 bent;
    for (std::size_t e = 0; e < 12; ++e) {
        const auto [a, b] = hexEdges[e];
        const Vec3 onLine = corners_[a] + t[e] * (corners_[b] - corners_[a]);
        const double w = weight[a] + weight[b];
        straight += w * onLine;
        if (!edges_[e].points.empty()) bent += w * (edges_[e].points[index(ijk[e / 4])] - onLine);
    }
    return straight / 3 + bent;
}

void BlockInterpolation::fill(std::vector<Vec3>& points) const {
    const Label rows = (grid_.cells[1] + 1) * (grid_.cells[2] + 1);
    parallelBlocks(rows, 16, [&](Label, Label first, Label last) {
        for (Label row = first; row < last; ++row) {
            const Label j = row % (grid_.cells[1] + 1);
            const Label k = row / (grid_.cells[1] + 1);
            for (Label i = 0; i <= grid_.cells[0]; ++i)
                points[index(grid_.point(i, j, k))] = transfinite(i, j, k);
        }
    });
    // Exact corners: blocks must agree in their vertices.
    for (std::size_t c = 0; c < 8; ++c) {
        const bool x = c % 4 == 1 || c % 4 == 2;
        const bool y = c % 4 >= 2;
        points[index(grid_.point(
            x ? grid_.cells[0] : 0, y ? grid_.cells[1] : 0, c >= 4 ? grid_.cells[2] : 0))] =
            corners_[c];
    }
}

void BlockInterpolation::fillTrilinear(std::vector<Vec3>& points) const {
    const Label rows = (grid_.cells[1] + 1) * (grid_.cells[2] + 1);
    parallelBlocks(rows, 16, [&](Label, Label first, Label last) {
        for (Label row = first; row < last; ++row) {
            const double y = edges_[4].parameters[index(row % (grid_.cells[1] + 1))];
            const double z = edges_[8].parameters[index(row / (grid_.cells[1] + 1))];
            const Vec3 begin =
                along(along(corners_[0], corners_[3], y), along(corners_[4], corners_[7], y), z);
            const Vec3 end =
                along(along(corners_[1], corners_[2], y), along(corners_[5], corners_[6], y), z);
            Vec3* point = &points[index(row * (grid_.cells[0] + 1))];
            for (const double x : edges_[0].parameters)
                *point++ = along(begin, end, x);
        }
    });
}

Vec3 BlockInterpolation::trilinear(double x, double y, double z) const {
    const Vec3 begin =
        along(along(corners_[0], corners_[3], y), along(corners_[4], corners_[7], y), z);
    const Vec3 end =
        along(along(corners_[1], corners_[2], y), along(corners_[5], corners_[6], y), z);
    return along(begin, end, x);
}

Vec3 BlockInterpolation::point(Label i, Label j, Label k) const {
    if (!isTrilinear_) return transfinite(i, j, k);
    return trilinear(edges_[0].parameters[index(i)],
                     edges_[4].parameters[index(j)],
                     edges_[8].parameters[index(k)]);
}

std::vector<Vec3> BlockInterpolation::points() const {
    std::vector<Vec3> points = freshList<Vec3>(index(grid_.pointCount()));
    if (isTrilinear_)
        fillTrilinear(points);
    else
        fill(points);
    return points;
}

} // namespace polymesh
