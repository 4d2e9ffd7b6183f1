// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/midPointSubdivision.h"

#include <span>
#include <vector>

namespace polymesh {

/// Marks, with one char for each part, the parts of cells that are boxes along the axes, ten times
/// longer than wide at most, with all new points where they are by default to 1e-6: these parts and
/// the faces between them are within all limits. Cost: O(face corners); parallel.
std::vector<char> partsOfBoxes(const PolyMesh& mesh, const SubdivisionPlan& plan);

/// What OpenFOAM's checkMesh would fail, and what was done about it.
struct RelaxCounts {
    Label offenders = 0; // cells too stretched, faces too skew or with wrong pyramids
    Label left = 0;      // of them, after
    Label moved = 0;     // points
};

/// Moves new points (those from `firstNew` on) of a divided mesh for the sake of cells and faces
/// that OpenFOAM's checkMesh fails: points inside the domain, and those of the boundary along it,
/// in one patch and where it is as good as flat, such that the volume stays to rounding.
/// A move is made only if no cell or face comes to be beyond a limit, or further beyond one than it
/// is, and none becomes less convex but for parts far from being inverted (pointStar.h).
/// `isGood`: parts that need no look (partsOfBoxes), or none. The same bytes for any number of
/// threads. Cost: a look at the other parts, then about a millisecond for each offender.
RelaxCounts relaxPoints(PolyMesh& mesh, Label firstNew, std::span<const char> isGood = {});

} // namespace polymesh
