// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/shapeSplit/pieceChanges.h"

namespace polymesh {

/// Mends acceptable cells that checkMesh would fail, by local changes (pieceChanges.h) after which
/// all cells round them are sound, and acceptable. Of the changes that leave fewer failures, or
/// less severe ones, the best is made, again and again; where there is none, several changes that
/// help together are sought, once for a cell. Cells that are not acceptable are passed over.
/// Returns how often something was changed.
/// Cost: a look at each cell; some milliseconds for one that fails, up to a second where only
/// several changes help, or none.
Label mendPieces(MeshEditor& editor, const MendMeans& means);

} // namespace polymesh
