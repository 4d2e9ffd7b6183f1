// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/bends.h"

#include <span>
#include <vector>

namespace polymesh {

/// A mesh of which cells and boundary faces know what they come from.
struct EditedMesh {
    PolyMesh mesh;
    Bends bends;
    std::vector<Label> cellFrom;       // beside the cells: cell of another mesh; the first of those
                                       // from one cell has its place
    std::vector<Label> boundaryFrom;   // beside the boundary faces: face of another mesh
    std::vector<Label> boundaryOrigin; // likewise: face of the mesh before all; -1 at the rim
    Label rimFaces = 0; // so many of the last boundary faces have cells of the other mesh behind
};

/// A mesh that nothing has been done to yet.
EditedMesh unedited(PolyMesh mesh);

/// The part of a mesh round some cells, a mesh of its own: with the patches and zones of the whole,
/// and the faces to the rest of it in a last patch.
struct MeshRegion {
    EditedMesh part;           // cells and boundary faces from the whole, ascending
    std::vector<Label> points; // of the first points of the part; label in the whole; ascending
    Bends bends;               // of the part, with the labels of the whole
};

/// The region of `cells`, all that share a point with one of them, and all that share one with
/// those. Cost: linear with a small
/// constant for what is not in the region.
MeshRegion regionRound(const EditedMesh& whole, std::span<const Label> cells);

/// A mesh into which a region has been put back.
struct JoinedRegion {
    EditedMesh whole;
    std::vector<Label> cells; // beside those of the part; label in the whole
};

/// Puts an edited region back: new points and cells come last, all orders are OpenFOAM's, zones and
/// origins follow. Requires: the part has the points of `region` first, and its rim as it was.
/// Cost: linear.
JoinedRegion withRegion(const EditedMesh& whole, const MeshRegion& region, const EditedMesh& part);

} // namespace polymesh
