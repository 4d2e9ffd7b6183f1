// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/base/rows.h"
#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/surface/tetMesh.h"
#include "libpolymesh/surface/triSurface.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace polymesh {

// TetGen, an independent mesher: volumes to compare ours with, and tetrahedra for cells that
// nothing else divides. TetGen is not thread-safe and crashes on bad input, so it runs in child
// processes. Its licence is AGPL: it is used by tetgen.cpp alone, and not at all when the project
// is configured with POLYMESH_TETGEN=OFF.

/// Whether this build has TetGen. Without it the functions below throw InputError.
bool hasTetgen();

/// Volume [m^3] of TetGen's tetrahedra inside a closed surface; none when TetGen fails. Regions
/// that the surface winds round an even number of times (cavities) are left out.
/// Throws WorkError when no child process can be started. Cost: TetGen's, about 10 s for 0.1 M
/// triangles.
std::optional<double> tetgenVolume(const TriSurface& surface);

/// Volumes [m^3] of TetGen's tetrahedra of some cells; none where TetGen fails. Flat faces are
/// given whole, others as their fans about the mean of their corners.
/// Cost: about 0.1 ms a cell.
std::vector<std::optional<double>>
tetgenVolumes(const PolyMesh& mesh, const Rows<Label>& cellFaces, std::span<const Label> cells);

/// A function that fills a closed surface with TetGen's tetrahedra and leaves its triangles as they
/// are; it finds none where TetGen fails, as on a surface that crosses itself. Without TetGen the
/// function is empty. Not for several threads at a time.
/// Cost: some milliseconds for the child process at the first call, 0.2 ms for 30 triangles.
std::function<std::optional<TetMesh>(const TriSurface&)> tetgenTetrahedraliser();

} // namespace polymesh
