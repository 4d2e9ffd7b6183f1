// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Quality of single faces and cells by OpenFOAM's definitions (version 1912), with its order of
// operations. Numbers only: the limits are in checks.h. All are O(corners of the face or cell).

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/vec3.h"
#include "libpolymesh/mesh/cellGeometry.h"

#include <array>
#include <span>

namespace polymesh {

/// Which of the three directions count: false where an `empty` patch faces that way.
using Directions = std::array<bool, 3>;

/// Cosine of the angle between the line of two cell centres and the area vector of their face;
/// 1 is orthogonal, 0 or less useless.
double orthogonality(const Vec3& ownerCentre, const Vec3& neighbourCentre, const Vec3& area);

/// Distance from the face centre to where the line of the cell centres meets the face's plane, by
/// the face's extent that way (at least 0.2 of the line's length).
double internalSkewness(std::span<const Vec3> points,
                        std::span<const Label> face,
                        const FaceGeometry& geometry,
                        const Vec3& ownerCentre,
                        const Vec3& neighbourCentre);

/// The same against the normal from the cell centre (at least 0.4 of its length).
double boundarySkewness(std::span<const Vec3> points,
                        std::span<const Label> face,
                        const FaceGeometry& geometry,
                        const Vec3& ownerCentre);

/// Volume [m^3] of the pyramid from `apex` to the face; positive when the normal leaves the apex.
double pyramidVolume(const FaceGeometry& geometry, const Vec3& apex);

/// Volume by that of the regular tetrahedron in the same circumsphere, in [-1, 1]; positive when
/// a, b, c run counter-clockwise seen from d.
double tetQuality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The lowest quality of the tetrahedra from `apex` and the face's centre to its edges. The apex
/// should lie behind the face when it is the owner's centre, before it when the neighbour's.
double faceTetQuality(std::span<const Vec3> points,
                      std::span<const Label> face,
                      const Vec3& faceCentre,
                      const Vec3& apex,
                      bool isNeighbour);

/// True when some corner of the face gives tetrahedra of quality above `limit` with the face's
/// other edges and each of the apices: the owner's centre, and the neighbour's unless null.
bool hasTetBasePoint(std::span<const Vec3> points,
                     std::span<const Label> face,
                     const Vec3& ownerCentre,
                     const Vec3* neighbourCentre,
                     double limit);

/// Largest sine of a turn between consecutive edges against the face's normal; turns with a sine
/// below `ignoredSine` are taken as straight.
double faceConcavity(std::span<const Vec3> points,
                     std::span<const Label> face,
                     const Vec3& area,
                     double ignoredSine);

/// Area by the sum of the areas of the triangles round the face's centre, in [0, 1]; 1 is flat.
/// Triangles and faces without area are flat.
double faceFlatness(std::span<const Vec3> points,
                    std::span<const Label> face,
                    const FaceGeometry& geometry);

/// Smaller by sum of the two distances from the cell centres to the face, in [0, 0.5].
double
faceWeight(const FaceGeometry& geometry, const Vec3& ownerCentre, const Vec3& neighbourCentre);

/// Smaller by larger of two cell volumes.
double volumeRatio(double ownerVolume, double neighbourVolume);

/// How far a cell's area vectors are from adding up to zero, and how stretched it is.
struct CellClosedness {
    double openness = 0; // largest over x, y, z of |sum| / sum of magnitudes
    double aspectRatio = 0;
};

/// Of a cell with these outward area vectors. With three directions the ratio is also that of
/// area to volume^(2/3), which is 1 for a cube; without directions it is -1, as in OpenFOAM.
CellClosedness
cellClosedness(std::span<const Vec3> outwardAreas, double volume, const Directions& directions);

/// How well the faces to other cells determine a gradient, in [0, 1], a cube with six such faces
/// being 1. Areas may have either sense. A cell without such faces has 0; in one dimension 1.
double cellDeterminant(std::span<const Vec3> areas, const Directions& directions);

/// True when the centre of some face is not clearly behind the plane of another one.
/// OpenFOAM's test: two coplanar faces make a cell concave. `faces` have outward area vectors.
bool isConcaveCell(std::span<const FaceGeometry> faces);

} // namespace polymesh
