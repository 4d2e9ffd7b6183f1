// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace polymesh::foam {

enum class SetKind { point, face, cell };

/// Writes a set of points, faces or cells to sets/`name` of a polyMesh directory, where OpenFOAM
/// and ParaView find it. Sets are text whatever the format of the mesh is. The file appears whole
/// or not at all. Throws WorkError.
void writeSet(const std::filesystem::path& polyMeshDirectory,
              SetKind kind,
              const std::string& name,
              std::span<const Label> labels);

/// Reads the labels of such a set, made ascending and each once. Throws InputError when it is not
/// a set of this kind.
std::vector<Label>
readSet(const std::filesystem::path& polyMeshDirectory, SetKind kind, const std::string& name);

} // namespace polymesh::foam
