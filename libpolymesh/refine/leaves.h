// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/refine/octant.h"

#include <span>
#include <vector>

namespace polymesh {

/// The cells of a refined mesh: tree by tree, in each along its curve. Of some trees the leaves may
/// be unknown.
/// Laws: (1) first has an entry a tree and one more, ascending; (2) the codes of a tree ascend.
struct Leaves {
    std::vector<Label> first;         // the first cell of each tree
    std::vector<Label> start;         // where the codes of each tree begin; -1: unknown
    std::vector<OctantCode> codes;    // of the leaves that are known
    std::vector<std::uint8_t> finest; // the level of the finest leaf of each tree

    std::span<const OctantCode> of(Label tree) const {
        return {codes.data() + start[index(tree)],
                index(first[index(tree) + 1] - first[index(tree)])};
    }

    /// The cell of a tree that holds this anchor.
    Label cellAt(Label tree, const LatticePoint& anchor) const {
        const std::span<const OctantCode> own = of(tree);
        // As many as there can be of the finest level: then all are of it, and the place on the
        // curve counts them.
        const int level = finest[index(tree)];
        if (own.size() == std::size_t{1} << static_cast<unsigned>(3 * level))
            return first[index(tree)] +
                   static_cast<Label>(curvePlace(anchor) >>
                                      static_cast<unsigned>(3 * (latticeBits - level)));
        const OctantCode last = octantCode({anchor, (1 << levelBits) - 1});
        const auto after = std::upper_bound(own.begin(), own.end(), last);
        return first[index(tree)] + static_cast<Label>(after - own.begin()) - 1;
    }

    int levelAt(Label tree, Label cell) const {
        return levelOf(codes[index(start[index(tree)] + cell - first[index(tree)])]);
    }

    /// Of all trees.
    Label cellCount() const { return first.back(); }
};

} // namespace polymesh
