// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <span>
#include <vector>

namespace polymesh {

/// A compact list of lists: row i is values[offsets[i]] ... values[offsets[i + 1] - 1].
/// Laws: (1) offsets has size() + 1 entries, ascending, the first 0, the last values.size().
template<class T>
struct Rows {
    std::vector<Label> offsets{0};
    std::vector<T> values;

    Label size() const { return toLabel(offsets.size()) - 1; }

    bool empty() const { return offsets.size() == 1; }

    Label rowSize(Label row) const { return offsets[index(row) + 1] - offsets[index(row)]; }

    std::span<const T> operator[](Label row) const {
        return {values.data() + offsets[index(row)], index(rowSize(row))};
    }

    std::span<T> operator[](Label row) {
        return {values.data() + offsets[index(row)], index(rowSize(row))};
    }

    void add(std::span<const T> row) {
        values.insert(values.end(), row.begin(), row.end());
        offsets.push_back(toLabel(values.size()));
    }

    bool operator==(const Rows&) const = default;
};

/// The rows of all parts, one part after the other.
template<class T>
Rows<T> joined(const std::vector<Rows<T>>& parts) {
    std::size_t rowCount = 0;
    std::size_t valueCount = 0;
    for (const Rows<T>& part : parts) {
        rowCount += part.offsets.size() - 1;
        valueCount += part.values.size();
    }
    Rows<T> all;
    all.offsets.reserve(rowCount + 1);
    all.values.reserve(valueCount);
    for (const Rows<T>& part : parts) {
        const Label base = toLabel(all.values.size());
        all.values.insert(all.values.end(), part.values.begin(), part.values.end());
        for (std::size_t i = 1; i < part.offsets.size(); ++i)
            all.offsets.push_back(base + part.offsets[i]);
    }
    return all;
}

} // namespace polymesh
