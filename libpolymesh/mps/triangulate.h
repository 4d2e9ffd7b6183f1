// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/vec3.h"

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace polymesh {

/// Three points; the right-hand rule gives the sense.
using Triangle = std::array<Label, 3>;

/// Whether a diagonal between two points is allowed.
using MayJoin = std::function<bool(Label, Label)>;

/// How good a triangle is; 0 or less: not at all.
using TriangleQuality = std::function<double(Label, Label, Label)>;

/// The triangulation of a polygon by diagonals whose worst triangle is best. Empty when every
/// triangulation has a triangle that is no good. Cost: cubic in the corners.
std::vector<Triangle>
triangulate(std::span<const Label> polygon, const MayJoin& mayJoin, const TriangleQuality& quality);

/// The same where a triangle counts by its area along the polygon's normal and the squares of its
/// sides, so that none lies on its back.
std::vector<Triangle>
triangulate(std::span<const Vec3> points, std::span<const Label> polygon, const MayJoin& mayJoin);

} // namespace polymesh
