// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/boxTree.h"

#include "libpolymesh/base/parallel.h"

#include <numeric>

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
    std::iota(items_.begin(), items_.end(), Label{0});
    if (boxes.empty()) return;
    nodes_.resize(nodeCount(items_.size()));
    build(boxes, items_, 0, 0);
}

void BoxTree::build(std::span<const Box> boxes,
                    std::span<Label> items,
                    Label firstItem,
                    Label node) {
    Box box;
    Box centres;
    for (Label item : items) {
        box.add(boxes[index(item)]);
        centres.add(boxes[index(item)].centre());
    }
    if (items.size() <= leafSize) {
        nodes_[index(node)] = {box, firstItem, toLabel(items.size())};
        return;
    }
    const int axis = longestAxis(centres.size());
    const std::size_t half = items.size() / 2;
    std::ranges::nth_element(
        items, items.begin() + static_cast<std::ptrdiff_t>(half), {}, [&](Label item) {
            return std::pair(boxes[index(item)].centre()[axis], item);
        });
    const Label second = node + 1 + toLabel(nodeCount(half));
    nodes_[index(node)] = {box, second, 0};
    const auto buildHalf = [&](Label i) {
        if (i == 0)
            build(boxes, items.first(half), firstItem, node + 1);
        else
            build(boxes, items.subspan(half), firstItem + toLabel(half), second);
    };
    if (items.size() > largeTree) {
        parallelBlocks(2, 1, [&](Label i, Label, Label) { buildHalf(i); });
    } else {
        buildHalf(0);
        buildHalf(1);
    }
}

} // namespace polymesh
