// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/star/boundaryRecords.h"
#include "libpolymesh/mesh/polyMesh.h"

namespace polymesh::star {

/// The faces of patches, in any order; patch numbers are those of the patches to be.
struct PatchFaces {
    std::vector<Patch> patches; // without start and size
    std::vector<Label> faces;   // of CellRecords: every one without a partner, once
    std::vector<Label> patchOf; // of each of them
};

/// The mesh of the cells: internal faces in OpenFOAM's order, as the cell of lower number has them,
/// then the faces of each patch in the order given. Points that no face uses are left out.
/// Cost: linear.
PolyMesh assemble(std::vector<Vec3> points,
                  const CellRecords& cells,
                  const FacePairs& pairs,
                  PatchFaces boundary);

} // namespace polymesh::star
