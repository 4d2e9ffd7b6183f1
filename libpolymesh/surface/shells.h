// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/rows.h"
#include "libpolymesh/geometry/box.h"
#include "libpolymesh/surface/triSurface.h"

#include <array>
#include <vector>

namespace polymesh {

/// The closed, consistently oriented parts of a surface, each as small as possible: two cubes that
/// share an edge are two shells.
struct Shells {
    Rows<Label> triangles;                  // one row per shell, ascending
    std::vector<Box> box;                   // one per shell
    std::vector<int> orientation;           // 1 outward, -1 inward, 0 without volume
    std::vector<std::vector<Vec3>> extreme; // points furthest along axes and diagonals
    Label openParts = 0;                    // parts that are not closed

    Label count() const { return triangles.size(); }
};

/// Cost: O(n log n).
Shells findShells(const TriSurface& surface);

/// True when shell `inner` lies in shell `outer`, as far as its extreme points tell; points on
/// `outer` are not asked. Exact for these points. Cost: O(size of outer) unless the boxes answer.
bool isInside(const TriSurface& surface, const Shells& shells, Label inner, Label outer);

} // namespace polymesh
