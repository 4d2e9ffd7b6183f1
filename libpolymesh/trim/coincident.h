// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/arrangement.h"

#include <array>
#include <span>
#include <vector>

namespace polymesh {

/// For each point of the arrangement the point that stands for it: points that fall together on
/// the surface as given (before it was moved) share one. A mesh node stands before a surface point,
/// a surface point before crossings and pierces. Exact: decided by the zeros of the predicates.
/// `joined`: pairs of points that are one besides (see settleNodes.h).
std::vector<Label> mergeCoincident(const Probe& probe,
                                   const CuttingSurface& cutter,
                                   const Arrangement& arrangement,
                                   std::span<const std::array<Label, 2>> joined = {});

} // namespace polymesh
