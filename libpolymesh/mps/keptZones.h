// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"

#include <limits>

namespace polymesh {

/// What holds places together: cells on both sides of the borders of so many zones, from the first,
/// are not joined; the others are sets that only follow.
struct KeptZones {
    std::size_t cellZones = std::numeric_limits<std::size_t>::max();
    std::size_t faceZones = std::numeric_limits<std::size_t>::max();
};

/// Whether both cells are in the same of the zones that count.
bool areInSameZones(const PolyMesh& mesh, const KeptZones& zones, Label cell, Label other);

/// Whether a face is in one of the zones that count.
bool isInZone(const PolyMesh& mesh, const KeptZones& zones, Label face);

} // namespace polymesh
