// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/editMesh.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/meshEditor.h"

#include <array>
#include <functional>
#include <utility>

namespace polymesh::test {

/// A box of n[0] x n[1] x n[2] hexahedra with edges of `h`, one corner at the origin; the sides are
/// the patches 0 (x low) ... 5 (z high).
EditMesh boxOfHexes(std::array<Label, 3> n, double h);

/// Cuts all cells by the plane normal . x = distance and keeps both parts. A point on the plane
/// counts as below it, so that a plane through points makes points, faces and cells of zero size.
/// The cells must be convex. Returns the number of cells that were cut.
Label splitByPlane(EditMesh& mesh, const Vec3& normal, double distance);

/// Removes the cells for which `isGone` says so of their centre; what they leave bare gets `patch`.
void removeCells(EditMesh& mesh, Label patch, const std::function<bool(const Vec3&)>& isGone);

/// Ranks the points by what the boundary faces are at them (features: 30 degrees, or two patches).
void rankPoints(EditMesh& mesh);

/// splitByPlane, then removeCells above the plane, then rankPoints.
void cutByPlane(EditMesh& mesh, const Vec3& normal, double distance, Label patch);

/// Merges the pieces of each hexahedron of a box with edges of 1 into one cell again, convex or
/// not.
void rejoinPieces(EditMesh& mesh);

/// What a function of clean-up returns for a whole mesh.
template<class Function, class... Arguments>
auto edit(Function&& function, EditMesh& mesh, Arguments&&... arguments) {
    MeshEditor editor(mesh);
    return function(editor, std::forward<Arguments>(arguments)...);
}

/// Sum of the volumes of all cells that are not frozen [m^3].
double totalVolume(EditMesh& mesh);

/// Of all cells together.
Badness totalBadness(EditMesh& mesh);

Label liveCells(const EditMesh& mesh);
Label liveFaces(const EditMesh& mesh);

/// Points with the same coordinates get the label of the first of them.
std::vector<Label> coincidentPoints(const EditMesh& mesh);

} // namespace polymesh::test
