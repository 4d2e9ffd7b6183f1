// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/blocks.h"

#include <array>

namespace polymesh {

/// A box along the axes, in one block. Patches: xMin, xMax, yMin, ... zMax.
struct GradedBox {
    Box box;
    std::array<Label, 3> cells{1, 1, 1};
    std::array<Grading, 3> grading{}; // along x, y and z
};

BlockMeshDescription boxBlocks(const GradedBox& box);

/// A cylinder: solid, with a square core of cells in the middle; or with a hole; or a sector of
/// either, solid sectors meeting in prisms at the axis. Patches: bottom (at end1), top, side, hole,
/// and sectorMin, sectorMax.
struct CylinderSpec {
    Vec3 end1;
    Vec3 end2;
    double radius = 1;                   // [m]
    double holeRadius = 0;               // [m]; 0: solid
    double core = 0.5;                   // corner of the core, in parts of the radius, in (0, 1)
    double angle = 0;                    // of the sector [rad]; 0: the whole
    std::array<Label, 3> cells{1, 4, 1}; // outwards (from the core), around, along
    std::array<Grading, 2> grading{};    // outwards and along
};

/// Requires: different ends, 0 <= holeRadius < radius, angle below 2 pi, cells at least 1; cells
/// around a multiple of arcCount.
BlockMeshDescription cylinderBlocks(const CylinderSpec& cylinder);

/// The number of blocks around a cylinder: each spans a right angle at most.
Label arcCount(const CylinderSpec& cylinder);

/// A ball: a cube of cells in the middle and six blocks around it. Patch: sphere.
struct BallSpec {
    Vec3 centre;
    double radius = 1;                // [m]
    double core = 0.5;                // corner of the cube, in parts of the radius, in (0, 1)
    std::array<Label, 2> cells{1, 1}; // outwards from the cube, along each of its edges
    Grading grading;                  // outwards
};

BlockMeshDescription ballBlocks(const BallSpec& ball);

} // namespace polymesh
