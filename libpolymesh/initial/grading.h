// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <vector>

namespace polymesh {

/// One part of a graded edge. Lengths and cells are shares; they are scaled to sum to 1.
struct GradingSection {
    double length = 1;
    double cells = 1;
    double expansion = 1; // size of the last cell over that of the first, > 0

    bool operator==(const GradingSection&) const = default;
};

/// How cells are spaced along an edge, section by section.
using Grading = std::vector<GradingSection>;

/// The grading seen from the other end of the edge.
Grading reversed(const Grading& grading);

/// The parameters in [0, 1] of the `cells` + 1 points along an edge, ascending, the first 0, the
/// last 1. Sizes grow geometrically within a section. Each section has its share of the cells
/// rounded to the nearest number; what rounding leaves over goes to the section with most of them.
/// Fewer cells than sections are spaced evenly.
/// With `parts` those between the points too: each cell is divided into so many that grow by the
/// same law.
/// Requires: cells >= 1, shares and expansions positive. Source: OpenFOAM's user guide, 4.3.1.3.
std::vector<double> gradedParameters(Label cells, const Grading& grading, Label parts = 1);

} // namespace polymesh
