// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/orient.h"

#include <fmt/format.h>

#include <string>

namespace polymesh::tools {

/// What was turned, in the words that all tools use for it.
inline std::string turnedText(const OrientationReport& turned) {
    return fmt::format("{} triangles, so that normals leave the part{}",
                       turned.turnedTriangles,
                       turned.turnedAll ? " (the surface was inside out)" : "");
}

} // namespace polymesh::tools
