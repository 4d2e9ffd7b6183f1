// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/shapeSplit/splitCells.h"
#include "libpolymesh/shapes/classify.h"
#include "tools/toolMain.h"

#include <vector>

namespace polymesh::tools {

/// Prints the catalogue: a line a shape, a line a base with the number of its variants, the total.
void listShapes(ToolRun& tool);

/// Prints and reports what -split did.
void reportSplit(ToolRun& tool,
                 const ShapeSplitCounts& counts,
                 double volumeBefore,
                 double volumeAfter);

/// Prints and reports how many cells have each shape and how many have none, which it returns.
Label reportShapes(ToolRun& tool, const std::vector<CellShape>& shapes);

/// Prints and reports what keeps the unrecognised cells from being acceptable (shapes/obstacle.h).
void reportObstacles(ToolRun& tool,
                     const PolyMesh& mesh,
                     const Rows<Label>& cellFaces,
                     const std::vector<CellShape>& shapes);

/// Writes what ParaView can colour: the fields 0/cellShape (number of the shape in the list of
/// -listShapes) and 0/cellBaseShape (number of its base), both -1 for cells without a shape, and
/// the set of those cells.
void writeShapes(const ToolRun& tool, const PolyMesh& mesh, const std::vector<CellShape>& shapes);

} // namespace polymesh::tools
