// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/simplify.h"

#include "arranged.h"
#include "libpolymesh/surface/features.h"
#include "libpolymesh/trim/chains.h"
#include "libpolymesh/trim/sharpness.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace polymesh::test {
namespace {

constexpr double featureAngle = 0.5236; // [rad]

/// A ball in the unit cube whose radius goes up and down by `height` [m].
TriSurface bumpyBall(double height) {
    const Vec3 centre{0.503, 0.497, 0.501};
    TriSurface ball = sphere(4, 1, {});
    for (Vec3& p : ball.points)
        p = centre +
            (0.4 + height * std::sin(9 * p.x + 1) * std::cos(7 * p.y) * std::sin(8 * p.z)) * p;
    return ball;
}

/// Distance of a point from a polygon as the fan round the mean of its corners [m].
double
distanceToFan(const PointPositions& positions, std::span<const Label> polygon, const Vec3& p) {
    Vec3 middle;
    for (const Label corner : polygon)
        middle += positions[index(corner)];
    middle = middle / static_cast<double>(polygon.size());
    double least = Box::inf;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        least = std::min(least,
                         distanceToTriangle(p,
                                            positions[index(polygon[i])],
                                            positions[index(polygon[(i + 1) % polygon.size()])],
                                            middle));
    return least;
}

/// The largest distance between what the surface was in a cell and what it has become [m].
double largestDeviation(const PointPositions& positions,
                        const CellPieces& pieces,
                        const BoundaryPolygons& boundary) {
    double largest = 0;
    for (std::size_t c = 0; c + 1 < pieces.offsets.size(); ++c)
        for (Label i = pieces.offsets[c]; i < pieces.offsets[c + 1]; ++i)
            for (const Label p : pieces.polygons[i]) {
                double least = Box::inf;
                for (Label k = boundary.offsets[c]; k < boundary.offsets[c + 1]; ++k)
                    least = std::min(
                        least, distanceToFan(positions, boundary.polygons[k], positions[index(p)]));
                largest = std::max(largest, least);
            }
    return largest;
}

TEST(Simplify, noPointOfTheSurfaceIsFartherThanTheToleranceFromTheFacesOfItsCell) {
    for (const double height : {0.05, 0.1})
        for (const Label n : {5, 8, 11})
            for (const double tolerance : {0.001, 0.003, 0.01}) {
                Arranged a(box(n, n, n), bumpyBall(height));
                const CellPieces pieces = cutTriangles(a.probe, a.cutter, a.arrangement);
                const SurfaceFeatures features =
                    findFeatures(a.surface, a.cutter.edges, featureAngle);
                const std::vector<double> tolerances(index(a.probe.cellCount()), tolerance);
                const Fidelity fidelity{false,
                                        tolerances,
                                        edgeSharpness(a.surface, a.cutter.edges, features),
                                        features.isCorner,
                                        featureAngle};
                const BoundaryPolygons boundary = simplify(
                    {a.probe, a.cutter, a.arrangement}, a.positions, pieces, fidelity, a.loops);
                EXPECT_LT(boundary.polygons.size(), pieces.polygons.size() / 2);
                EXPECT_LE(largestDeviation(a.positions, pieces, boundary), tolerance)
                    << height << ' ' << n << ' ' << tolerance;
            }
}

} // namespace
} // namespace polymesh::test
