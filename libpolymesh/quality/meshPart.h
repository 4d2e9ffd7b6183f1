// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/quality/editMesh.h"

#include <span>
#include <vector>

namespace polymesh {

/// A part of a PolyMesh, to be edited by cuts: nothing of it is removed, nothing moves.
/// The `patch` of an EditFace is here the face of the PolyMesh that it is a part of, for internal
/// ones too (-1: a new one), and its corners run as those of that face; the `origin` of an EditCell
/// is its cell.
struct MeshPart {
    EditMesh mesh;
    std::vector<Label> points; // [the first points of `mesh`] label in the PolyMesh
    std::vector<Label> cells;  // [the first cells of `mesh`] label in the PolyMesh; ascending
    std::vector<Label> faces;  // [the first faces of `mesh`] label in the PolyMesh; ascending
};

/// The cells, all that share a point with them, and as frozen ones the neighbours of those.
/// Requires: a valid mesh. Cost: linear, a small constant for what is not in the part; parallel.
MeshPart partRound(const PolyMesh& mesh, std::span<const Label> cells);

/// A mesh into which a part has been put back.
struct JoinedPart {
    PolyMesh mesh;
    std::vector<Label> cells;   // [cells of the part] label in the mesh; -1: removed
    std::vector<Label> origins; // [cells of the mesh] label before the part was edited
};

/// Puts an edited part back: new points and cells come last, all orders are OpenFOAM's, parts of
/// faces and cells belong to the patches and zones of the whole.
JoinedPart withPart(const PolyMesh& mesh, const MeshPart& part);

} // namespace polymesh
