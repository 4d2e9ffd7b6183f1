// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/vec3.h"

#include <boost/container/small_vector.hpp>

#include <cstdint>
#include <vector>

namespace polymesh {

/// How free a point is: it may be collapsed onto a point of the same or a higher rank only.
enum class PointRank : std::uint8_t {
    interior, // inside the domain
    surface,  // on a boundary patch
    feature,  // on a feature edge: sharp, or between two patches
    corner,   // where feature edges meet or turn
    fixed     // must stay: a cell outside the edited part uses it
};

/// The corners of a face.
using Polygon = boost::container::small_vector<Label, 6>;

/// A polygon between two cells or on a patch; its right-hand normal leaves `owner`.
struct EditFace { // NOLINT(bugprone-exception-escape): boost's move may allocate
    Polygon points;
    Label owner = -1;     // -1: the face has been removed
    Label neighbour = -1; // -1: boundary
    Label patch = -1;     // -1: internal

    bool isRemoved() const { return owner < 0; }

    bool isBoundary() const { return neighbour < 0; }
};

/// A cell of the edited part.
struct EditCell { // NOLINT(bugprone-exception-escape): boost's move may allocate
    boost::container::small_vector<Label, 8> faces; // empty: the cell has been removed
    double size = 0;     // [m] edge length of the hexahedron it came from (cube root of its volume)
    bool frozen = false; // outside the edited part: only some of its faces are here; never changed
    Label origin = -1;   // the cell of the initial mesh that it is a part of

    bool isRemoved() const { return faces.empty(); }
};

/// The part of a mesh that is being edited: the cut cells and those round them, with cheap local
/// changes. Faces are in no order; owner and neighbour may come in either order.
/// Laws: (1) the faces of each cell that is not frozen close it: every edge is used once in each
/// direction; (2) a point of a frozen cell has rank `fixed`; (3) a face lists no point twice.
struct EditMesh {
    std::vector<Vec3> points;     // [m]
    std::vector<PointRank> ranks; // one per point
    std::vector<EditFace> faces;
    std::vector<EditCell> cells;
};

/// Fills in the faces of each cell, ascending, from the owners and neighbours of the faces.
/// Cost: O(faces), in parallel.
void listFacesOfCells(EditMesh& mesh);

} // namespace polymesh
