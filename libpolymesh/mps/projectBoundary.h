// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/midPointSubdivision.h"
#include "libpolymesh/surface/triSurface.h"

namespace polymesh {

/// What a projection did.
struct ProjectionCounts {
    Label moved = 0;        // new boundary points that were put onto the surface
    Label onFeatures = 0;   // of those, onto its feature edges
    Label refused = 0;      // taken back, since a part would have been inverted
    double largestMove = 0; // [m]
};

/// Puts the new boundary points of a plan onto the surface (paper, section 5): middles of edges
/// where two patches meet or that are sharper than `featureAngle` [rad] onto the closest feature
/// edge, other middles and the points of faces onto the closest point. A point that would move by
/// more than a quarter of its edge, or half the root of its face's area, stays, as do all points of
/// a cell that would get an inverted part by it. Points of the mesh itself stay. Cells that are
/// inverted already are not looked at. The same result for any number of threads. Throws InputError
/// for a surface that is not closed. Cost: O(boundary log triangles).
ProjectionCounts projectBoundary(const PolyMesh& mesh,
                                 SubdivisionPlan& plan,
                                 const TriSurface& surface,
                                 double featureAngle);

} // namespace polymesh
