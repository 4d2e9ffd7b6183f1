// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/shapeSplit/fillWithTetrahedra.h"

#include <cstdint>

namespace polymesh {

/// What a cell has become.
enum class Pieces : std::uint8_t { none, pyramids, tetrahedra };

/// Replaces a cell by the pyramids round a point that sees all faces; where checkMesh would find
/// something wrong with those round the first such point, by the best of the pyramids round a dozen
/// others, of those round points near the best of these, and of tetrahedra. None, and nothing is
/// changed, when no such point is found. Requires: no face is too large.
/// Cost: some 50 microseconds, some milliseconds where the first point is not good.
Pieces makeGoodPieces(MeshEditor& editor, Label cell, const Tetrahedraliser& tetrahedralise);

} // namespace polymesh
