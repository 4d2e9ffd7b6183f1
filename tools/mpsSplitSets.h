// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"

#include <filesystem>

namespace polymesh::tools {

/// The sets of a mesh on their way through a tool that takes zones along: they travel as zones
/// behind the mesh's own.
struct TravellingSets {
    std::size_t pointZones = 0; // of the mesh itself
    std::size_t faceZones = 0;
    std::size_t cellZones = 0;
};

/// Adds the sets of a polyMesh directory to the mesh as zones; files that are no sets are left
/// out. Throws InputError for a set with labels that the mesh has not.
TravellingSets takeSets(const std::filesystem::path& meshDir, PolyMesh& mesh);

/// Takes these zones out of the mesh again, and returns them in a mesh that has nothing else.
PolyMesh removeSets(const TravellingSets& sets, PolyMesh& mesh);

/// Writes the zones of `sets` as sets of the directory. Throws WorkError.
void writeSets(const std::filesystem::path& meshDir, const PolyMesh& sets);

} // namespace polymesh::tools
