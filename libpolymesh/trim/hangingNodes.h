// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"

#include <array>
#include <span>
#include <vector>

namespace polymesh {

/// A point that hangs on an edge or a face of a cell: where the cell is straight. It stays where it
/// is between its two neighbours there.
struct HangingNode {
    Label node = -1;
    std::array<Label, 2> ends{}; // its neighbours
    double weight = 0;           // of the second one
    Vec3 offset;                 // from the line between them [m]

    Vec3 place(const std::vector<Vec3>& points) const {
        const Vec3& a = points[index(ends[0])];
        return a + weight * (points[index(ends[1])] - a) + offset;
    }
};

/// Appends the points that hang in this cell: those whose faces in the cell have fewer than three
/// directions, 20 degrees apart or more. A cell of six quadrilaterals has none.
/// Cost: O(corners of the cell).
void findHanging(const PolyMesh& mesh,
                 Label cell,
                 std::span<const Label> cellFaces,
                 std::vector<HangingNode>& found);

} // namespace polymesh
