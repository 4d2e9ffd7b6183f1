// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/blockTopology.h"

#include <vector>

namespace polymesh {

/// The points of all blocks, and which of them are one.
struct BlockNumbering {
    std::vector<std::vector<Vec3>> points; // of each block, not scaled
    std::vector<Label> firstPoint;         // of each block among all block points
    std::vector<Label> firstCell;          // of each block among all cells
    std::vector<Label> meshPoint;          // label in the mesh of each block point
    std::vector<bool> collapsed;           // blocks in which points coincide
    Label meshPointCount = 0;
};

/// Computes the points of the blocks and numbers those of the mesh: block by block, each with the
/// first block that has it. Points are one when blocks share them by a common side, or when they
/// coincide along a collapsed edge. Throws InputError when the points of a common side differ by
/// more than a third of the shortest distance between neighbours on it.
BlockNumbering numberPoints(const BlockMeshDescription& description, const BlockTopology& topology);

/// The scaled coordinates, from those of the blocks; of points that blocks share those of the last
/// block.
std::vector<Vec3> meshPoints(std::vector<std::vector<Vec3>> blockPoints,
                             const BlockNumbering& numbering,
                             double scale);

} // namespace polymesh
