// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/fate.h"
#include "libpolymesh/mps/halvedFace.h"
#include "libpolymesh/mps/midPointSubdivision.h"

#include <cstdint>
#include <span>
#include <vector>

namespace polymesh {

/// Which edges of a planned mesh are halved: those of the cells that are divided.
class HalvedFaces {
public:
    /// Keeps references to the mesh and its plan.
    HalvedFaces(const PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Fate> fates);

    bool hasHalvedEdge(Label cell) const;

    /// The pieces of a face of a hexahedron, in points of the divided mesh.
    HalvedPieces piecesOf(Label face) const;

private:
    const PolyMesh& mesh_;
    const SubdivisionPlan& plan_;
    std::vector<std::uint8_t> isHalved_; // edges
};

} // namespace polymesh
