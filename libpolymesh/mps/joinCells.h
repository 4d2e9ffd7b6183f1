// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"

#include <span>
#include <utility>
#include <vector>

namespace polymesh {

/// The mesh with cells made one: the faces between the two of each pair go. The cell has the place
/// of the first in order, the cells behind the other move up. More than two become one when the
/// first of them is in a pair with each other one. Cost: linear.
PolyMesh withJoinedCells(PolyMesh mesh, std::span<const std::pair<Label, Label>> pairs);

} // namespace polymesh
