// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mps/fate.h"
#include "libpolymesh/mps/midPointSubdivision.h"

#include <span>
#include <vector>

namespace polymesh {

/// The boundary faces of a mesh as they are to OpenFOAM.
std::vector<FaceGeometry> boundaryGeometry(const PolyMesh& mesh);

/// What came of keeping the volume.
struct KeptVolume {
    Label moved = 0;            // faces, or groups of pieces
    double missing = 0;         // [m^3] by which the mesh holds too much in the end
    std::vector<Label> notKept; // undivided faces that do not hold what they should; ascending
};

/// A warped boundary face encloses another volume when it is divided. Moves the points of boundary
/// faces along their normals so that the divided boundary holds what the undivided one held, face
/// by face: `undivided` has the faces that those of the mesh are, or are pieces of; `from` tells,
/// for each boundary face of the mesh, which; pieces follow each other. Where a part would become
/// inverted the face's points go back, and others take over what is missing. Flat faces stay, and
/// those of cells for which `fates` (one a cell, or empty) says that they are not divided.
/// Cost: linear in the boundary; parallel. The same
/// bytes for any number of threads.
KeptVolume keepVolume(const PolyMesh& mesh,
                      std::span<const Label> from,
                      std::span<const FaceGeometry> undivided,
                      std::span<const Fate> fates,
                      SubdivisionPlan& plan);

} // namespace polymesh
