// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/vec3.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/quality/metrics.h"

#include <string>
#include <vector>

namespace polymesh {

/// The directions that a mesh extends in: `empty` patches take a direction out of both, `wedge`
/// patches out of the geometric ones only.
struct MeshDirections {
    Directions geometric{true, true, true};
    Directions solution{true, true, true};
};

MeshDirections meshDirections(const PolyMesh& mesh, const MeshGeometry& geometry);

/// A `wedge` patch: one of two planes about a coordinate plane.
struct Wedge {
    std::string name;
    double angle = 0; // [rad] from its coordinate plane
};

/// Whether the edges of a mesh with fewer than three directions keep to them or to the others.
struct EdgeAlignment {
    std::vector<Wedge> wedges;
    std::string wedgeFault;    // what is wrong with the wedge patches; else empty
    Label edgeCount = 0;       // edges out of line
    std::vector<Label> points; // of those edges, ascending

    bool isOk() const { return wedgeFault.empty() && edgeCount == 0; }
};

/// OpenFOAM's tests: an edge may not have components (over 1e-6 of its length) both in a missing
/// and in an extant direction, nor in two missing ones. Wedge patches' own edges are exempt.
EdgeAlignment
edgeAlignment(const PolyMesh& mesh, const MeshGeometry& geometry, const MeshDirections& directions);

} // namespace polymesh
