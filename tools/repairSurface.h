// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"
#include "tools/toolMain.h"

#include <string>

namespace polymesh::tools {

/// Closes an open surface where points of its edges differ by rounding only. What was done, for a
/// message; "" when that does not close it, and the surface is as it was. Enters the report.
std::string closeCracks(ToolRun& tool, TriSurface& surface);

/// Unites the parts of a surface that intersects itself. What was done, for a message; "" when that
/// fails, and the surface is as it was. Enters the report.
std::string uniteParts(ToolRun& tool, TriSurface& surface);

} // namespace polymesh::tools
