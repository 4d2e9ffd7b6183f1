// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/refine/pointTable.h"

#include <vector>

namespace polymesh {

/// The points of one tree, for many questions: in a lattice as fine as its finest points, unless
/// that is much larger than the number of questions is worth.
class TreePoints {
public:
    /// `finest`: the level of the finest points; `leafCount`: how many leaves will be asked for.
    TreePoints(const PointTable& table, Label tree, int finest, std::size_t leafCount)
        : table_(table),
          tree_(tree),
          shift_(latticeBits - finest),
          width_((std::size_t{1} << static_cast<unsigned>(finest)) + 1) {
        constexpr std::size_t mostPerLeaf =
            32; // setting a label is that much cheaper than a search
        const std::size_t count = width_ * width_ * width_;
        if (count > mostPerLeaf * leafCount) return;
        labels_.assign(count, -1);
        for (std::size_t c = 0; c < 8; ++c) {
            const LatticePoint p = Octant{}.corner(c);
            labels_[place(p)] = table.find(tree, p);
        }
        table.forPointsOf(tree,
                          [&](const LatticePoint& p, Label label) { labels_[place(p)] = label; });
    }

    Label tree() const { return tree_; }

    /// As PointTable::find. Requires: p is not finer than the finest points.
    Label find(const LatticePoint& p) const {
        return labels_.empty() ? table_.find(tree_, p) : labels_[place(p)];
    }

private:
    std::size_t place(const LatticePoint& p) const {
        const auto along = [&](std::size_t axis) {
            return static_cast<std::size_t>(p[axis] >> shift_);
        };
        return along(0) + width_ * (along(1) + width_ * along(2));
    }

    const PointTable& table_;
    Label tree_;
    int shift_;
    std::size_t width_; // points along an edge
    std::vector<Label> labels_;
};

} // namespace polymesh
