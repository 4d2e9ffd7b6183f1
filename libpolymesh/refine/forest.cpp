// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/forest.h"

#include <algorithm>
#include <array>
#include <memory>

// p4est's headers cast as C does.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include <p8est_algorithms.h>
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
            const std::size_t at = 6 * index(tree) + static_cast<std::size_t>(side);
            result->tree_to_tree[at] = other < 0 ? tree : other;
            result->tree_to_face[at] =
                other < 0 ? static_cast<std::int8_t>(side) : sideCode(mesh, tree, side, other);
        }
    if (!withPoints) return result;
    std::fill(result->vertices, result->vertices + 3 * index(points), 0.0);
    for (Label tree = 0; tree < trees; ++tree)
        std::ranges::copy(mesh.corners(tree), result->tree_to_vertex + 8 * index(tree));
    p8est_connectivity_complete(result.get());
    return result;
}

constexpr int shift = P8EST_MAXLEVEL - latticeBits; // p4est's lattice is finer

/// p4est asks for its octants in the order of the lists, so each needs to be looked at once.
struct Cursors {
    const RefinedOctants& refined;
    std::array<std::size_t, mostLevel> at{};

    void startAt(OctantKey first) {
        for (std::size_t l = 0; l < mostLevel; ++l)
            at[l] = static_cast<std::size_t>(std::ranges::lower_bound(refined[l], first) -
                                             refined[l].begin());
    }

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

/// Of one process or of all that mpirun started.
Forest
forestOf(p8est_connectivity_t* connectivity, const RefinedOctants& refined, bool isDistributed) {
    const MPI_Comm processes = isDistributed ? MPI_COMM_WORLD : MPI_COMM_SELF;
    Forest forest(p8est_new_ext(processes, connectivity, 0, 0, 1, 0, nullptr, nullptr));
    Cursors cursors{refined};
    if (forest->first_local_tree >= 0) cursors.startAt(octantKey(forest->first_local_tree, {}));
    forest->user_pointer = &cursors;
    p8est_refine_ext(forest.get(), 1, mostLevel, isDivided, nullptr, nullptr);
    forest->user_pointer = nullptr;
    return forest;
}

std::span<const p8est_quadrant_t> octantsOf(const p8est_t& forest, Label tree) {
    const p8est_tree_t* found = p8est_tree_array_index(forest.trees, tree);
    return {static_cast<const p8est_quadrant_t*>(static_cast<const void*>(found->quadrants.array)),
            found->quadrants.elem_count};
}

void addTree(const p8est_t& forest, Label tree, Leaves& leaves) {
    leaves.start[index(tree)] = toLabel(leaves.codes.size());
    for (const p8est_quadrant_t& octant : octantsOf(forest, tree))
        leaves.codes.push_back(octantCode({anchorOf(octant), octant.level}));
}

/// Ships the trees to where the partition wants them.
void distribute(p8est_t& forest, const Partition& partition, const Leaves& leaves) {
    std::vector<p4est_locidx_t> counts;
    for (std::size_t r = 0; r + 1 < partition.firstTree.size(); ++r)
        counts.push_back(leaves.first[index(partition.firstTree[r + 1])] -
                         leaves.first[index(partition.firstTree[r])]);
    p8est_partition_given(&forest, counts.data());
}

/// The leaves of a tree of another process, from its divided octants.
void addExpanded(const Octant& octant, std::span<const OctantCode> divided, Leaves& leaves) {
    const OctantCode code = octantCode(octant);
    if (!std::ranges::binary_search(divided, code)) {
        leaves.codes.push_back(code);
        return;
    }
    for (std::size_t c = 0; c < 8; ++c)
        addExpanded(octant.child(c), divided, leaves);
}

void addForeignTrees(const MacroMesh& mesh,
                     const TreeOctants& octants,
                     const Partition& partition,
                     Leaves& leaves) {
    const std::vector<char> inSight = treesInSight(mesh, partition);
    for (Label tree = 0; tree < mesh.cellCount(); ++tree) {
        if (inSight[index(tree)] == 0 || partition.isOwn(tree)) continue;
        leaves.start[index(tree)] = toLabel(leaves.codes.size());
        const std::span<const OctantCode> own = octants.of(tree);
        std::vector<OctantCode> divided(own.begin(), own.end());
        std::ranges::sort(divided);
        addExpanded({}, divided, leaves);
    }
}

} // namespace

Leaves growForest(const MacroMesh& mesh,
                  const RefinedOctants& refined,
                  const TreeOctants& octants,
                  const Partition& partition) {
    startMpi();
    Leaves leaves;
    leaves.first.push_back(0);
    for (Label tree = 0; tree < mesh.cellCount(); ++tree)
        leaves.first.push_back(leaves.first.back() + octants.leafCount(tree));
    leaves.start.assign(index(mesh.cellCount()), -1);
    leaves.finest.assign(octants.level.begin(), octants.level.end());
    const Connectivity connectivity = connectivityOf(mesh, false);
    const Forest forest = forestOf(connectivity.get(), refined, !partition.isWhole());
    if (!partition.isWhole()) distribute(*forest, partition, leaves);
    leaves.codes.reserve(static_cast<std::size_t>(forest->local_num_quadrants));
    for (Label tree = partition.first(); tree < partition.end(); ++tree)
        addTree(*forest, tree, leaves);
    if (!partition.isWhole()) addForeignTrees(mesh, octants, partition, leaves);
    return leaves;
}

Leaves growBalancedForest(const MacroMesh& mesh, const RefinedOctants& refined) {
    startMpi();
    const Connectivity connectivity = connectivityOf(mesh, true);
    const Forest forest = forestOf(connectivity.get(), refined, false);
    p8est_balance(forest.get(), P8EST_CONNECT_FULL, nullptr);
    Leaves leaves;
    leaves.start.assign(index(mesh.cellCount()), -1);
    for (Label tree = 0; tree < mesh.cellCount(); ++tree) {
        leaves.first.push_back(toLabel(leaves.codes.size()));
        addTree(*forest, tree, leaves);
    }
    leaves.first.push_back(toLabel(leaves.codes.size()));
    return leaves;
}

} // namespace polymesh
