// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <vector>

namespace polymesh {

/// Triangles in place of a boundary face, with one new point.
struct FaceTriangles {
    static constexpr Label middle = -1; // stands for the new point in `triangles`

    std::vector<Polygon> triangles; // running as the face does
    Vec3 position;                  // [m] of the new point
    double roundness = 0;           // the least over the triangles; less for a new point far off
    bool isTurned = false;          // a triangle looks against the face
};

/// Ways to put triangles in place of a boundary face such that they bound the volume that the face
/// bounded, by OpenFOAM's definition: every triangulation by the corners, for faces of more than
/// six points that of least area, with the new point over one of the triangles at the height that
/// makes up for the difference. The roundest come first, those with triangles that are turned last.
/// Those are left out of which a triangle is flat, or has an edge that a cell has elsewhere.
/// Whether the triangles cross anything is not looked at.
std::vector<FaceTriangles> trianglesKeepingVolume(const MeshEditor& editor, Label face);

/// Puts them in place of the face.
void replaceByTriangles(MeshEditor& editor, Label face, const FaceTriangles& triangles);

} // namespace polymesh
