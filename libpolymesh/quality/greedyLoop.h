// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/cuttingLoop.h"

namespace polymesh {

/// The loop of least weight through the edge a-b of a cell along its edges, without those that are
/// forbidden, and along chords of its faces: it need not lie in a plane and makes no new point. A
/// step weighs 1 and how far the loop would be out of plane were it closed there: the sum of
/// 1 - v . w over consecutive unit normals v, w of the turns. The search is greedy: a point that
/// has been reached keeps its way, although a dearer one might close better. None when there is no
/// loop. Cost: quadratic in the points of the cell, times the length of the loop.
/// Source: W. Oaks, S. Paoletti, Polyhedral mesh generation, equations 6 and 7.
std::optional<CellLoop>
greedyLoop(MeshEditor& editor, Label cell, std::pair<Label, Label> edge, const EdgeList& forbidden);

} // namespace polymesh
