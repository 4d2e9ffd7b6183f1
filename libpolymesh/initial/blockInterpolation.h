// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/blockGrid.h"

#include <array>
#include <vector>

namespace polymesh {

/// The weights of the eight corners for a point; they sum to 1.
using BlockWeights = std::array<double, 8>;

/// The points of a block as its edges give them: see blockPoints in blockGrid.h.
class BlockInterpolation {
public:
    /// `parts`: into how many each cell is divided along each direction. Cost: linear in what the
    /// edges are divided into.
    BlockInterpolation(const BlockMeshDescription& description,
                       const Block& block,
                       Label parts = 1);

    const BlockGrid& grid() const { return grid_; }

    /// All points, not scaled. Corners are exactly the vertices.
    std::vector<Vec3> points() const;

    /// One point, not scaled.
    Vec3 point(Label i, Label j, Label k) const;

    BlockWeights weights(Label i, Label j, Label k) const { return weights(parameters(i, j, k)); }

private:
    /// The parameters of the twelve edges at one point of the block.
    using Parameters = std::array<double, 12>;

    /// One edge of the block, divided.
    struct DividedEdge {
        std::vector<double> parameters;
        std::vector<Vec3> points; // of a curved edge; empty: straight
    };

    static DividedEdge divided(const BlockMeshDescription& description,
                               const Block& block,
                               std::size_t edge,
                               Label parts);
    bool isLinear() const;
    void fillTrilinear(std::vector<Vec3>& points) const;
    void fill(std::vector<Vec3>& points) const;
    Parameters parameters(Label i, Label j, Label k) const;
    static BlockWeights weights(const Parameters& t);
    Vec3 trilinear(double x, double y, double z) const;
    Vec3 transfinite(Label i, Label j, Label k) const;

    BlockGrid grid_;
    std::array<Vec3, 8> corners_;
    std::array<DividedEdge, 12> edges_;
    /// Whether the four edges of each direction are divided alike and straight, so that the
    /// interpolation is linear in each direction.
    bool isTrilinear_ = false;
};

} // namespace polymesh
