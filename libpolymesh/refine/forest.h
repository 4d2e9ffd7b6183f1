// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/refine/leaves.h"
#include "libpolymesh/refine/partition.h"
#include "libpolymesh/refine/refinedOctants.h"

namespace polymesh {

/// The leaves of a forest in which these octants are divided, grown by p4est with the cells of the
/// macro-mesh as its trees. With several processes p4est distributes it as the partition says, and
/// only the leaves of trees in sight are known.
/// Requires: a divided octant's parent is divided.
Leaves growForest(const MacroMesh& mesh,
                  const RefinedOctants& refined,
                  const TreeOctants& octants,
                  const Partition& partition);

/// What p4est itself makes of the forest when it balances it, over sides, edges and corners: the
/// slow way to what balance() does with one buffer layer.
Leaves growBalancedForest(const MacroMesh& mesh, const RefinedOctants& refined);

} // namespace polymesh
