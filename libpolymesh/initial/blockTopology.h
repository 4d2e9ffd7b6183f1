// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/blockGrid.h"

#include <array>
#include <vector>

namespace polymesh {

/// A side of a block that lies on the boundary.
struct BoundarySide {
    Label block = 0;
    std::size_t side = 0;
};

/// A side that two blocks share.
struct SharedSide {
    std::array<Label, 2> blocks{};
    std::array<std::size_t, 2> sides{};
    /// Walks that give the same points and the cells across; the first is sideGrid of its block.
    std::array<SideGrid, 2> grids;
    /// The first block's side in the order of sideGrid of the second.
    SideGrid firstSeenFromSecond;
};

/// Which sides of the blocks meet, and which belong to which patch.
struct BlockTopology {
    std::vector<SharedSide> shared;
    std::vector<std::vector<BoundarySide>> patches; // of the description, then the default patch
    /// Whether there is a default patch: also when all it has are sides collapsed to lines.
    bool hasDefaultPatch = false;
};

/// Finds the sides that blocks share, by their vertices. Sides that have collapsed to a line are
/// left out. Sides without a patch go to the default patch; when a patch of the description has its
/// name, to that one. Throws InputError, which begins with the place of the block or the patch:
/// different numbers of cells, three blocks on one side, a patch side that is no side of a block,
/// is between two blocks, or is in two patches.
BlockTopology blockTopology(const BlockMeshDescription& description);

} // namespace polymesh
