// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/joinFaces.h"
#include "libpolymesh/initial/meshParts.h"

#include <vector>

namespace polymesh {

/// Throws InputError, which begins with the place of a part and names one in space, where
/// (1) cells of two parts overlap by more than a tenth of their shortest edge;
/// (2) boundary faces of two parts that are not in `pairs` look at each other over a gap of less
///     than a fifth of their shortest edge: they touch with different grids, or just miss.
/// Cells are taken for convex. Cost: O(n log n) in the cells of those parts whose boxes overlap,
/// and in the boundary faces.
void refuseMisfits(const PolyMesh& mesh,
                   const std::vector<MeshPart>& parts,
                   const std::vector<FacePair>& pairs);

/// How far a part is from another one.
struct Gap {
    double distance = 0; // [m]
    Vec3 place;          // a boundary point of the part
    Label otherPart = -1;
};

/// The shortest way from a boundary point of a part to one of a part of another group.
Gap nearestOther(const PolyMesh& mesh,
                 const std::vector<MeshPart>& parts,
                 const std::vector<Label>& group,
                 Label part);

} // namespace polymesh
