// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/forest.h"

#include "libpolymesh/refine/mpi.h"

#include <array>
#include <memory>

// p4est's headers cast as C does.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include <p8est_extended.h>
#pragma GCC diagnostic pop

namespace polymesh {
namespace {

struct Destroy {
    void operator()(p8est_connectivity_t* connectivity) const {
        p8est_connectivity_destroy(connectivity);
    }

    void operator()(p8est_t* forest) const { p8est_destroy(forest); }
};

using Connectivity = std::unique_ptr<p8est_connectivity_t, Destroy>;
using Forest = std::unique_ptr<p8est_t, Destroy>;

/// p4est's code of how a side lies to the one across: its number, and which corner of the higher
/// numbered side the first corner of the lower numbered one is.
std::int8_t sideCode(const MacroMesh& mesh, Label tree, int side, Label other) {
    int back = 0;
    while (mesh.neighbour(other, static_cast<std::size_t>(back)) != tree)
        ++back;
    const bool ownIsLower = side <= back;
    const Label lower = ownIsLower ? tree : other;
    const Label upper = ownIsLower ? other : tree;
    const int* lowerCorners = p8est_face_corners[ownIsLower ? side : back];
    const int* upperCorners = p8est_face_corners[ownIsLower ? back : side];
    const Label first = mesh.corners(lower)[static_cast<std::size_t>(lowerCorners[0])];
    int at = 0;
    while (mesh.corners(upper)[static_cast<std::size_t>(upperCorners[at])] != first)
        ++at;
    return static_cast<std::int8_t>(back + 6 * at);
}

/// Sides only: edges and corners are p4est's business when it balances, and only then.
Connectivity connectivityOf(const MacroMesh& mesh, bool withPoints) {
    const p4est_topidx_t trees = mesh.cellCount();
    const p4est_topidx_t points = withPoints ? mesh.pointCount() : 0;
    Connectivity result(p8est_connectivity_new(points, trees, 0, 0, 0, 0));
    for (Label tree = 0; tree < trees; ++tree)
        for (int side = 0; side < 6; ++side) {
            const Label other = mesh.neighbour(tree, static_cast<std::size_t>(side));
            result->tree_to_tree[6 * tree + side] = other < 0 ? tree : other;
            result->tree_to_face[6 * tree + side] =
                other < 0 ? static_cast<std::int8_t>(side) : sideCode(mesh, tree, side, other);
        }
    if (!withPoints) return result;
    std::fill(result->vertices, result->vertices + 3 * points, 0.0);
    for (Label tree = 0; tree < trees; ++tree)
        std::ranges::copy(mesh.corners(tree), result->tree_to_vertex + 8 * tree);
    p8est_connectivity_complete(result.get());
    return result;
}

constexpr int shift = P8EST_MAXLEVEL - latticeBits; // p4est's lattice is finer

/// p4est asks for its octants in the order of the lists, so each needs to be looked at once.
struct Cursors {
    const RefinedOctants& refined;
    std::array<std::size_t, mostLevel> at{};

    bool isNext(Label tree, const LatticePoint& anchor, int level) {
        const auto l = static_cast<std::size_t>(level);
        if (at[l] == refined[l].size() || refined[l][at[l]] != octantKey(tree, anchor))
            return false;
        ++at[l];
        return true;
    }
};

LatticePoint anchorOf(const p8est_quadrant_t& octant) {
    return {octant.x >> shift, octant.y >> shift, octant.z >> shift};
}

int isDivided(p8est_t* forest, p4est_topidx_t tree, p8est_quadrant_t* octant) {
    auto* cursors = static_cast<Cursors*>(forest->user_pointer);
    return cursors->isNext(tree, anchorOf(*octant), octant->level) ? 1 : 0;
}

Forest forestOf(p8est_connectivity_t* connectivity, const RefinedOctants& refined) {
    Cursors cursors{refined};
    Forest forest(p8est_new_ext(MPI_COMM_SELF, connectivity, 0, 0, 1, 0, nullptr, &cursors));
    p8est_refine_ext(forest.get(), 1, mostLevel, isDivided, nullptr, nullptr);
    forest->user_pointer = nullptr;
    return forest;
}

Leaves leavesOf(const p8est_t& forest) {
    Leaves leaves;
    leaves.codes.reserve(static_cast<std::size_t>(forest.local_num_quadrants));
    for (p4est_topidx_t t = 0; t < forest.connectivity->num_trees; ++t) {
        leaves.first.push_back(leaves.cellCount());
        const p8est_tree_t* tree = p8est_tree_array_index(forest.trees, t);
        const auto* octants =
            static_cast<const p8est_quadrant_t*>(static_cast<const void*>(tree->quadrants.array));
        for (std::size_t i = 0; i < tree->quadrants.elem_count; ++i)
            leaves.codes.push_back(octantCode({anchorOf(octants[i]), octants[i].level}));
    }
    leaves.first.push_back(leaves.cellCount());
    return leaves;
}

} // namespace

Leaves growForest(const MacroMesh& mesh, const RefinedOctants& refined) {
    startMpi();
    const Connectivity connectivity = connectivityOf(mesh, false);
    return leavesOf(*forestOf(connectivity.get(), refined));
}

Leaves growBalancedForest(const MacroMesh& mesh, const RefinedOctants& refined) {
    startMpi();
    const Connectivity connectivity = connectivityOf(mesh, true);
    const Forest forest = forestOf(connectivity.get(), refined);
    p8est_balance(forest.get(), P8EST_CONNECT_FULL, nullptr);
    return leavesOf(*forest);
}

} // namespace polymesh
