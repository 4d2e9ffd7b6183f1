// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/arrangement.h"

#include <array>
#include <optional>
#include <span>

namespace polymesh {

/// Three points of a facet that are not collinear (unless all are), in its direction.
std::array<Vec3, 3> planeOf(std::span<const Vec3> facet);

/// Where the mesh edge a b passes through a triangle of the moved surface, if it does. The
/// crossing's triangle is left for the caller to name.
std::optional<EdgeCrossing>
meetTriangle(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& triangle);

/// Where the moved surface edge p q passes through a convex plane facet, if it does. The pierce's
/// facet and edge are left for the caller to name.
std::optional<FacePierce> meetFacet(std::span<const Vec3> facet, const Vec3& p, const Vec3& q);

} // namespace polymesh
