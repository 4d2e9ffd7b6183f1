// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <array>
#include <span>
#include <vector>

namespace polymesh {

/// An edge inside a joined piece of surface.
struct NetEdge {
    std::array<Label, 2> ends{}; // point labels
    double cost = 0;             // of making it a border
    bool isBorder = false;       // is one already: a feature edge
};

/// Carries feature lines that end inside a disc on, along the cheapest edges, until each end meets
/// the disc's outline or another line, so that the lines divide the disc. Marks the edges that it
/// takes as borders. `outline`: the points of the outline, sorted.
/// Returns false when an end could not be carried on. The result depends on labels and costs alone.
/// Cost: O(ends * n log n) for n edges. Source: Dijkstra (1959) for each end.
bool carryFeaturesOn(std::vector<NetEdge>& net, std::span<const Label> outline);

} // namespace polymesh
