// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"

#include <span>

namespace polymesh {

/// A cell's volume, and its smallest part as a fraction of a given volume.
struct PartMeasure {
    double volume = 0; // [m^3]
    double smallest = 0;
};

/// Cuts a cell into the tetrahedra over its edges (two points of an edge, the mean of a face's
/// points, the mean of these), and into the parallelepipeds of those points where three edges meet.
/// `smallest` is the smallest of the tetrahedra times their number, and of the parallelepipeds,
/// over `volume` (0: the cell's own): 1 for a cube or any parallelepiped, negative for a cell that
/// is inside out somewhere. A cell with `smallest` well above rounding is star-shaped and has only
/// positive corners in exact arithmetic too.
PartMeasure
smallestPart(const PolyMesh& mesh, Label cell, std::span<const Label> cellFaces, double volume);

} // namespace polymesh
