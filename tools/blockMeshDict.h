// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/dictionary.h"
#include "libpolymesh/initial/blocks.h"

#include <filesystem>
#include <functional>
#include <string>

namespace polymesh::tools {

/// Finds the file of a surface that a dictionary names.
using FindSurface = std::function<std::filesystem::path(const std::string& name)>;

/// Whether a dictionary is a blockMeshDict: it has blocks.
bool isBlockMeshDict(const foam::Dictionary& dictionary);

/// What OpenFOAM's blockMesh v1912 would read from a blockMeshDict. As there, entries with other
/// names are macros of the user; but one that looks like a misspelt name is an error. Throws
/// InputError, which begins with file and line, for what is wrong, and with "is not supported" for
/// what blockMesh could do: projection onto more than one surface and onto other surfaces than
/// sphere, cylinder, box, plate and triSurfaceMesh, edges of the type projectCurve.
BlockMeshDescription readBlockMeshDict(const foam::Dictionary& dictionary,
                                       const FindSurface& findSurface);

} // namespace polymesh::tools
