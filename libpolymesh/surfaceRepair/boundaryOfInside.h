// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surfaceRepair/exactSoup.h"

#include <vector>

namespace polymesh {

/// The triangles of the soup that part inside (winding number 1 or more) from outside, ascending;
/// of those that lie on each other the first that has the inside behind it.
///
/// Requires: `soup` by divideTriangles from `surface`, which is closed and consistently oriented.
/// Exact. Cost: one ray for each part of the soup between lines where more than two triangles meet.
std::vector<Label> boundaryOfInside(const TriSurface& surface, const ExactSoup& soup);

} // namespace polymesh
