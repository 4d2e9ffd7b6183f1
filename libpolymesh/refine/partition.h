// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/refine/processes.h"
#include "libpolymesh/refine/refinedOctants.h"

#include <vector>

namespace polymesh {

/// Which trees belong to which process: consecutive ones, so that cells are, too.
struct Partition {
    std::vector<Label> firstTree; // of each process, and the number of trees
    int rank = 0;

    Label first() const { return firstTree[static_cast<std::size_t>(rank)]; }

    Label end() const { return firstTree[static_cast<std::size_t>(rank) + 1]; }

    bool isOwn(Label tree) const { return tree >= first() && tree < end(); }

    /// Whether everything is this process's.
    bool isWhole() const { return firstTree.size() == 2; }
};

/// Equal numbers of trees.
Partition evenPartition(Label trees, const Processes& processes);

/// About equal numbers of leaves; trees are not cut.
Partition partitionByLeaves(const TreeOctants& octants, const Processes& processes);

/// Flags the trees of this process and those that share a point with them.
std::vector<char> treesInSight(const MacroMesh& mesh, const Partition& partition);

} // namespace polymesh
