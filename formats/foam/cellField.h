// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/writeFormat.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <filesystem>
#include <span>
#include <string>

namespace polymesh::foam {

/// Writes one dimensionless value a cell as the volScalarField `name` of a time directory, so
/// that ParaView can colour by it. Patches that OpenFOAM constrains get the condition of their
/// type, others zeroGradient. The file appears whole or not at all. Throws WorkError.
void writeCellField(const std::filesystem::path& timeDirectory,
                    const std::string& name,
                    const PolyMesh& mesh,
                    std::span<const double> values,
                    const WriteFormat& format);

} // namespace polymesh::foam
