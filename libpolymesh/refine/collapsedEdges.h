// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/refine/macroMesh.h"

#include <optional>
#include <span>
#include <vector>

namespace polymesh {

/// A place on an edge of the initial mesh, by the points at its ends: `distance` from the lower
/// one, in the lattice of a tree. A point of the mesh itself is at distance 0 from itself.
struct EdgePlace {
    Label low = -1;
    Label high = -1;
    std::int32_t distance = 0;

    auto operator<=>(const EdgePlace&) const = default; // NOLINT(modernize-use-nullptr)
};

/// Where edges of trees coincide because sides have collapsed, as at the axis of a wedge. The trees
/// are whole (openCollapsed); `original` says which of their points are one.
///
/// An edge of a cell that is on such an axis must not be halved in one cell and whole in another
/// that has no side in common with it: so octants at the same part of an axis are divided together,
/// all round it, and their middles become one point.
class CollapsedEdges {
public:
    /// Nothing coincides.
    CollapsedEdges() = default;

    /// Both arguments must outlive the object.
    CollapsedEdges(const MacroMesh& mesh, std::span<const Label> original);

    /// The trees at points that coincide with others, ascending.
    const std::vector<Label>& trees() const { return trees_; }

    /// Adds to octants of one level, ascending, those that must be divided with them.
    void addTogether(int level, std::vector<OctantKey>& octants) const;

    /// What may coincide with a point of a tree: where it is when it is on an edge of the initial
    /// mesh, or one with a corner. Requires: one of trees().
    std::optional<EdgePlace> placeOf(Label tree, const LatticePoint& p) const;

private:
    /// An edge of a tree that coincides with others: by its two corners, the one at the lower point
    /// first. With `sweep` the side that the edge is on in that direction has collapsed to it.
    struct AxisEdge {
        Label low = -1;
        Label high = -1;
        Label tree = -1;
        std::array<std::size_t, 2> corners{};
        std::size_t sweep = 0; // bit of a corner; 0: none
    };

    std::vector<AxisEdge> edgesOfTrees() const;
    void keepAxes(std::vector<AxisEdge> all);
    std::optional<EdgePlace> placeOn(const AxisEdge& edge, const Octant& octant) const;
    void addAt(const EdgePlace& place, int level, std::vector<OctantKey>& octants) const;
    Label pointAt(Label tree, std::size_t corner) const;

    const MacroMesh* mesh_ = nullptr;
    std::span<const Label> original_;
    std::vector<Label> trees_;
    std::vector<AxisEdge> edges_;    // by their points, then by tree
    std::vector<Label> firstOfTree_; // beside trees_, in edgesByTree_
    std::vector<AxisEdge> edgesByTree_;
};

} // namespace polymesh
