// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/foamReader.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <vector>

namespace polymesh::foam {

/// What zones are made of.
enum class ZoneKind { point, face, cell };

/// Reads the patches of a boundary file, which is text whatever its header says. Every patch has a
/// type, nFaces and startFace; all further entries are kept. Throws InputError with file and line.
std::vector<Patch> readPatches(FoamReader& reader);

/// Reads a zone file. `elementCount` is the number of points, faces or cells of the mesh; labels
/// are in range and become ascending. Throws InputError with file and line or zone name.
std::vector<Zone> readZones(FoamReader& reader, ZoneKind kind, Label elementCount);

} // namespace polymesh::foam
