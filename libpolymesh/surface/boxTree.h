// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/box.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace polymesh {

/// A tree of boxes over items that have boxes: halves of equal size, so its depth is that of a
/// balanced binary tree. Queries are thread-safe.
class BoxTree {
public:
    /// Cost: O(n log n). Items are numbered as in `boxes`.
    explicit BoxTree(std::span<const Box> boxes);

    /// Calls body(item) for all items in leaves whose box overlaps `box`: every item that overlaps
    /// it, and some that do not, in an order that depends on the tree only.
    template<class Body>
    void forEachNear(const Box& box, Body&& body) const {
        Stack stack;
        if (!nodes_.empty()) stack.push(0);
        while (!stack.isEmpty()) {
            const Label n = stack.pop();
            const Node& node = nodes_[index(n)];
            if (!overlaps(node.box, box)) continue;
            if (node.count == 0) {
                stack.push(node.first);
                stack.push(n + 1);
            }
            for (Label i = 0; i < node.count; ++i)
                body(items_[index(node.first + i)]);
        }
    }

    /// The least squared distance from `p` that distance2(item) gives, for an item that is at least
    /// as far as its box. Calls distance2 for the items that can be the nearest and nearer than
    /// sqrt(`below2`).
    template<class Distance2>
    void searchNearest(const Vec3& p, Distance2&& distance2, double below2 = Box::inf) const {
        double best = below2;
        Stack stack;
        if (!nodes_.empty()) stack.push(0);
        while (!stack.isEmpty()) {
            const Label n = stack.pop();
            const Node& node = nodes_[index(n)];
            if (squaredDistance(node.box, p) >= best) continue;
            for (Label i = 0; i < node.count; ++i)
                best = std::min(best, distance2(items_[index(node.first + i)]));
            if (node.count == 0) pushNearestLast(stack, {n + 1, node.first}, p);
        }
    }

    /// Two nodes, or twice the same one: what stands below them is to be paired.
    using NodePair = std::array<Label, 2>;

    /// Some hundreds of pairs of nodes, the same for the same boxes, that together hold all pairs
    /// of items that overlap: for forEachPair() in parallel.
    std::vector<NodePair> nodePairs() const;

    /// Calls body(i, j) for all pairs of different items below the two nodes that are in leaves
    /// whose boxes overlap: every pair that overlaps, once and in one of its orders, and some that
    /// do not.
    template<class Body>
    void forEachPair(const NodePair& nodes, Body&& body) const {
        const auto& [a, b] = nodes;
        if (!overlaps(nodes_[index(a)].box, nodes_[index(b)].box)) return;
        if (!isLeaf(a) || !isLeaf(b)) {
            forEachPairBelow(nodes, [&](const NodePair& below) { forEachPair(below, body); });
            return;
        }
        const auto items = itemsOf(a);
        for (std::size_t i = 0; i < items.size(); ++i)
            for (Label other : a == b ? items.subspan(i + 1) : itemsOf(b))
                body(items[i], other);
    }

private:
    /// A leaf holds count items from items_[first]; an inner node (count 0) has its children at the
    /// next place and at nodes_[first].
    struct Node {
        Box box;
        Label first = 0;
        Label count = 0;
    };

    /// The pending nodes of a walk: one a level, and the tree is balanced.
    class Stack {
    public:
        bool isEmpty() const { return size_ == 0; }

        void push(Label node) { nodes_[size_++] = node; }

        Label pop() { return nodes_[--size_]; }

    private:
        std::array<Label, 72> nodes_;
        std::size_t size_ = 0;
    };

    static double squaredDistance(const Box& box, const Vec3& p) {
        Vec3 d;
        for (int axis = 0; axis < 3; ++axis)
            d[axis] = std::max({box.min[axis] - p[axis], p[axis] - box.max[axis], 0.0});
        return squaredNorm(d);
    }

    void pushNearestLast(Stack& stack, std::array<Label, 2> children, const Vec3& p) const {
        if (squaredDistance(nodes_[index(children[0])].box, p) <
            squaredDistance(nodes_[index(children[1])].box, p))
            std::swap(children[0], children[1]);
        stack.push(children[0]);
        stack.push(children[1]);
    }

    bool isLeaf(Label node) const { return nodes_[index(node)].count > 0; }

    std::span<const Label> itemsOf(Label leaf) const {
        const Node& node = nodes_[index(leaf)];
        return std::span(items_).subspan(index(node.first), index(node.count));
    }

    /// An inner node's children; a leaf itself.
    std::span<const Label> halvesOf(Label node, NodePair& halves) const {
        halves = {node + 1, nodes_[index(node)].first};
        if (!isLeaf(node)) return halves;
        halves[0] = node;
        return std::span(halves).first(1);
    }

    /// Calls body(pair) for the pairs that the halves of two nodes, not both leaves, make.
    template<class Body>
    void forEachPairBelow(const NodePair& nodes, Body&& body) const {
        NodePair halves;
        NodePair others;
        const auto first = halvesOf(nodes[0], halves);
        const auto second = halvesOf(nodes[1], others);
        for (std::size_t i = 0; i < first.size(); ++i)
            for (std::size_t j = nodes[0] == nodes[1] ? i : 0; j < second.size(); ++j)
                body(NodePair{first[i], second[j]});
    }

    /// An item's place while the tree is built.
    struct Place {
        Vec3 centre;
        Label item;
    };

    void build(std::span<const Box> boxes, std::span<Place> places, Label firstItem, Label node);
    void buildLeaf(std::span<const Box> boxes,
                   std::span<const Place> places,
                   Label firstItem,
                   Node& leaf);

    std::vector<Node> nodes_;
    std::vector<Label> items_;
};

} // namespace polymesh
