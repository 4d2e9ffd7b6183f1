// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"

#include <vector>

namespace polymesh {

/// An internal face out of order, with what it was.
struct LooseFace {
    Label owner;
    Label neighbour;
    std::vector<Label> loop;
    Label source; // face of the old mesh, or -1
    bool isTurned = false;
};

/// The internal faces of a mesh.
std::vector<LooseFace> internalFaces(const PolyMesh& mesh);

/// Gives the mesh these internal faces, in OpenFOAM's order, before its boundary faces, whose
/// owners are those of the mesh. Zones of faces follow; they lose faces that are not there any
/// more. Cost: linear but for the sorting.
void setInternalFaces(PolyMesh& mesh, std::vector<LooseFace>& loose);

} // namespace polymesh
