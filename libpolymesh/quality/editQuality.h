// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <span>
#include <vector>

namespace polymesh {

/// How bad a group of cells is. `invalid` counts what no solver can take: cells without a positive
/// volume, cells whose area vectors all lie in one plane
/// (bent faces), and faces without area; no other gain makes up for one more of them. `failures`
/// counts what OpenFOAM's checkMesh fails by default (wrong face pyramids, non-orthogonality from
/// 90 deg, skewness over 4, volume not positive, aspect ratio over 1000); `severity` adds up how
/// far measures are beyond limits somewhat stricter than those, so that it is 0 for healthy cells.
struct Badness {
    Label invalid = 0;
    Label failures = 0;
    double severity = 0;

    bool operator==(const Badness&) const = default;
};

/// True when a change from `before` to `after` does no harm: nothing more invalid, no more
/// failures, and either nothing beyond the strict limits or no more of it.
bool isNoWorse(const Badness& after, const Badness& before);

/// True when a change makes things better: fewer failures, or as many and clearly less severe.
bool isBetter(const Badness& after, const Badness& before);

/// The badness of the cells and of all their faces, each face once. Frozen and removed cells are
/// passed over, and of their faces only the sides of edited cells count.
Badness badnessOf(MeshEditor& editor, std::span<const Label> cells);

/// True when a cell or one of its faces is counted as a failure.
bool isFailing(MeshEditor& editor, Label cell);

/// The cells that are failing, in order. Cost: all cells are looked at, in parallel.
std::vector<Label> failingCells(MeshEditor& editor);

/// The cells that have a face in common with the given ones, and these: ascending, no frozen ones.
std::vector<Label> withNeighbours(const MeshEditor& editor, std::span<const Label> cells);

} // namespace polymesh
