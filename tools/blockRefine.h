// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/hexCells.h"
#include "libpolymesh/refine/refine.h"
#include "tools/toolMain.h"

#include <optional>
#include <string>
#include <vector>

namespace polymesh::tools {

/// -level, -levels, -curvature, -nCellsBetweenLevels and -parallel.
const std::vector<Option>& refineOptions();

/// What the options and `refinement { ... }` ask for, which is in the dictionary of the tool or
/// else in that of the blocks (empty: none); empty when nothing is refined. The options are about
/// -surface. Throws InputError.
std::optional<RefineOptions> refinementOf(const ToolRun& tool, const std::filesystem::path& blocks);

/// Refines the cells, writes the mesh with its levels and reports.
ExitCode runRefine(ToolRun& tool, const HexCells& cells, const RefineOptions& options);

} // namespace polymesh::tools
