// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"

#include <string>
#include <string_view>

namespace polymesh::stl {

/// Reads an STL file's content, text or binary. It is binary when its size is 84 bytes and 50 for
/// each triangle that it announces, whatever its first word (many binary files begin with "solid").
///
/// Regions: each solid of a text file; in a binary file, when the 16-bit attributes differ, each of
/// their values, named zone0, zone1 ... in the order in which they come (OpenFOAM's rule). Stored
/// normals are ignored. `name` names the region of triangles that have none; `fileName` is for
/// messages.
///
/// Throws InputError (file and line or offset) for anything malformed, and when there is no
/// triangle. Cost: one pass.
TriSurface read(std::string_view bytes, const std::string& fileName, std::string_view name);

/// As text, one solid a region, with the digits that give the same coordinates back.
std::string writeText(const TriSurface& surface);

/// As binary: coordinates are rounded to 32 bits, the attribute is the region's label.
std::string writeBinary(const TriSurface& surface);

} // namespace polymesh::stl
