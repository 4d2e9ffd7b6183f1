// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"

#include <string>
#include <string_view>

namespace polymesh::star {

/// Type, and where OpenFOAM has no such type, the entry physicalType, of the patch that a region
/// of this STAR-CD type becomes: WALL wall, SYMP symmetry, words that OpenFOAM knows as types
/// (empty, wedge, symmetryPlane) those; anything else patch. Upper and lower case are the same.
Patch patchOfType(std::string_view starType);

/// The STAR-CD type of a patch: WALL, SYMP, the word of physicalType (INLE ...), empty, wedge, or
/// patch, which is what OpenFOAM's foamToStarMesh writes.
std::string starTypeOf(const Patch& patch);

std::string toUpper(std::string_view text);
std::string toLower(std::string_view text);

} // namespace polymesh::star
