// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"
#include "libpolymesh/shapes/recognise.h"

#include <span>

namespace polymesh {

/// A trimmed cell can often be seen as its base shape in several ways, since the face graph has
/// symmetries that the hexahedron it was cut from does not have, and sammTrim1 and sammTrim3 have
/// the same graph. Of these ways this takes the one in which the faces that would be on opposite
/// sides of the hexahedron are the most nearly parallel, and those beside them upright; so it finds
/// the parent exactly when its faces are parallel, and well when they are nearly so. `cutFace`, if
/// not empty, has the points of the face that is known not to be the hexahedron's (one on the
/// boundary, say): only ways that make it the cut count, if there are any. Cells that are no
/// trimmed ones, or have collapsed edges, come back as they are. Cost: some microseconds. Equal for
/// equal input, whatever the numbering of points where there is one best way.
Recognition fitToParent(const Recognition& found,
                        std::span<const Vec3> points,
                        std::span<const Label> cutFace = {});

} // namespace polymesh
