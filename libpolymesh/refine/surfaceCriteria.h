// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/refine/criterion.h"
#include "libpolymesh/refine/nearTriangles.h"

#include <memory>
#include <vector>

namespace polymesh {

/// Cells near the triangles: each shell is a distance, which a cell of less than its level must not
/// be within. The level at distance 0 is that of the cells that the surface passes.
Criterion distanceCriterion(std::shared_ptr<const NearTriangles> near, std::vector<Shell> shells);

struct CurvatureLimits {
    double cellsPerRadius = 4;
    int level = 0;           // not beyond
    double featureAngle = 0; // sharper edges are no curvature [rad]
};

/// Cells that the surface passes where its radius of curvature is less than so many cells.
Criterion curvatureCriterion(std::shared_ptr<const NearTriangles> near,
                             const CurvatureLimits& limits);

struct FeatureLimits {
    double angle = 0; // edges are sharp when normals differ by more [rad]
    Shell shell;
};

/// Cells near sharp edges, and near edges that bound the surface.
Criterion featureCriterion(const TriSurface& surface, const FeatureLimits& limits);

struct GapLimits {
    double cells = 3; // across a gap
    int level = 0;    // not beyond
};

/// Cells in gaps: between two parts of the surface that face each other, inside it or outside.
Criterion gapCriterion(std::shared_ptr<const NearTriangles> near, const GapLimits& limits);

} // namespace polymesh
