// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/box.h"
#include "libpolymesh/mesh/polyMesh.h"

namespace polymesh {

/// The box round all points of a mesh [m]. Cost: O(points), in parallel.
inline Box boundingBox(const PolyMesh& mesh) {
    const auto unite = [](Box a, const Box& b) {
        a.add(b);
        return a;
    };
    const auto boxOf = [&](Label p) {
        Box box;
        box.add(mesh.points[index(p)]);
        return box;
    };
    return parallelReduce(mesh.pointCount(), Box{}, boxOf, unite);
}

} // namespace polymesh
