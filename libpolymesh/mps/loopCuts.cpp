// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/loopCuts.h"

#include "libpolymesh/mps/loopCutter.h"
#include "libpolymesh/mps/searchCells.h"

namespace polymesh {

namespace {

CellPart wholeCell(const PolyMesh& mesh, const SubdivisionPlan& plan, Label cell) {
    CellPart whole{outwardLoops(mesh, plan.cellFaces, cell), {}, {}};
    for (std::size_t f = 0; f < whole.loops.size(); ++f)
        whole.sources.push_back(static_cast<int>(f));
    return whole;
}

} // namespace

std::vector<CellCones> loopCutsOf(const PolyMesh& mesh,
                                  const Bends& bends,
                                  const SubdivisionPlan& plan,
                                  std::span<const Label> cells) {
    return searchCells(cells, [&](Label cell) {
        return LoopCutter(mesh, bends, cell, wholeCell(mesh, plan, cell)).find();
    });
}

} // namespace polymesh
