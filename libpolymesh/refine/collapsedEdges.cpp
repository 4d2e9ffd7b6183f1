// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/collapsedEdges.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace polymesh {
namespace {

constexpr std::array<std::size_t, 3> directions{1, 2, 4}; // bits of corners

std::size_t axisOf(std::size_t direction) {
    return direction / 2; // 1, 2, 4 -> 0, 1, 2
}

/// A coordinate seen from the end of the tree that a bit of a corner says.
std::int32_t seenFrom(bool isUpper, std::int32_t x) {
    return isUpper ? latticeSize - x : x;
}

} // namespace

CollapsedEdges::CollapsedEdges(const MacroMesh& mesh, std::span<const Label> original)
    : mesh_(&mesh), original_(original) {
    std::vector<char> coincides(original.size(), 0);
    for (std::size_t p = 0; p < original.size(); ++p)
        if (index(original[p]) != p) coincides[p] = coincides[index(original[p])] = 1;
    for (Label tree = 0; tree < mesh.cellCount(); ++tree)
        if (std::ranges::any_of(mesh.corners(tree),
                                [&](Label p) { return coincides[index(p)] != 0; }))
            trees_.push_back(tree);
    keepAxes(edgesOfTrees());
}

Label CollapsedEdges::pointAt(Label tree, std::size_t corner) const {
    return original_[index(mesh_->corners(tree)[corner])];
}

/// All edges that have a length, by their points and trees.
std::vector<CollapsedEdges::AxisEdge> CollapsedEdges::edgesOfTrees() const {
    std::vector<AxisEdge> all;
    for (const Label tree : trees_)
        for (std::size_t a = 0; a < 8; ++a)
            for (const std::size_t along : directions) {
                const Label start = pointAt(tree, a);
                const Label end = pointAt(tree, a ^ along);
                if (start < end) all.push_back({start, end, tree, {a, a ^ along}, 0});
            }
    std::ranges::stable_sort(
        all, {}, [](const AxisEdge& e) { return std::tuple(e.low, e.high, e.tree); });
    return all;
}

/// Keeps those that coincide with others: the same points, but other copies of them.
void CollapsedEdges::keepAxes(std::vector<AxisEdge> all) {
    const auto sameAxis = [](const AxisEdge& a, const AxisEdge& b) {
        return a.low == b.low && a.high == b.high;
    };
    const auto copies = [&](const AxisEdge& e) {
        const MacroMesh::Corners& corners = mesh_->corners(e.tree);
        return std::array{corners[e.corners[0]], corners[e.corners[1]]};
    };
    for (auto first = all.begin(); first != all.end();) {
        const auto last = std::find_if_not(
            first, all.end(), [&](const AxisEdge& e) { return sameAxis(e, *first); });
        const bool isAxis = std::any_of(
            first, last, [&](const AxisEdge& e) { return copies(e) != copies(*first); });
        for (auto edge = first; isAxis && edge != last; ++edge) {
            const bool isSecond =
                !edges_.empty() && edge != first && edges_.back().tree == edge->tree;
            if (isSecond)
                edges_.back().sweep = edges_.back().corners[0] ^ edge->corners[0];
            else
                edges_.push_back(*edge);
        }
        first = last;
    }
    edgesByTree_ = edges_;
    std::ranges::stable_sort(edgesByTree_, {}, &AxisEdge::tree);
    for (const Label tree : trees_)
        firstOfTree_.push_back(toLabel(static_cast<std::size_t>(
            std::ranges::lower_bound(edgesByTree_, tree, {}, &AxisEdge::tree) -
            edgesByTree_.begin())));
    firstOfTree_.push_back(toLabel(edgesByTree_.size()));
}

/// The end nearest to the lower point of the part of the edge that an octant of the tree has.
std::optional<EdgePlace> CollapsedEdges::placeOn(const AxisEdge& edge, const Octant& octant) const {
    const std::size_t low = edge.corners[0];
    const std::size_t along = low ^ edge.corners[1];
    EdgePlace place{edge.low, edge.high, 0};
    for (const std::size_t direction : directions) {
        const bool isUpper = (low & direction) != 0;
        const std::int32_t anchor = octant.anchor[axisOf(direction)];
        const std::int32_t distance = seenFrom(isUpper, isUpper ? anchor + octant.size() : anchor);
        if (direction == along)
            place.distance = distance;
        else if (direction != edge.sweep && distance != 0)
            return std::nullopt;
    }
    return place;
}

