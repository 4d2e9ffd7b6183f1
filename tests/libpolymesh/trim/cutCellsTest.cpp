// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/cutCells.h"

#include "libpolymesh/surface/triangleBoxes.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <array>

namespace polymesh::test {
namespace {

/// Faces on the surface of the cells below and above x = 0.5.
std::array<Label, 2> boundaryFaces(const EditMesh& mesh) {
    std::array<Label, 2> count{};
    for (const EditFace& face : mesh.faces) {
        if (face.isRemoved() || !face.isBoundary()) continue;
        double x = 0;
        for (const Label p : face.points)
            x += mesh.points[index(p)].x;
        ++count[x / static_cast<double>(face.points.size()) < 0.5 ? 0 : 1];
    }
    return count;
}

TEST(CutCells, moreOfTheSurfaceIsKeptInAPlaceThatAsksForIt) {
    const TriSurface ball = sphere(4, 0.4, {0.503, 0.497, 0.501});
    const CuttingSurface cutter{&ball, pairEdges(ball), triangleBoxes(ball)};
    const SurfaceFeatures features = findFeatures(ball, cutter.edges, 0.5236);
    const FeaturedSurface surface{cutter, features};
    PolyMesh mesh = box(8, 8, 8);
    MeshCut cut = findCut(mesh, surface, {}, {});

    const auto plain = boundaryFaces(makePieces(mesh, cut, surface, {}, {}).part.mesh);
    const FidelityPlace lowHalf{{{0, 0, 0}, {0.5, 1, 1}}, 0.01};
    const auto finer =
        boundaryFaces(makePieces(mesh, cut, surface, {}, std::array{lowHalf}).part.mesh);
    EXPECT_GT(finer[0], 3 * plain[0]);
    EXPECT_EQ(finer[1], plain[1]);

    // The last place that holds a cell counts.
    const FidelityPlace asElsewhere{{{0, 0, 0}, {1, 1, 1}}, 1};
    const auto again = boundaryFaces(
        makePieces(mesh, cut, surface, {}, std::array{lowHalf, asElsewhere}).part.mesh);
    EXPECT_EQ(again, plain);
}

} // namespace
} // namespace polymesh::test
