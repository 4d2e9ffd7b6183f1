// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"

#include <string>
#include <string_view>

namespace polymesh::ply {

/// Reads a PLY file's content: text or binary of either byte order. Used are x, y and z of the
/// element `vertex` and the list `vertex_indices` (or `vertex_index`) of `face`; polygons become
/// triangles. The whole is one region, `name`; `fileName` is for messages.
///
/// Throws InputError (file and line or offset) for anything malformed, and when there is no
/// triangle.
TriSurface read(std::string_view bytes, const std::string& fileName, std::string_view name);

/// As little-endian binary with 64-bit coordinates; regions are lost.
std::string write(const TriSurface& surface);

} // namespace polymesh::ply
