// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/box.h"
#include "libpolymesh/surface/triSurface.h"

#include <vector>

namespace polymesh {

inline Box triangleBox(const TriSurface& surface, Label t) {
    Box box;
    for (int i = 0; i < 3; ++i)
        box.add(surface.corner(t, i));
    return box;
}

/// One box per triangle.
inline std::vector<Box> triangleBoxes(const TriSurface& surface) {
    std::vector<Box> boxes(surface.triangles.size());
    parallelFor(surface.triangleCount(),
                [&](Label t) { boxes[index(t)] = triangleBox(surface, t); });
    return boxes;
}

} // namespace polymesh