/// The octants of a level that have the part of an axis that begins at this place.
void CollapsedEdges::addAt(const EdgePlace& place,
                           int level,
                           std::vector<OctantKey>& octants) const {
    const auto key = [](const AxisEdge& e) { return std::pair(e.low, e.high); };
    const std::pair ends(place.low, place.high);
    for (auto e = std::ranges::lower_bound(edges_, ends, {}, key);
         e != edges_.end() && key(*e) == ends;
         ++e) {
        const AxisEdge& edge = *e;
        const std::size_t low = edge.corners[0];
        Octant octant{{}, level};
        for (const std::size_t direction : directions) {
            const bool isUpper = (low & direction) != 0;
            const std::int32_t distance = direction == (low ^ edge.corners[1]) ? place.distance : 0;
            octant.anchor[axisOf(direction)] =
                isUpper ? latticeSize - distance - octant.size() : distance;
        }
        if (edge.sweep == 0) {
            octants.push_back(octantKey(edge.tree, octant.anchor));
            continue;
        }
        for (std::int32_t at = 0; at < latticeSize; at += octant.size()) {
            octant.anchor[axisOf(edge.sweep)] = at;
            octants.push_back(octantKey(edge.tree, octant.anchor));
        }
    }
}

void CollapsedEdges::addTogether(int level, std::vector<OctantKey>& octants) const {
    if (edges_.empty()) return;
    std::size_t before = 0;
    while (octants.size() != before) {
        before = octants.size();
        std::vector<EdgePlace> places;
        for (const OctantKey key : octants) {
            const auto at = std::ranges::lower_bound(trees_, treeOf(key));
            if (at == trees_.end() || *at != treeOf(key)) continue;
            const auto t = static_cast<std::size_t>(at - trees_.begin());
            for (Label e = firstOfTree_[t]; e < firstOfTree_[t + 1]; ++e)
                if (const auto place = placeOn(edgesByTree_[index(e)], {anchorOf(key), level}))
                    places.push_back(*place);
        }
        std::ranges::sort(places);
        places.erase(std::unique(places.begin(), places.end()), places.end());
        for (const EdgePlace& place : places)
            addAt(place, level, octants);
        std::ranges::sort(octants);
        octants.erase(std::unique(octants.begin(), octants.end()), octants.end());
    }
}

std::optional<EdgePlace> CollapsedEdges::placeOf(Label tree, const LatticePoint& p) const {
    std::size_t corner = 0; // of the part of the tree that the point is in: a corner, an edge, ...
    std::size_t free = 0;   // the directions of that part
    for (const std::size_t direction : directions) {
        const std::int32_t x = p[axisOf(direction)];
        if (x == latticeSize)
            corner |= direction;
        else if (x != 0)
            free |= direction;
    }
    // A direction counts only where its edges have a length.
    const std::size_t all = free;
    for (const std::size_t direction : directions) {
        if ((free & direction) == 0) continue;
        bool isCollapsed = true;
        for (std::size_t c = 0; c < 8; ++c)
            if ((c & ~all) == 0)
                isCollapsed = isCollapsed &&
                              pointAt(tree, corner | c) == pointAt(tree, (corner | c) ^ direction);
        if (isCollapsed) free &= ~direction;
    }
    if (free == 0) return EdgePlace{pointAt(tree, corner), pointAt(tree, corner), 0};
    if ((free & (free - 1)) != 0) return std::nullopt;
    const Label start = pointAt(tree, corner);
    const Label end = pointAt(tree, corner | free);
    const std::int32_t x = p[axisOf(free)];
    return start < end ? EdgePlace{start, end, x} : EdgePlace{end, start, latticeSize - x};
}

} // namespace polymesh
