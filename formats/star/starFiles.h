// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polymesh::star {

/// Of pro-STAR, whose files they are. Version 3: regular and trimmed cells. Version 4: also
/// polyhedra.
enum class Version : std::uint8_t { v3 = 3, v4 = 4 };

/// A mesh that was read, and a line for everything that the files hold and it does not.
struct StarMesh {
    PolyMesh mesh;
    std::vector<std::string> notes;
};

/// The version of the files prefix.vrt, prefix.cel; none when there are no such files.
std::optional<Version> versionOf(const std::filesystem::path& prefix);

/// Reads prefix.vrt and prefix.cel, and prefix.bnd, prefix.inp and (version 3) prefix.cpl where
/// they are there. Coordinates are multiplied by `scale`.
///
/// Cells keep their order, points too. Cells of the cell table become cell zones; regions become
/// patches, in the order of their numbers, and boundary faces of no region the last patch,
/// Default_Boundary_Region. Both get their names and types from the .inp file; without it, names
/// are those that OpenFOAM's star4ToFoam (wall_1) and star3ToFoam (WALL1) give. docs/starFiles.md
/// has the details.
/// Throws InputError with file and line for files that are malformed.
/// Cost: linear in the size of the files, some 100 MB/s on one core.
StarMesh read(const std::filesystem::path& prefix, Version version, double scale);

/// Writes prefix.vrt, prefix.cel, prefix.bnd and prefix.inp, all of them or, on failure, none; an
/// old prefix.cpl is removed. Coordinates are multiplied by `scale`. Returns a line for everything
/// that the mesh holds and the files do not.
/// Requires: the mesh is valid (mesh/validate.h).
/// Throws WorkError when a file cannot be written, and, for version 3, when the mesh has a cell
/// that is not in the catalogue of shapes (shapes/catalogue.h).
/// Cost: linear, some 100 MB/s on one core; formatted by all threads.
std::vector<std::string>
write(const PolyMesh& mesh, const std::filesystem::path& prefix, Version version, double scale);

/// prefix with one of the endings that the files of a set have (.vrt, .cel, .bnd, .inp, .cpl)
/// taken away.
std::filesystem::path prefixOf(const std::filesystem::path& name);

} // namespace polymesh::star
