// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/splitFaces.h"

namespace polymesh {

/// Finds cuts for those of `cells` (ascending) which divide better in parts: walls along closed
/// loops of the cell's own edges through its reflex edges (paper, section 3.2), so that nothing is
/// new but the walls, and neighbours do not notice. A loop is taken when the parts have fewer
/// inverted corners together than the whole had, the fewest, and then fewest cells; parts that are
/// not right yet are cut again. Cost: about 1 ms a cell and core.
std::vector<CellCones> loopCutsOf(const PolyMesh& mesh,
                                  const Bends& bends,
                                  const SubdivisionPlan& plan,
                                  std::span<const Label> cells);

/// Finds diagonals of the concave faces of `cells` (ascending) so that walls through their reflex
/// edges can go along them (paper, section 3.2: new edges through concave points, then loops
/// through those). From cell to cell across the faces that get diagonals, so that those at both
/// ends of a reflex edge fit together; a diagonal counts for both cells of its face.
/// Groups of cells that are neighbours are independent of each other and searched in parallel.
/// Cost: about 0.2 ms a cell and core.
std::vector<FacePieces> diagonalsOf(const PolyMesh& mesh,
                                    const Bends& bends,
                                    const SubdivisionPlan& plan,
                                    std::span<const Label> cells);

} // namespace polymesh
