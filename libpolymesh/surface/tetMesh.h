// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/vec3.h"
#include "libpolymesh/surface/triSurface.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace polymesh {

/// Tetrahedra that fill a closed TriSurface: its points come first, then those inside.
/// The four points of a tetrahedron may come in either orientation.
struct TetMesh {
    std::vector<Vec3> newPoints;                  // [m] labelled on from the surface's points
    std::vector<std::array<Label, 4>> tetrahedra; // point labels
};

/// Fills a closed surface with tetrahedra that leave its triangles as they are, where it can; what
/// it makes is checked. An empty function finds none.
using Tetrahedraliser = std::function<std::optional<TetMesh>(const TriSurface&)>;

} // namespace polymesh
