// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The points of one block: see blockPoints in blockGrid.h.

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/initial/blockGrid.h"

#include <algorithm>
#include <optional>

namespace polymesh {
namespace {

using Corners = std::array<Vec3, 8>;

/// One edge of a block, divided.
struct DividedEdge {
    std::vector<double> parameters;
    std::vector<Vec3> points; // of a curved edge; empty: straight
};

using DividedEdges = std::array<DividedEdge, 12>;

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

DividedEdge divided(const BlockMeshDescription& description, const Block& block, std::size_t edge) {
    const Label from = block.vertices[hexEdges[edge][0]];
    const Label to = block.vertices[hexEdges[edge][1]];
    const Label cells = block.cells[edge / 4];
    const FoundCurve found = findCurve(description.edges, from, to);
    const Grading& grading = block.grading[edge];
    DividedEdge result;
    result.parameters = gradedParameters(cells, found.backwards ? reversed(grading) : grading);
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

/// The weights of the eight corners for a point; they sum to 1.
using Weights = std::array<double, 8>;

/// The parameters of the twelve edges at one point of the block.
using Parameters = std::array<double, 12>;

class Interpolation {
public:
    Interpolation(const BlockMeshDescription& description, const Block& block)
        : grid_{block.cells} {
        for (std::size_t c = 0; c < 8; ++c)
            corners_[c] = description.vertices[index(block.vertices[c])];
        for (std::size_t e = 0; e < 12; ++e)
            edges_[e] = divided(description, block, e);
    }

    const BlockGrid& grid() const { return grid_; }

    bool hasCurves() const {
        return std::ranges::any_of(edges_, [](const DividedEdge& e) { return !e.points.empty(); });
    }

    /// Whether the four edges of each direction are divided alike and straight, so that the
    /// interpolation is linear in each direction.
    bool isTrilinear() const {
        for (std::size_t e = 0; e < 12; ++e)
            if (edges_[e].parameters != edges_[e / 4 * 4].parameters) return false;
        return !hasCurves();
    }

    void fillTrilinear(std::vector<Vec3>& points) const;
    void fill(std::vector<Vec3>& points) const;

    Weights weights(Label i, Label j, Label k) const { return weights(parameters(i, j, k)); }

private:
    Parameters parameters(Label i, Label j, Label k) const;
    static Weights weights(const Parameters& t);
    Vec3 point(Label i, Label j, Label k) const;

    BlockGrid grid_;
    Corners corners_;
    DividedEdges edges_;
};

Parameters Interpolation::parameters(Label i, Label j, Label k) const {
    Parameters t;
    const std::array<Label, 3> ijk{i, j, k};
    for (std::size_t e = 0; e < 12; ++e)
        t[e] = edges_[e].parameters[index(ijk[e / 4])];
    return t;
}

Weights Interpolation::weights(const Parameters& t) {
    Weights weights;
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

Vec3 Interpolation::point(Label i, Label j, Label k) const {
    const Parameters t = parameters(i, j, k);
    const Weights weight = weights(t);
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

void Interpolation::fill(std::vector<Vec3>& points) const {
    const Label rows = (grid_.cells[1] + 1) * (grid_.cells[2] + 1);
    parallelBlocks(rows, 16, [&](Label, Label first, Label last) {
        for (Label row = first; row < last; ++row) {
            const Label j = row % (grid_.cells[1] + 1);
            const Label k = row / (grid_.cells[1] + 1);
            for (Label i = 0; i <= grid_.cells[0]; ++i)
                points[index(grid_.point(i, j, k))] = point(i, j, k);
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

void Interpolation::fillTrilinear(std::vector<Vec3>& points) const {
    const auto along = [](const Vec3& a, const Vec3& b, double t) { return (1 - t) * a + t * b; };
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

/// Which sides of a block lie on a shape.
using SideShapes = std::array<const Shape*, 6>;

std::array<Label, 4> sorted(std::array<Label, 4> vertices) {
    std::ranges::sort(vertices);
    return vertices;
}

SideShapes sideShapes(const BlockMeshDescription& description, const Block& block) {
    SideShapes shapes{};
    for (std::size_t side = 0; side < 6; ++side) {
        std::array<Label, 4> vertices{};
        for (std::size_t c = 0; c < 4; ++c)
            vertices[c] = block.vertices[hexSides[side][c]];
        for (const ProjectedSide& projected : description.projectedSides)
            if (shapes[side] == nullptr && sorted(projected.side.vertices) == sorted(vertices))
                shapes[side] = &projected.shape;
    }
    return shapes;
}

/// Moves the points of a block by what its projected sides moved by: direction by direction, each
/// point by the mean of what the two sides across it still lack there, weighted by its nearness.
class SideCorrection {
public:
    SideCorrection(const Interpolation& block, const SideShapes& shapes)
        : block_(block), cells_(block.grid().cells), shapes_(shapes) {}

    void apply(std::vector<Vec3>& points);

private:
    void projectSides(const std::vector<Vec3>& points);
    void correct(std::size_t direction, std::vector<Vec3>& points) const;
    bool isFixed(const std::array<Label, 3>& ijk) const;

    const Interpolation& block_;
    std::array<Label, 3> cells_;
    SideShapes shapes_;
    std::array<std::vector<Vec3>, 6> sides_;
};

void SideCorrection::projectSides(const std::vector<Vec3>& points) {
    for (std::size_t s = 0; s < 6; ++s) {
        const SideGrid side = sideGrid(block_.grid(), s);
        for (Label v = 0; v <= side.counts[1]; ++v)
            for (Label u = 0; u <= side.counts[0]; ++u)
                sides_[s].push_back(points[index(side.point(u, v))]);
        if (shapes_[s] != nullptr)
            projectFace(
                sides_[s], {index(side.counts[0] + 1), index(side.counts[1] + 1)}, *shapes_[s]);
    }
}

/// Edges, and sides without a shape, stay.
bool SideCorrection::isFixed(const std::array<Label, 3>& ijk) const {
    int onSides = 0;
    for (std::size_t d = 0; d < 3; ++d) {
        if (ijk[d] != 0 && ijk[d] != cells_[d]) continue;
        ++onSides;
        if (ijk[d] == 0 && shapes_[2 * d] == nullptr) return true;
        if (ijk[d] == cells_[d] && shapes_[2 * d + 1] == nullptr) return true;
    }
    return onSides > 1;
}

void SideCorrection::correct(std::size_t direction, std::vector<Vec3>& points) const {
    const BlockGrid& grid = block_.grid();
    const SideGrid lower = sideGrid(grid, 2 * direction);
    const SideGrid upper = sideGrid(grid, 2 * direction + 1);
    const Label n = cells_[direction];
    const std::size_t uAxis = direction == 0 ? 1 : 0;
    const std::size_t vAxis = direction == 2 ? 1 : 2;
    for (Label step = 0; step <= n; ++step) {
        std::array<Label, 3> ijk{};
        // The two sides come last: until then they say how far they have to go.
        ijk[direction] = (step + 1) % (n + 1);
        for (Label v = 0; v <= lower.counts[1]; ++v)
            for (Label u = 0; u <= lower.counts[0]; ++u) {
                ijk[uAxis] = u;
                ijk[vAxis] = v;
                if (isFixed(ijk)) continue;
                const Weights w = block_.weights(ijk[0], ijk[1], ijk[2]);
                double nearLower = 0;
                for (const std::size_t corner : hexSides[2 * direction])
                    nearLower += w[corner];
                const std::size_t at = index(u + (lower.counts[0] + 1) * v);
                const Vec3 low = sides_[2 * direction][at] - points[index(lower.point(u, v))];
                const Vec3 up = sides_[2 * direction + 1][at] - points[index(upper.point(u, v))];
                points[index(grid.point(ijk[0], ijk[1], ijk[2]))] +=
                    nearLower * low + (1 - nearLower) * up;
            }
    }
}

void SideCorrection::apply(std::vector<Vec3>& points) {
    projectSides(points);
    for (std::size_t direction = 0; direction < 3; ++direction)
        correct(direction, points);
}

} // namespace

std::vector<Vec3> blockPoints(const BlockMeshDescription& description, const Block& block) {
    const Interpolation interpolation(description, block);
    std::vector<Vec3> points = freshList<Vec3>(index(interpolation.grid().pointCount()));
    if (interpolation.isTrilinear())
        interpolation.fillTrilinear(points);
    else
        interpolation.fill(points);
    const SideShapes shapes = sideShapes(description, block);
    if (std::ranges::any_of(shapes, [](const Shape* shape) { return shape != nullptr; }))
        SideCorrection(interpolation, shapes).apply(points);
    return points;
}

} // namespace polymesh
