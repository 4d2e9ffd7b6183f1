// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/cutCells.h"

namespace polymesh {

/// The paper's cell-based algorithm (section 2.2) as a second way to the exact cut, for
/// TrimOptions::findCut: each cell near the surface is cut by itself, from its own faces and the
/// triangles near it, and the findings of neighbours, which have to agree, are joined by the names
/// of their points. Shares with the mesh-based stages the exact signs, the names of the mesh's
/// entities (Probe), the places of points and how holes are opened; finds the same cut to the bit.
///
/// Throws WorkError where cells disagree, InputError where the surface intersects itself so that
/// inside is not defined. The result does not depend on the number of threads. Cost: linear, about
/// 20 us for a cut cell, ten times that of the mesh-based way. See docs/cellTrim.md.
MeshCut findCutByCells(PolyMesh& mesh,
                       const FeaturedSurface& surface,
                       const AdjustedNodes& adjusted,
                       const TrimOptions& options);

} // namespace polymesh
