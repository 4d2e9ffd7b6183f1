// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/foamReader.h"
#include "libpolymesh/base/rows.h"
#include "libpolymesh/geometry/vec3.h"

#include <vector>

namespace polymesh::foam {

// Lists as OpenFOAM writes them: n(...) or n{v} or (...) in text, n(raw) in binary files. Counts
// are compared with what the file can hold before memory is taken. Errors: InputError with the file
// and the line (text) or the byte (binary). Time: linear; memory: the result and a small buffer.

/// Reads labels. A list n{v} may have at most `mostEqual` elements, since it takes no space in the
/// file that would vouch for its length.
std::vector<Label> readLabels(FoamReader& reader, Label mostEqual);

/// Reads labels written as text although the header may say binary, as in OpenFOAM's sets.
std::vector<Label> readLabelText(FoamReader& reader, Label mostEqual);

/// Reads true and false, written as 1 and 0 or as words, one byte each in binary.
std::vector<bool> readFlags(FoamReader& reader, Label mostEqual);

/// Reads points or vectors; every coordinate is finite.
std::vector<Vec3> readVectors(FoamReader& reader);

/// Reads a faceList (text, or binary as old programs wrote it) or a faceCompactList, whichever the
/// header's class says. Every face has at least 3 labels; their range is not checked.
Rows<Label> readFaces(FoamReader& reader);

} // namespace polymesh::foam
