// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/refine/collapsedEdges.h"
#include "libpolymesh/refine/macroMesh.h"

#include <functional>
#include <span>
#include <vector>

namespace polymesh {

/// The octants that are divided into eight, level by level; each list ascending, each octant once.
using RefinedOctants = std::array<std::vector<OctantKey>, mostLevel>;

/// Says which of these octants of one level are to be divided: one flag each.
using Selection = std::function<std::vector<char>(int level, std::span<const OctantKey> octants)>;

/// Asks for the trees from `firstTree` up to `lastTree`, then for the children of those that are
/// divided, and so on. Throws InputError when there would be too many cells to number.
RefinedOctants selectOctants(Label firstTree, Label lastTree, const Selection& isWanted);

/// Divides further octants until leaves that touch, also at an edge or a point, differ by one
/// level at most, and between a leaf and one two levels coarser there are at least `bufferLayers`
/// of the level between; and all octants round the same part of a collapsed edge together. The
/// result is the least such set.
/// Requires: bufferLayers >= 1. Cost: n log n, in parallel; about 0.1 s for a million leaves.
void balance(const MacroMesh& mesh,
             int bufferLayers,
             RefinedOctants& refined,
             const CollapsedEdges& collapsed = {});

/// The divided octants of each tree, with their levels.
struct TreeOctants {
    std::vector<Label> rowOf;         // of each tree, -1: it is not divided
    Rows<OctantCode> rows;            // by tree, from coarse to fine
    std::vector<std::int8_t> level;   // the finest leaf of each tree
    std::vector<std::int8_t> highest; // that of all trees that share a point with it

    std::span<const OctantCode> of(Label tree) const {
        const Label row = rowOf[index(tree)];
        return row < 0 ? std::span<const OctantCode>() : rows[row];
    }

    /// Each divided octant becomes seven more leaves.
    Label leafCount(Label tree) const { return 1 + 7 * toLabel(of(tree).size()); }
};

TreeOctants octantsByTree(const MacroMesh& mesh, const RefinedOctants& refined);

} // namespace polymesh
