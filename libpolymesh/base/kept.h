// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace polymesh {

/// Which elements of a list stay, and how many come before: so that the list can be
/// closed up by several threads at the same time. Memory: a byte for each element.
class Kept {
public:
    /// Asks isKept(i) for each element, in parallel.
    template<class IsKept>
    Kept(Label count, IsKept&& isKept)
        : flags_(freshList<std::uint8_t>(index(count))),
          before_(index((count + stride - 1) / stride) + 1, 0) {
        parallelBlocks(count, blockSize, [&](Label, Label first, Label last) {
            for (Label i = first; i < last; ++i) {
                flags_[index(i)] = isKept(i) ? 1 : 0;
                before_[index(i / stride) + 1] += flags_[index(i)];
            }
        });
        for (std::size_t b = 1; b < before_.size(); ++b)
            before_[b] += before_[b - 1];
    }

    /// The number of elements that stay.
    Label count() const { return before_.back(); }

    bool isKept(Label i) const { return flags_[index(i)] != 0; }

    /// The number of elements before `i` that stay, which is the new label of `i` if it does.
    /// Cost: a look at up to 255 bytes.
    Label countBefore(Label i) const {
        const auto first = flags_.begin() + std::ptrdiff_t{i / stride} * stride;
        const auto sinceFirst = std::count(first, flags_.begin() + i, std::uint8_t{1});
        return before_[index(i / stride)] + toLabel(static_cast<std::size_t>(sinceFirst));
    }

    /// Calls body(element, its new label) for each element that stays, in parallel.
    template<class Body>
    void forEach(Body&& body) const {
        parallelBlocks(toLabel(flags_.size()), blockSize, [&](Label, Label first, Label end) {
            Label next = before_[index(first / stride)];
            for (Label i = first; i < end; ++i)
                if (flags_[index(i)] != 0) body(i, next++);
        });
    }

private:
    static constexpr Label stride = 256;            // elements of one entry of before_
    static constexpr Label blockSize = 32 * stride; // elements that one thread takes at a time
    std::vector<std::uint8_t> flags_;
    std::vector<Label> before_;
};

} // namespace polymesh
