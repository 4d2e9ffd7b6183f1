// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/rows.h"
#include "libpolymesh/surface/triSurface.h"

#include <string>
#include <string_view>

namespace polymesh {

/// The triangles of each region, ascending; one row per region.
Rows<Label> trianglesOfRegions(const TriSurface& surface);

/// `name` without the characters that OpenFOAM's dictionaries do not take in a word (blanks,
/// quotes, brackets, / ; $ # and the like), as OpenFOAM's own readers do it, and with an underscore
/// in front if it begins with a digit or one of + - . * : = (these readers would stumble there).
std::string toWord(std::string_view name);

} // namespace polymesh
