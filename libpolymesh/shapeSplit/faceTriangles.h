// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <vector>

namespace polymesh {

/// Triangles in place of a boundary face, with one or more new points.
struct FaceTriangles {
    /// What stands for a new point in `triangles`, and the number of the one that stands there.
    static Label placeholder(std::size_t number) { return -1 - toLabel(number); }

    static std::size_t number(Label placeholder) { return index(-1 - placeholder); }

    std::vector<Polygon> triangles; // running as the face does
    std::vector<Vec3> positions;    // [m] of the new points
    double roundness = 0;           // the least over the triangles; less for new points far off
    double slope = 0;               // height of new points by the root of the area under them
    bool isTurned = false;          // a triangle looks against the face
};

/// Ways to put triangles in place of a boundary face such that they bound the volume that the face
/// bounded, by OpenFOAM's definition: every triangulation by the corners, for faces of more than
/// six points that of least area, with a new point over one of the triangles, or over each, at the
/// height that makes up for the difference. The roundest come first, those with triangles that are
/// turned last. Those are left out of which a triangle is flat, or has an edge that a cell has
/// elsewhere. Whether the triangles cross anything is not looked at.
std::vector<FaceTriangles> trianglesKeepingVolume(const MeshEditor& editor, Label face);

/// Puts them in place of the face.
void replaceByTriangles(MeshEditor& editor, Label face, const FaceTriangles& triangles);

} // namespace polymesh
