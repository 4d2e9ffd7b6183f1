// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace polymesh {

/// The shape of an edge between two block vertices: the points at ascending parameters in [0, 1]
/// between `start` and `end`.
using Curve = std::function<std::vector<Vec3>(
    const Vec3& start, const Vec3& end, std::span<const double> parameters)>;

/// The straight line.
Curve lineCurve();

/// The circular arc through a point between its ends; the parameter is the share of the angle.
/// A point on the circle, but not between the ends, gives the arc on its side of the start.
/// Throws InputError that begins with `where` when the three points lie on a line.
Curve arcThrough(const Vec3& middle, std::string where);

/// The shorter circular arc about a centre, which is moved along the bisector of the chord when it
/// is not equally far from both ends. Throws InputError as above when the arc is not determined.
Curve arcAbout(const Vec3& centre, std::string where);

/// Straight lines from the start through the knots to the end; the parameter is the share of the
/// length.
Curve polyLineCurve(std::vector<Vec3> knots);

/// A uniform Catmull-Rom spline through the knots. The parameter is the share of the length of the
/// straight lines between them; beyond the ends the end segments are reflected.
Curve splineCurve(std::vector<Vec3> knots);

/// A uniform cubic B-spline with the knots as control points, otherwise as splineCurve.
Curve bSplineCurve(std::vector<Vec3> knots);

} // namespace polymesh
