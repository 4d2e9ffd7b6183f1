// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/quality/checks.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace polymesh::tools {

/// The report as text, line by line as OpenFOAM's checkMesh prints it with numbers of `precision`
/// significant digits, so that scripts which read the one can read the other. Lines that begin with
/// "    worst:" are ours: they say where the offenders of a failing check are.
std::string reportText(const PolyMesh& mesh, const MeshReport& report, int precision);

/// "Mesh OK." or "Failed N mesh checks."
std::string verdictText(const MeshReport& report);

/// The report for -json: counts, shapes, figures, failing checks and the worst offenders.
nlohmann::ordered_json reportJson(const PolyMesh& mesh, const MeshReport& report);

} // namespace polymesh::tools
