// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/triangulate.h"
#include "libpolymesh/surface/tetMesh.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace polymesh {

/// The triangles of a polyhedron with points of its own, seen from outside.
struct TriangleHull {
    std::vector<Label> labels; // of the first points, in the mesh
    std::vector<Vec3> points;  // [m]
    std::vector<Triangle> triangles;
};

/// A point within that sees all triangles, if there is one. Cost: about 10 us.
std::optional<Vec3> pointThatSees(const TriangleHull& hull);

/// The pairs of its triangles that cross: where none do, tetrahedra fill it. Exact.
/// Cost: about 50 us for 30 triangles.
std::vector<std::array<Label, 2>> crossingPairs(const TriangleHull& hull);
Label crossingsOf(const TriangleHull& hull);

/// The tetrahedra that fill a cell with triangles for faces; `hull` has them in the order of the
/// cell's faces. None where there are none or they do not fit.
std::optional<CellCones>
tetrahedraIn(Label cell, const TriangleHull& hull, const Tetrahedraliser& tetrahedralise);

} // namespace polymesh
