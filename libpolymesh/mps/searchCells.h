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

} // namespace polymesh
