// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The points of one block: see blockPoints in blockGrid.h.

#include "libpolymesh/initial/blockInterpolation.h"

#include <algorithm>

namespace polymesh {
namespace {

std::array<Label, 4> sorted(std::array<Label, 4> vertices) {
    std::ranges::sort(vertices);
    return vertices;
}

/// Moves the points of a block by what its projected sides moved by: direction by direction, each
/// point by the mean of what the two sides across it still lack there, weighted by its nearness.
class SideCorrection {
public:
    SideCorrection(const BlockInterpolation& block, const SideShapes& shapes)
        : block_(block), cells_(block.grid().cells), shapes_(shapes) {}

    void apply(std::vector<Vec3>& points);

private:
    void projectSides(const std::vector<Vec3>& points);
    void correct(std::size_t direction, std::vector<Vec3>& points) const;
    bool isFixed(const std::array<Label, 3>& ijk) const;

    const BlockInterpolation& block_;
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
                const BlockWeights w = block_.weights(ijk[0], ijk[1], ijk[2]);
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

std::vector<Vec3> blockPoints(const BlockMeshDescription& description, const Block& block) {
    const BlockInterpolation interpolation(description, block);
    std::vector<Vec3> points = interpolation.points();
    const SideShapes shapes = sideShapes(description, block);
    if (std::ranges::any_of(shapes, [](const Shape* shape) { return shape != nullptr; }))
        SideCorrection(interpolation, shapes).apply(points);
    return points;
}

} // namespace polymesh
