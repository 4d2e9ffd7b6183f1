// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/numberMap.h"

#include <algorithm>

namespace polymesh::star {

NumberMap::NumberMap(std::span<const Label> numbers) {
    const Label count = toLabel(numbers.size());
    const Label largest = numbers.empty() ? 0 : *std::ranges::max_element(numbers);
    constexpr Label slack = 1024;
    if (largest / 8 <= count + slack) {
        table_.assign(index(largest) + 1, -1);
        for (Label i = 0; i < count; ++i) {
            Label& entry = table_[index(numbers[index(i)])];
            if (entry >= 0 && !repeated_) repeated_ = i;
            entry = i;
        }
        return;
    }
    sorted_.reserve(numbers.size());
    for (Label i = 0; i < count; ++i)
        sorted_.emplace_back(numbers[index(i)], i);
    std::ranges::sort(sorted_);
    for (std::size_t i = 1; i < sorted_.size(); ++i)
        if (sorted_[i].first == sorted_[i - 1].first)
            repeated_ = std::min(repeated_.value_or(count), sorted_[i].second);
}

Label NumberMap::findSorted(Label number) const {
    const auto found = std::ranges::lower_bound(sorted_, std::pair(number, Label{0}));
    return found != sorted_.end() && found->first == number ? found->second : -1;
}

} // namespace polymesh::star
