// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"

#include <string>
#include <string_view>

namespace polymesh::off {

/// Reads the content of a text OFF file (also COFF, NOFF, STOFF and so on, without the additional
/// values). One vertex and one face a line, `#` begins a comment; polygons become triangles. The
/// whole is one region, `name`; `fileName` is for messages.
///
/// Throws InputError (file and line) for anything malformed, and when there is no triangle.
TriSurface read(std::string_view text, const std::string& fileName, std::string_view name);

/// With the digits that give the same coordinates back; regions are lost.
std::string write(const TriSurface& surface);

} // namespace polymesh::off
