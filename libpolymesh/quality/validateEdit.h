// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/editMesh.h"

#include <string>
#include <vector>

namespace polymesh {

/// Checks the laws of editMesh.h, and that faces and cells agree on which belongs to which, that
/// boundary faces have a patch and internal ones have none, that cells have at least 4 faces and no
/// face twice. Returns one line per defect; empty when the mesh is sound. Cost: n log n in small
/// sorts.
std::vector<std::string> validateEdit(const EditMesh& mesh);

} // namespace polymesh
