// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/editPart.h"

#include <string>
#include <vector>

namespace polymesh {

/// Joins the untouched cells of a mesh with the edited part to one PolyMesh that fulfils all laws.
/// Cells keep the order of the cells that they come from, points of the old mesh come first, in
/// their order. Patches of the old mesh that have faces left stay; one patch per region of the
/// surface follows (with `regionTypes[r]` as type, and a name of its own should the old mesh have a
/// patch of the same name). Cell zones are carried over. Cost: linear.
PolyMesh assemble(const PolyMesh& mesh,
                  const EditPart& part,
                  const std::vector<std::string>& regionNames,
                  const std::vector<std::string>& regionTypes);

} // namespace polymesh
