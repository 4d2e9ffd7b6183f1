// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mps/cones.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace polymesh {

/// What find(cell) finds for the cells, in their order without those for which that is nothing.
/// Cells are searched in parallel: find may only read.
template<class Find>
std::vector<CellCones> searchCells(std::span<const Label> cells, Find&& find) {
    std::vector<std::optional<CellCones>> found(cells.size());
    parallelBlocks(toLabel(cells.size()), 1, [&](Label, Label i, Label) {
        found[index(i)] = find(cells[index(i)]);
    });
    std::vector<CellCones> result;
    for (auto& one : found)
        if (one) result.push_back(std::move(*one));
    return result;
}

/// Those of the cells for which is(cell) is true, in their order; in parallel.
template<class Is>
std::vector<Label> chosen(std::span<const Label> cells, Is&& is) {
    std::vector<char> isIn(cells.size(), 0);
    parallelBlocks(toLabel(cells.size()), 1, [&](Label, Label i, Label) {
        isIn[index(i)] = is(cells[index(i)]) ? 1 : 0;
    });
    std::vector<Label> found;
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (isIn[i] != 0) found.push_back(cells[i]);
    return found;
}

} // namespace polymesh
