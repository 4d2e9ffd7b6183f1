// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/refine/macroMesh.h"

namespace polymesh {

/// Calls visit(tree, octant) for the octants of the same size that touch an octant of a tree on
/// the given side: step holds -1, 0 or 1 for each direction, not all 0. One inside the tree or
/// across a side, all round an edge or a point between trees (also those across sides: some come
/// more than once), none outside the mesh.
template<class Visit>
void forNeighbours(const MacroMesh& mesh,
                   Label tree,
                   const Octant& octant,
                   const std::array<int, 3>& step,
                   Visit&& visit) {
    Octant moved = octant;
    std::array<bool, 3> isOut{};
    std::size_t side = 0;
    std::size_t corner = 0; // at which the octant leaves the tree
    int outCount = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        moved.anchor[axis] += step[axis] * octant.size();
        isOut[axis] = moved.anchor[axis] < 0 || moved.anchor[axis] >= latticeSize;
        if (!isOut[axis]) continue;
        ++outCount;
        side = 2 * axis + (step[axis] > 0 ? 1 : 0);
        if (step[axis] > 0) corner |= std::size_t{1} << axis;
    }
    if (outCount == 0) return visit(tree, moved);
    if (outCount == 1) {
        if (mesh.neighbour(tree, side) < 0) return;
        const Passage passage(mesh, tree, side);
        return visit(passage.cell(), passage.octant(moved));
    }
    // In another tree at the edge or point, where its own corner says which way is inside.
    const auto placed = [&](std::size_t there) {
        Octant other{{}, octant.level};
        for (std::size_t axis = 0; axis < 3; ++axis)
            if ((there >> axis & 1U) != 0) other.anchor[axis] = latticeSize - octant.size();
        return other;
    };
    if (outCount == 3) {
        const Label point = mesh.corners(tree)[corner];
        for (const Label other : mesh.cellsAt(point))
            if (other != tree) visit(other, placed(mesh.cornerAt(other, point)));
        return;
    }
    const std::size_t along = !isOut[0] ? 0 : !isOut[1] ? 1 : 2;
    const std::array<std::size_t, 2> ends{corner, corner | std::size_t{1} << along};
    mesh.forCellsAtEdge(tree, ends, [&](Label other, std::size_t a, std::size_t b) {
        if (other == tree) return;
        Octant there = placed(a);
        const std::size_t axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
        there.anchor[axis] = (a >> axis & 1U) == 0
                                 ? moved.anchor[along]
                                 : latticeSize - moved.anchor[along] - octant.size();
        visit(other, there);
    });
}

} // namespace polymesh
