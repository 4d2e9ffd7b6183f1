// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"

#include <string>
#include <string_view>

namespace polymesh::obj {

/// Reads a Wavefront OBJ file's content: `v` and `f` (polygons become triangles; indices from 1, or
/// negative from the last vertex back). Other statements are passed over.
///
/// Regions are the groups `g` (the first name on the line, as OpenFOAM does it); without any the
/// objects `o`, without these the materials `usemtl`. `name` names the region of faces that have
/// none; `fileName` is for messages.
///
/// Throws InputError (file and line) for anything malformed, and when there is no triangle.
TriSurface read(std::string_view text, const std::string& fileName, std::string_view name);

/// One group a region, with the digits that give the same coordinates back.
std::string write(const TriSurface& surface);

} // namespace polymesh::obj
