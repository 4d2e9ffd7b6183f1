// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/writeFormat.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <filesystem>

namespace polymesh::foam {

/// Reads points, faces, owner, neighbour, boundary and the zones of a polyMesh directory: ascii or
/// binary of any label and scalar size, each file plain or gzipped (the plain one wins).
/// Result: a mesh whose indices are all in range, whose patches tile the boundary and whose
/// coordinates are finite; the laws of PolyMesh about shape are for validate.h.
/// The cell count is the largest label in owner and neighbour plus one.
/// Throws InputError with the file and line, byte or element that is wrong.
/// Cost: linear, about 1 GB/s for binary; memory is the mesh's own.
PolyMesh readPolyMesh(const std::filesystem::path& polyMeshDirectory);

/// Writes a mesh in place of the whole directory: whatever the old one held about the old mesh
/// (sets, levels, addressing) goes with it, files whose names end in Dict stay. The new files are
/// written beside it and take its place in one step, so that a failure or a kill leaves the old
/// mesh as it was. Throws WorkError naming the file that cannot be written.
/// Cost: linear, about 1 GB/s for binary.
void writePolyMesh(const PolyMesh& mesh,
                   const std::filesystem::path& polyMeshDirectory,
                   const WriteFormat& format);

} // namespace polymesh::foam
