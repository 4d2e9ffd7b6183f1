// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/midPointSubdivision.h"

#include <span>
#include <vector>

namespace polymesh {

/// A new face between two parts of a cell; the loop runs round as seen from outside of `inside`.
struct CellWall {
    std::vector<Label> loop; // -1 - k: the cell's new point k
    int inside = -1;         // groups
    int outside = -1;
};

/// A cell cut into parts: its faces in groups, each group with new walls a cell. Without walls, the
/// triangles from the rims of the groups to the first new point.
struct CellCones {
    Label cell = -1;
    std::vector<Vec3> points; // [m] new, within
    std::vector<int> groupOf; // beside the cell's faces (topology.h): 0 ...
    int groupCount = 0;
    std::vector<CellWall> walls = {};
};

/// Finds cones for those of `cells` (ascending) whose parts would be inverted as they are but not
/// in the cones: one a face over a point that sees them all, then joined as long as no part
/// becomes inverted and there are fewer parts. Cells without such a point are left out.
/// Cost: about 1 ms a cell and core.
std::vector<CellCones> conesOf(const PolyMesh& mesh,
                               const Bends& bends,
                               const SubdivisionPlan& plan,
                               std::span<const Label> cells);

/// The mesh with these cells, ascending, replaced by their cones: the first has the cell's label,
/// the others follow the mesh's cells. Faces, patches and points stay; zones of cells and faces go
/// on. Cost: linear.
PolyMesh withCones(PolyMesh mesh, const Rows<Label>& cellFaces, std::span<const CellCones> cones);

} // namespace polymesh
