// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The only place where the sign of a geometric quantity decides anything.
//
// The surface is thought to be moved by (e1, e2, e3), e1 >> e2 >> e3 > 0, all infinitesimal. A mesh
// in general position to the moved surface has no ties, so that every predicate between a mesh
// entity and a surface entity has a sign that is not zero. Laws:
// (1) signs are those of exact arithmetic on the coordinates given;
// (2) exchanging two arguments of one kind turns the sign;
// (3) signs depend on coordinates alone, never on labels, so separate runs decide alike.
// Source: symbolic perturbation after Edelsbrunner and Muecke (1990), here with one common
// translation; the filters and the exact arithmetic are CGAL's.

#include "libpolymesh/geometry/vec3.h"

#include <array>
#include <cstdint>
#include <span>

namespace polymesh {

/// The sign of a predicate on the moved surface, and whether it was zero on the surface as given.
struct MovedSign {
    std::int8_t sign = 0; // -1 or 1; 0 only where a function says so
    bool wasZero = false;
};

/// Sign of det(b - a, c - a, d - a): positive where d lies on the side to which the right-hand
/// normal of (a, b, c) points.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Sign of component `axis` of (b - a) x (c - a).
int normalSign(const Vec3& a, const Vec3& b, const Vec3& c, int axis);

/// Sign of component `axis` of (b - a) x (d - c).
int crossSign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, int axis);

/// On which side of the moved surface triangle `t` the mesh point lies: 1 where the normal points.
/// A triangle without area has every point on side 1.
MovedSign sideOfTriangle(const std::array<Vec3, 3>& t, const Vec3& meshPoint);

/// On which side of the plane through the mesh points `f` the moved surface point lies: 1 where the
/// normal points. A plane through collinear points has every point on side 1.
MovedSign sideOfMeshPlane(const std::array<Vec3, 3>& f, const Vec3& surfacePoint);

/// Sign of det(b - a, p - a, q - a) for a mesh edge a b and the moved surface edge p q: how they
/// pass each other. 0 when they are parallel.
MovedSign passingSide(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q);

/// Whether the polygon's points lie in one plane and it is convex in it (edges may be collinear).
/// Exact. A polygon without area is not convex.
bool isPlanarConvex(std::span<const Vec3> polygon);

/// Order along the mesh edge a b, seen from a, of its crossings with the moved triangles s and t:
/// -1 where s comes first, 1 where t does, 0 where they lie in one plane.
int compareAlongMeshEdge(const Vec3& a,
                         const Vec3& b,
                         const std::array<Vec3, 3>& s,
                         const std::array<Vec3, 3>& t);

/// Order along the moved surface edge p q, seen from p, of its crossings with the planes through
/// the mesh points f and g: -1 where f comes first, 1 where g does, 0 where the planes are the
/// same.
int compareAlongSurfaceEdge(const Vec3& p,
                            const Vec3& q,
                            const std::array<Vec3, 3>& f,
                            const std::array<Vec3, 3>& g);

} // namespace polymesh
