// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/base/rows.h"
#include "libpolymesh/geometry/vec3.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <span>
#include <vector>

namespace polymesh {

// Centres, areas and volumes by OpenFOAM's definitions, with its order of operations, so that
// figures agree to the last digits and a face that OpenFOAM accepts is accepted here.

/// Centre [m] and area vector [m^2] of a polygon; the right-hand rule gives the vector's sense.
struct FaceGeometry {
    Vec3 centre;
    Vec3 area;
};

/// Centre [m] and volume [m^3] of a polyhedron.
struct CellGeometry {
    Vec3 centre;
    double volume = 0;
};

/// Geometry of all faces and cells of a mesh.
struct MeshGeometry {
    std::vector<Vec3> faceCentres;   // [m] one per face
    std::vector<Vec3> faceAreas;     // [m^2] one per face, from owner to neighbour
    std::vector<Vec3> cellCentres;   // [m] one per cell
    std::vector<double> cellVolumes; // [m^3] one per cell; negative when the cell is inside out
};

/// Geometry of the polygon through points[face[0]], points[face[1]], ...: a triangle's own; for
/// more corners the fan of triangles round the mean of the corners, centres weighted with the
/// triangles' area magnitudes. A polygon without extent has area 0 and the mean as its centre.
FaceGeometry faceGeometry(std::span<const Vec3> points, std::span<const Label> face);

/// Geometry of the polyhedron bounded by `faces`, whose area vectors point out of it: the pyramids
/// over the mean of the face centres, centres weighted with volumes. Without volume the centre is
/// that mean; without faces it is the origin.
CellGeometry cellGeometry(std::span<const FaceGeometry> faces);

/// Geometry of every face and cell; equal for any number of threads.
/// Requires: labels in range (validate.h).
/// Cost: O(face corners), about 0.1 s for a million hexahedra on 2 cores.
MeshGeometry computeGeometry(const PolyMesh& mesh);

/// The same when the faces of each cell (topology.h) are at hand.
MeshGeometry computeGeometry(const PolyMesh& mesh, const Rows<Label>& cellFaces);

/// Volume [m^3] that the boundary of a mesh holds: the sum of its cells' volumes but for rounding,
/// of which there is less. Cost: O(corners of boundary faces).
double boundedVolume(const PolyMesh& mesh);

} // namespace polymesh
