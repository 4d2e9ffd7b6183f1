// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/writeFormat.h"

#include <filesystem>
#include <optional>
#include <string>

namespace polymesh::foam {

/// An OpenFOAM case: where its files are. The region is empty for a case of one mesh.
struct CaseDirectory {
    std::filesystem::path root = ".";
    std::string region;

    /// constant/polyMesh or constant/region/polyMesh
    std::filesystem::path polyMesh() const { return root / "constant" / region / "polyMesh"; }

    /// A dictionary of the region in system, such as blockInitDict.
    std::filesystem::path system(const std::string& name) const {
        return root / "system" / region / name;
    }

    /// system/controlDict, which all regions share
    std::filesystem::path controlDict() const { return root / "system" / "controlDict"; }

    /// constant/triSurface, where surfaces are usually kept
    std::filesystem::path triSurface() const { return root / "constant" / "triSurface"; }
};

/// The format that `option` (ascii, binary, ascii.gz, binary.gz) asks for, else the one that
/// system/controlDict asks for by writeFormat, writePrecision and writeCompression, else binary.
/// Coordinates get at least 10 digits, as from OpenFOAM's own mesh tools, and as many as they need
/// when nothing is asked; compression is ignored by OpenFOAM in binary, so only the option gives
/// binary.gz. Throws InputError for a wrong option or a controlDict that can not be understood.
WriteFormat writeFormat(const CaseDirectory& caseDirectory,
                        const std::optional<std::string>& option = std::nullopt);

} // namespace polymesh::foam
