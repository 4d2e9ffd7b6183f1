// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace polymesh {

/// What keeps a cell from being acceptable: the least that would have to be otherwise.
enum class Obstacle : std::uint8_t {
    pointsOnEdges, // without its points that have two edges only in the cell it would be acceptable
    creases,    // if also faces on one patch, or to one neighbour, were one: those that touch and
                // do not turn much from one to the next
    manyFaces,  // more than 8 faces
    manyPoints, // more than 12 points
    largeFace,  // a face of more than 6 points
    otherGraph  // no more of anything than acceptable cells have, but joined otherwise
};

inline constexpr std::size_t obstacleCount = 6;

std::string_view nameOf(Obstacle obstacle);

/// The obstacle of a cell that is not acceptable, from its faces (a row of mesh/topology.h); the
/// first in their order that applies. Cost: some microseconds.
Obstacle obstacleOf(const PolyMesh& mesh, std::span<const Label> cellFaces, Label cell);

/// How many of the cells have each obstacle. In parallel.
std::array<Label, obstacleCount>
countObstacles(const PolyMesh& mesh, const Rows<Label>& cellFaces, std::span<const Label> cells);

} // namespace polymesh
