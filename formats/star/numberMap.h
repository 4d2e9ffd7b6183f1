// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace polymesh::star {

/// Finds elements by the numbers that a file gives them, which are positive but may come in any
/// order and with gaps. Memory: a label for each number up to the largest, or, where the numbers
/// are sparse, two labels for each element.
class NumberMap {
public:
    explicit NumberMap(std::span<const Label> numbers);

    /// The element with that number; -1 when there is none.
    Label find(Label number) const {
        if (sorted_.empty())
            return number > 0 && number < toLabel(table_.size()) ? table_[index(number)] : -1;
        return findSorted(number);
    }

    /// The first element whose number an earlier one has.
    std::optional<Label> repeated() const { return repeated_; }

private:
    Label findSorted(Label number) const;

    std::vector<Label> table_;                    // [number] element
    std::vector<std::pair<Label, Label>> sorted_; // number, element: when the numbers are sparse
    std::optional<Label> repeated_;
};

} // namespace polymesh::star
