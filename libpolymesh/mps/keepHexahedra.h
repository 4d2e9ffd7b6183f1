// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/fate.h"
#include "libpolymesh/mps/makeDivisible.h"

#include <vector>

namespace polymesh {

// Division of what is no hexahedron only. Conformity demands that the edges of divided cells are
// halved in all their cells: hexahedra that have such an edge become a layer of cones over the
// pieces of their faces (halvedFace.h), pyramids and tetrahedra; all others stay.

/// What becomes of each cell of a planned mesh. Divided are all cells but hexahedra, and hexahedra
/// with a bent edge, or of which a cone would be inverted, or a boundary face that is halved is not
/// flat (its pieces would hold another volume). Cost: some passes over the mesh.
std::vector<Fate> fatesOf(const PolyMesh& mesh, const SubdivisionPlan& plan, const Bends& bends);

/// The mesh with these cells divided. Each result cell follows from one cell of the undivided mesh.
struct PartlyDivided {
    PolyMesh mesh;
    std::vector<Label> firstCell; // result cells of cell c: [firstCell[c], firstCell[c + 1])
};

/// `divided`: divisible.mesh divided whole, as divisible.plan says, which gives what is in divided
/// cells, the points and their zones. Zones of cells and faces go on to all that comes of them.
/// Requires: no cyclic patches, whose two sides might be halved differently.
/// The same bytes for any number of threads. Cost: linear, and a sort of the faces.
PartlyDivided
keepHexahedra(const Divisible& divisible, const std::vector<Fate>& fates, const PolyMesh& divided);

} // namespace polymesh
