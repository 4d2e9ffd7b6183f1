// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"

#include <filesystem>

namespace polymesh {

/// Reads a surface; the format goes by the extension: .stl or .stlb (text or binary, whatever it
/// says), .obj, .off, .ply, each also with .gz. When the file is missing but packed as .gz beside
/// it, that one is read. Regions keep their names; a region without one gets the file's (without
/// extensions).
///
/// Coordinates are the doubles nearest to the text. Throws InputError: no such file, unknown
/// extension, malformed content (with line or byte), no triangles.
TriSurface readSurface(const std::filesystem::path& file);

/// Writes a surface; extensions as above, .stl as text, .stlb as binary STL, .ply as binary. Text
/// has the digits that give the same coordinates back; .off and .ply lose the regions. The old file
/// stays until the new one is complete. Throws InputError for an unknown extension, WorkError when
/// the file cannot be written.
void writeSurface(const TriSurface& surface, const std::filesystem::path& file);

} // namespace polymesh
