// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/surface/triSurface.h"

#include <string>
#include <vector>

namespace polymesh {

/// How far samples of one boundary are from another one.
struct DistanceFigures {
    double max = 0;  // [m] over points and centres of faces
    double mean = 0; // [m] over centres of faces, by area
    Vec3 where;      // the sample that is furthest away
};

/// A patch beside the surface's region of the same name.
struct PatchComparison {
    std::string name;
    double area = 0;               // [m^2]
    double surfaceArea = 0;        // [m^2]
    DistanceFigures meshToSurface; // of the patch from the whole surface
    DistanceFigures surfaceToMesh; // of the region from all compared patches
};

/// A mesh beside the surface that it should fill, or leave out.
struct SurfaceComparison {
    double volume = 0;        // [m^3] within the compared patches
    double surfaceVolume = 0; // [m^3]
    double area = 0;          // [m^2] of the compared patches
    double surfaceArea = 0;   // [m^2]
    DistanceFigures meshToSurface;
    DistanceFigures surfaceToMesh;
    std::vector<PatchComparison> patches; // one per region that is a patch, too
    std::vector<std::string> missing;     // regions without a patch of that name

    double volumeError() const; // relative
    double areaError() const;   // relative
    double maxDistance() const; // [m] larger of both ways
    double meanDistance() const;
};

/// Compares the patches that bear names of the surface's regions (all patches when none does) with
/// the surface. Which side of the surface is meshed does not matter. When those patches are not
/// closed, the volume is that of the whole mesh.
/// Distances are sampled at points and face centres of the patches, and at points and triangle
/// centres of the surface.
/// Throws InputError for a surface without triangles. Cost: O(n log n); 1 s for 0.5 M samples.
SurfaceComparison compareSurface(const PolyMesh& mesh, const TriSurface& surface);

} // namespace polymesh
