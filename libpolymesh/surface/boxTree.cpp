// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/boxTree.h"

#include <numeric>

namespace polymesh {

namespace {

constexpr std::size_t leafSize = 4;

int longestAxis(const Vec3& size) {
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

} // namespace

BoxTree::BoxTree(std::span<const Box> boxes) : items_(boxes.size()) {
    std::iota(items_.begin(), items_.end(), Label{0});
    if (!boxes.empty()) build(boxes, items_, 0);
}

void BoxTree::build(std::span<const Box> boxes, std::span<Label> items, Label firstItem) {
    Box box;
    Box centres;
    for (Label item : items) {
        box.add(boxes[index(item)]);
        centres.add(boxes[index(item)].centre());
    }
    const std::size_t node = nodes_.size();
    if (items.size() <= leafSize) {
        nodes_.push_back({box, firstItem, toLabel(items.size())});
        return;
    }
    nodes_.push_back({box, 0, 0});
    const int axis = longestAxis(centres.size());
    const std::size_t half = items.size() / 2;
    std::ranges::nth_element(
        items, items.begin() + static_cast<std::ptrdiff_t>(half), {}, [&](Label item) {
            return std::pair(boxes[index(item)].centre()[axis], item);
        });
    build(boxes, items.first(half), firstItem);
    nodes_[node].first = toLabel(nodes_.size());
    build(boxes, items.subspan(half), firstItem + toLabel(half));
}

} // namespace polymesh
