// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/blocks.h"

#include <string>

namespace polymesh {

/// Gives a patch of a description another name. Where another patch bears that already, their
/// sides become one patch. Requires: there is such a patch, or the default patch has the name.
void renamePatch(BlockMeshDescription& description,
                 const std::string& name,
                 const std::string& newName);

/// Adds the blocks of a part, which has no vertices in common with the others; patches with the
/// same name become one. `where` is "file:line", for messages. Requires: equal scales.
void addPart(BlockMeshDescription& description, BlockMeshDescription part, std::string where);

} // namespace polymesh
