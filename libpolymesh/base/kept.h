// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace polymesh {

/// Which elements of a list stay, and how many before each block of them: so that the list can be
/// closed up by several threads at the same time. Memory: a byte for each element.
class Kept {
public:
    /// Asks isKept(i) for each element, in parallel.
    template<class IsKept>
    Kept(Label count, IsKept&& isKept)
        : flags_(index(count)), before_(index((count + blockSize - 1) / blockSize) + 1, 0) {
        parallelBlocks(count, blockSize, [&](Label block, Label first, Label last) {
            for (Label i = first; i < last; ++i) {
                flags_[index(i)] = isKept(i) ? 1 : 0;
                before_[index(block) + 1] += flags_[index(i)];
            }
        });
        for (std::size_t b = 1; b < before_.size(); ++b)
            before_[b] += before_[b - 1];
    }

    /// The number of elements that stay.
    Label count() const { return before_.back(); }

    bool isKept(Label i) const { return flags_[index(i)] != 0; }

    /// The number of elements before `i` that stay, which is the new label of `i` if it does.
    /// Cost: a look at up to 2048 bytes.
    Label countBefore(Label i) const {
        const Label block = i / blockSize;
        const auto first = flags_.begin() + std::ptrdiff_t{block} * blockSize;
        const auto inBlock = std::count(first, flags_.begin() + i, std::uint8_t{1});
        return before_[index(block)] + toLabel(static_cast<std::size_t>(inBlock));
    }

    /// Calls body(element, its new label) for each element that stays, in parallel.
    template<class Body>
    void forEach(Body&& body) const {
        parallelBlocks(toLabel(flags_.size()), blockSize, [&](Label block, Label first, Label end) {
            Label next = before_[index(block)];
            for (Label i = first; i < end; ++i)
                if (flags_[index(i)] != 0) body(i, next++);
        });
    }

private:
    static constexpr Label blockSize = 1 << 11;
    std::vector<std::uint8_t> flags_;
    std::vector<Label> before_;
};

} // namespace polymesh
