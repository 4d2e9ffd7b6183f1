// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/boxTree.h"

#include "libpolymesh/base/parallel.h"

#include <utility>

namespace polymesh {

namespace {

constexpr std::size_t leafSize = 4;
constexpr std::size_t largeTree = 4096; // its halves are built side by side

std::size_t nodeCount(std::size_t items) {
    return items <= leafSize ? 1 : 1 + nodeCount(items / 2) + nodeCount(items - items / 2);
}

int longestAxis(const Vec3& size) {
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

} // namespace

BoxTree::BoxTree(std::span<const Box> boxes) : items_(boxes.size()) {
    if (boxes.empty()) return;
    std::vector<Place> places(boxes.size());
    parallelFor(toLabel(boxes.size()), [&](Label item) {
        places[index(item)] = {boxes[index(item)].centre(), item};
    });
    nodes_.resize(nodeCount(places.size()));
    build(boxes, places, 0, 0);
}

std::vector<BoxTree::NodePair> BoxTree::nodePairs() const {
    constexpr std::size_t enough = 512;
    std::vector<NodePair> pairs;
    if (!nodes_.empty()) pairs.push_back({0, 0});
    bool isDivided = !pairs.empty();
    while (isDivided && pairs.size() < enough) {
        isDivided = false;
        std::vector<NodePair> below;
        for (const NodePair& pair : pairs) {
            if (!overlaps(nodes_[index(pair[0])].box, nodes_[index(pair[1])].box)) continue;
            const bool areLeaves = isLeaf(pair[0]) && isLeaf(pair[1]);
            isDivided = isDivided || !areLeaves;
            if (areLeaves)
                below.push_back(pair);
            else
                forEachPairBelow(pair, [&](const NodePair& half) { below.push_back(half); });
        }
        std::swap(pairs, below);
    }
    return pairs;
}

void BoxTree::buildLeaf(std::span<const Box> boxes,
                        std::span<const Place> places,
                        Label firstItem,
                        Node& leaf) {
    for (std::size_t i = 0; i < places.size(); ++i) {
        items_[index(firstItem) + i] = places[i].item;
        leaf.box.add(boxes[index(places[i].item)]);
    }
    leaf.first = firstItem;
    leaf.count = toLabel(places.size());
}

void BoxTree::build(std::span<const Box> boxes,
                    std::span<Place> places,
                    Label firstItem,
                    Label node) {
    if (places.size() <= leafSize) return buildLeaf(boxes, places, firstItem, nodes_[index(node)]);
    Box centres;
    for (const Place& place : places)
        centres.add(place.centre);
    const int axis = longestAxis(centres.size());
    const std::size_t half = places.size() / 2;
    std::ranges::nth_element(
        places, places.begin() + static_cast<std::ptrdiff_t>(half), {}, [&](const Place& place) {
            return std::pair(place.centre[axis], place.item);
        });
    const Label second = node + 1 + toLabel(nodeCount(half));
    const auto buildHalf = [&](Label i) {
        if (i == 0)
            build(boxes, places.first(half), firstItem, node + 1);
        else
            build(boxes, places.subspan(half), firstItem + toLabel(half), second);
    };
    if (places.size() > largeTree) {
        parallelBlocks(2, 1, [&](Label i, Label, Label) { buildHalf(i); });
    } else {
        buildHalf(0);
        buildHalf(1);
    }
    Box box = nodes_[index(node + 1)].box;
    box.add(nodes_[index(second)].box);
    nodes_[index(node)] = {box, second, 0};
}

} // namespace polymesh
