// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the tests of the ways to adjust nodes share.

#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/surface/triangleBoxes.h"
#include "libpolymesh/trim/adjustGuard.h"
#include "libpolymesh/trim/adjustNodes.h"
#include "tests/support/surfaces.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace polymesh::test {

inline AdjustedNodes
adjust(PolyMesh& mesh, const TriSurface& surface, const AdjustOptions& options) {
    const CuttingSurface cutter{&surface, pairEdges(surface), triangleBoxes(surface)};
    return adjustNodes(mesh, cutter, findFeatures(surface, cutter.edges, 0.5236), options);
}

/// The smallest part of any cell, of what is a part of a cube.
inline double worstCell(const PolyMesh& mesh) {
    const Rows<Label> faces = cellFaces(mesh);
    double worst = 1;
    for (Label c = 0; c < mesh.cellCount; ++c)
        worst = std::min(worst, smallestPart(mesh, c, faces[c], 0).smallest);
    return worst;
}

/// A cuboid that stands askew in the unit box: many edges of a grid pass its edges closely.
inline TriSurface skewCuboid(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> angle(0, 3);
    const double a = angle(random);
    const double b = angle(random);
    TriSurface surface = cuboid({-0.27, -0.22, -0.18}, {0.27, 0.22, 0.18});
    for (Vec3& p : surface.points) {
        p = {std::cos(a) * p.x - std::sin(a) * p.y, std::sin(a) * p.x + std::cos(a) * p.y, p.z};
        p = {p.x, std::cos(b) * p.y - std::sin(b) * p.z, std::sin(b) * p.y + std::cos(b) * p.z};
        p += {0.5, 0.51, 0.49};
    }
    return surface;
}

} // namespace polymesh::test
