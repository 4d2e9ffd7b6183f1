// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/box.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace polymesh {

/// How a set of faces hangs together, in OpenFOAM's terms.
enum class SurfaceKind : std::uint8_t {
    empty,       // no faces
    closed,      // every edge between two faces
    sharedPoint, // closed, but parts of it meet at a point only
    open,        // some edge has one face
    sharedEdge   // some edge has three faces or more
};

/// The topology of a patch or face zone as a surface.
struct PatchTopology {
    std::string name;
    Label faces = 0;
    Label points = 0;
    SurfaceKind kind = SurfaceKind::empty;
    std::vector<Label> conflictingPoints; // ascending: shared points, ends of shared edges
    Box box;
};

/// Of the given faces. O(n log n) in their corners.
PatchTopology
patchTopology(const PolyMesh& mesh, const std::string& name, std::span<const Label> faces);

/// OpenFOAM's words: "ok (closed singly connected)", ...
std::string describe(SurfaceKind kind);

} // namespace polymesh
