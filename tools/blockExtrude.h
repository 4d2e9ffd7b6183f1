// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/dictionary.h"
#include "libpolymesh/initial/blocks.h"
#include "tools/blockShorthands.h"

namespace polymesh::tools {

/// The blocks of extrude {...}: of `points` and `quads`, of a `surface` file of quadrilaterals, or
/// of a `patch` of a mesh. Throws InputError, which begins with file and line.
BlockMeshDescription readExtrude(const foam::Dictionary& dictionary, const ShorthandFiles& files);

} // namespace polymesh::tools
