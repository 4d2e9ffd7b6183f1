// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/dictionary.h"
#include "libpolymesh/initial/blocks.h"
#include "tools/blockMeshDict.h"

#include <filesystem>

namespace polymesh::tools {

/// Where the files are that shorthands name.
struct ShorthandFiles {
    FindSurface findSurface;
    std::filesystem::path polyMesh; // of the case, for patches
};

/// Whether a dictionary says cartesian {...}, cylinder {...}, sphere {...}, extrude {...} or
/// parts (...).
bool isShorthand(const foam::Dictionary& dictionary);

/// The blocks of the shorthands, one part each when there are several. As in a blockMeshDict, other
/// entries are macros of the user, unless they look like a misspelt name. Throws InputError, which
/// begins with file and line, for wrong or missing entries.
BlockMeshDescription readShorthands(const foam::Dictionary& dictionary,
                                    const ShorthandFiles& files);

} // namespace polymesh::tools
