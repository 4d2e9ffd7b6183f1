// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/refine/macroMesh.h"

namespace polymesh {

/// An octant moved by its own size, and where that leaves the tree.
struct MovedOctant {
    Octant octant;
    std::size_t side = 0;   // that it left by, of one that left by one side
    std::size_t corner = 0; // of the tree, towards which it left
    std::size_t along = 0;  // the direction in which it stayed, of one that left by two sides
    int outCount = 0;       // directions in which it left

    MovedOctant(const Octant& from, const std::array<int, 3>& step) : octant(from) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            octant.anchor[axis] += step[axis] * from.size();
            if (octant.anchor[axis] >= 0 && octant.anchor[axis] < latticeSize) {
                along = axis;
                continue;
            }
            ++outCount;
            side = 2 * axis + (step[axis] > 0 ? 1 : 0);
            if (step[axis] > 0) corner |= std::size_t{1} << axis;
        }
    }
};

/// The octant in a corner of a tree.
inline Octant octantInCorner(std::size_t corner, int level) {
    Octant octant{{}, level};
    octant.anchor = Octant{}.corner(corner);
    for (std::int32_t& x : octant.anchor)
        x = x == 0 ? 0 : x - octant.size();
    return octant;
}

/// Visits what is round the edge of the tree that an octant left by.
template<class Visit>
void forOctantsAtEdge(const MacroMesh& mesh, Label tree, const MovedOctant& moved, Visit&& visit) {
    const std::size_t along = moved.along;
    const std::array<std::size_t, 2> ends{moved.corner, moved.corner | std::size_t{1} << along};
    const std::int32_t distance = moved.octant.anchor[along];
    mesh.forCellsAtEdge(tree, ends, [&](Label other, std::size_t a, std::size_t b) {
        if (other == tree) return;
        // Its own corner says which way is inside.
        Octant there = octantInCorner(a, moved.octant.level);
        const std::size_t axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
        there.anchor[axis] = there.anchor[axis] == 0 ? distance : there.anchor[axis] - distance;
        visit(other, there);
    });
}

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
    const MovedOctant moved(octant, step);
    if (moved.outCount == 0) return visit(tree, moved.octant);
    if (moved.outCount == 2) return forOctantsAtEdge(mesh, tree, moved, visit);
    if (moved.outCount == 1) {
        if (mesh.neighbour(tree, moved.side) < 0) return;
        const Passage passage(mesh, tree, moved.side);
        return visit(passage.cell(), passage.octant(moved.octant));
    }
    const Label point = mesh.corners(tree)[moved.corner];
    for (const Label other : mesh.cellsAt(point))
        if (other != tree) visit(other, octantInCorner(mesh.cornerAt(other, point), octant.level));
}

} // namespace polymesh
