// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/box.h"
#include "libpolymesh/surface/triSurface.h"
#include "tools/toolMain.h"

#include <string>
#include <vector>

namespace polymesh::tools {

/// The OpenFOAM type of each region's patch: -patchType, else the region's entry in the
/// dictionary's patchTypes, else the dictionary's patchType, else wall.
/// Throws InputError for a type that a patch of a surface cannot have, and for a region that the
/// surface has not.
std::vector<std::string> patchTypes(const ToolRun& tool, const TriSurface& surface);

/// Makes the surface ready to trim with: closes cracks of rounding, turns it where it is inside
/// out, unites what overlaps, and tells on stdout, on stderr (cracks and self-intersections) and in
/// the report what it found. `file` is named in messages. Throws InputError for a surface that
/// bounds nothing.
void prepareSurface(ToolRun& tool, const std::string& file, TriSurface& surface);

/// Compares where the surface and the mesh, by its bounding box, are: warns of a surface that
/// leaves the mesh, throws InputError for one that misses it and for a mesh too large for numbers.
/// True when the surface lies within the bounding box of the mesh.
bool checkPlace(ToolRun& tool,
                const std::string& file,
                const TriSurface& surface,
                const Box& domain);

} // namespace polymesh::tools
