// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/base/rows.h"
#include "libpolymesh/geometry/vec3.h"

#include <string>
#include <utility>
#include <vector>

namespace polymesh {

/// A contiguous range of boundary faces with a name and an OpenFOAM type (patch, wall, ...).
struct Patch {
    std::string name;
    std::string type = "patch";
    Label start = 0; // first face
    Label size = 0;  // number of faces
    /// Further entries of the patch dictionary (inGroups, neighbourPatch, ...): key and value as
    /// they are written, without the closing semicolon; kept in order.
    std::vector<std::pair<std::string, std::string>> entries;

    bool operator==(const Patch&) const = default;
};

/// A named set of points, faces or cells. `flip` is used by face zones only: true where the zone's
/// normal is opposite to the face's.
struct Zone {
    std::string name;
    std::vector<Label> labels; // ascending
    std::vector<bool> flip;

    bool operator==(const Zone&) const = default;
};

/// A mesh of polyhedra in OpenFOAM's form: plain arrays, internal faces first.
/// Laws (checked by validate.h):
/// (1) every face has at least 3 distinct points; its right-hand normal leaves its owner;
/// (2) owner < neighbour; internal faces are sorted by (owner, neighbour);
/// (3) patches tile the boundary faces in order without a gap;
/// (4) the faces of each cell close it: every edge is used once in each direction;
/// (5) every point is used by a face; every cell has at least 4 faces.
struct PolyMesh {
    std::vector<Vec3> points;     // [m]
    Rows<Label> faces;            // point labels, one row per face
    std::vector<Label> owner;     // one per face
    std::vector<Label> neighbour; // one per internal face
    std::vector<Patch> patches;
    std::vector<Zone> pointZones;
    std::vector<Zone> faceZones;
    std::vector<Zone> cellZones;
    Label cellCount = 0;

    Label pointCount() const { return toLabel(points.size()); }

    Label faceCount() const { return faces.size(); }

    Label internalFaceCount() const { return toLabel(neighbour.size()); }

    bool isInternal(Label face) const { return face < internalFaceCount(); }

    bool operator==(const PolyMesh&) const = default;
};

} // namespace polymesh
