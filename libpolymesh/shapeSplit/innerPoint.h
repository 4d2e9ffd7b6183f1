// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <optional>
#include <vector>

namespace polymesh {

/// True when the point sees the inner side of a face of the cell: the face has a triangulation by
/// its own points in which every triangle and the point make a tetrahedron of positive volume, by
/// exact signs, and so has the whole pyramid by OpenFOAM's definition. Cost: cubic in the points of
/// the face, for faces that look convex linear.
bool isSeenFrom(MeshEditor& editor, Label cell, Label face, const Vec3& point);

/// True when a polygon has a triangulation by its own corners in which the point is on the side of
/// every triangle to which its normal points, by exact signs: when the polygon, seen from the
/// point, does not cross itself and runs anticlockwise.
bool isSimpleSeenFrom(std::vector<Vec3> corners, const Vec3& point);

/// A point inside a cell that sees all of its faces; of such points one far from them is sought.
/// None where the search finds none. Cost: some ten microseconds; up to a millisecond where there
/// is none.
std::optional<Vec3> innerPoint(MeshEditor& editor, Label cell);

/// Several points that see all faces, if there are, in different parts of the cell; innerPoint's
/// first. Cost: some hundred microseconds.
std::vector<Vec3> innerPoints(MeshEditor& editor, Label cell);

/// A point that is behind each face of a cell as a whole: every pyramid has a positive volume by
/// OpenFOAM's definition, though a warped face may be folded, seen from the point.
std::optional<Vec3> pointBehindFaces(MeshEditor& editor, Label cell);

} // namespace polymesh
