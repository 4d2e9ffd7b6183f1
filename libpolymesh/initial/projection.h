// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/box.h"
#include "libpolymesh/initial/curves.h"
#include "libpolymesh/surface/triSurface.h"

#include <array>
#include <functional>
#include <vector>

namespace polymesh {

/// A surface that points of blocks are projected onto.
struct Shape {
    std::function<Vec3(const Vec3&)> nearest; // the point of the surface closest to a point
    Box bounds;
};

Shape sphereShape(const Vec3& centre, double radius);

/// The wall and the two discs of a cylinder. Requires: different ends.
Shape cylinderShape(const Vec3& end1, const Vec3& end2, double radius);

/// The six sides of a box along the axes.
Shape boxShape(const Box& box);

/// A rectangle along the axes: one component of the span is 0.
Shape plateShape(const Vec3& corner, const Vec3& span);

/// A triangulated surface, which the shape keeps.
Shape surfaceShape(TriSurface surface);

/// A block vertex moved onto the shape, unless the shape is farther away than it is large: this is
/// the rule of OpenFOAM's blockMesh, and dictionaries rely on it.
Vec3 projectedVertex(const Vec3& vertex, const Shape& shape);

/// An edge on the shape: points of the straight edge, projected and then shifted until their
/// distances along the edge are in the ratios of the parameters, at most ten times and until the
/// shifts are a tenth of the first ones (or 5e-5 [m before scaling] each), as blockMesh does.
Curve projectedCurve(Shape shape);

/// The points of a block face, `counts[0]` in each of `counts[1]` rows, moved onto the shape. The
/// inner ones keep their share of the length along their row and column, by the rule above.
void projectFace(std::vector<Vec3>& points, std::array<std::size_t, 2> counts, const Shape& shape);

} // namespace polymesh
