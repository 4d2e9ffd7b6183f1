// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trimCell/cellCut.h"

#include <span>

namespace polymesh {

/// What joining the cells needs of mesh and surface. `cuts` are those of all local cells, in order.
struct JoinInputs {
    const Probe& probe;
    const CuttingSurface& cutter;
    std::span<const CellCut> cuts;
};

/// Puts what the cells have found into one order: all of the arrangement but `segments`.
/// Throws WorkError where two cells that share a node, an edge, a face or a surface point disagree
/// about it: each has found it by itself.
/// Cost: O(findings), and a sort of the pierces of each surface edge.
Arrangement joinSites(const JoinInputs& inputs);

/// The label of a named point.
Label labelOf(const JoinInputs& inputs, const Arrangement& arrangement, const PointName& point);

/// Throws WorkError: two cells disagree about something at this place.
[[noreturn]] void refuseDifference(const char* about, const Vec3& place);

} // namespace polymesh
