// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/keepHexahedra.h"

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/mps/halvedFace.h"
#include "libpolymesh/quality/standardShape.h"
#include "libpolymesh/trim/trim.h"
#include "tests/support/meshes.h"
#include "tests/support/sameMesh.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <set>
#include <vector>

namespace polymesh::test {
namespace {

/// Corners 0 to 3, the middles 4 to 7 that the mask has bits for, the centre 8.
HalvedFace faceOf(unsigned mask, std::size_t first = 0) {
    HalvedFace face;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t at = (i + first) % 4;
        face.corners[i] = toLabel(at);
        face.middles[i] = (mask >> at & 1U) != 0 ? toLabel(4 + at) : -1;
    }
    face.centre = 8;
    return face;
}

const std::vector<Vec3> square{{0, 0, 0},
                               {2, 0, 0},
                               {2, 2, 0},
                               {0, 2, 0},
                               {1, 0, 0},
                               {2, 1, 0},
                               {1, 2, 0},
                               {0, 1, 0},
                               {1, 1, 0}};

/// Pieces as sets of points.
std::set<std::set<Label>> setsOf(const HalvedPieces& pieces) {
    std::set<std::set<Label>> sets;
    for (const HalvedPiece& piece : pieces)
        sets.insert(std::set<Label>(piece.begin(), piece.end()));
    return sets;
}

TEST(HalvedFace, piecesCoverTheFaceWithAllItsPoints) {
    for (unsigned mask = 0; mask < 16; ++mask) {
        double area = 0;
        std::set<Label> points;
        for (const HalvedPiece& piece : piecesOf(faceOf(mask))) {
            const Vec3 own =
                faceGeometry(square, std::span<const Label>(piece.data(), piece.size())).area;
            EXPECT_GT(own.z, 0.4) << mask;
            area += own.z;
            points.insert(piece.begin(), piece.end());
        }
        EXPECT_DOUBLE_EQ(area, 4) << mask;
        const auto middles = static_cast<std::size_t>(std::popcount(mask));
        EXPECT_EQ(points.size(), 4 + middles + (mask == 15 ? 1 : 0)) << mask;
    }
}

TEST(HalvedFace, piecesAreTheSameFromBothSidesAndAnyCorner) {
    for (unsigned mask = 0; mask < 16; ++mask) {
        const auto expected = setsOf(piecesOf(faceOf(mask)));
        for (std::size_t first = 0; first < 4; ++first) {
            HalvedFace face = faceOf(mask, first);
            EXPECT_EQ(setsOf(piecesOf(face)), expected) << mask;
            std::ranges::reverse(face.corners);
            std::reverse(face.middles.begin(), face.middles.end() - 1);
            EXPECT_EQ(setsOf(piecesOf(face)), expected) << mask;
        }
    }
}

struct Part {
    Divisible divisible;
    std::vector<Fate> fates;
    PolyMesh whole;
    PartlyDivided partly;
};

Part divideInPart(const PolyMesh& mesh) {
    Part part{makeDivisible(mesh, {}, Hexahedra::kept), {}, {}, {}};
    part.fates = fatesOf(part.divisible.mesh, part.divisible.plan, part.divisible.bends);
    part.whole = divide(part.divisible.mesh, std::move(part.divisible.plan));
    part.partly = keepHexahedra(part.divisible, part.fates, part.whole);
    return part;
}

/// Hexahedra inside a ball, other polyhedra at its surface.
PolyMesh trimmedBall() {
    TrimOptions options;
    return trim(box(12, 12, 12), sphere(4, .43, {.5, .5, .5}), options).mesh;
}

TEST(KeepHexahedra, dividesTheRestConformally) {
    const PolyMesh mesh = trimmedBall();
    const Part part = divideInPart(mesh);
    const PolyMesh& result = part.partly.mesh;
    EXPECT_TRUE(validate(result).empty());
    EXPECT_NEAR(boundedVolume(result) / boundedVolume(mesh), 1, 1e-12);
    for (const double volume : computeGeometry(result).cellVolumes)
        EXPECT_GT(volume, 0);
    const ShapeCounts shapes = countShapes(result, cellFaces(result));
    EXPECT_EQ(shapes[StandardShape::hexahedron] + shapes[StandardShape::pyramid] +
                  shapes[StandardShape::tetrahedron],
              result.cellCount);
    EXPECT_GT(std::ranges::count(part.fates, Fate::whole), 100);
    EXPECT_GT(std::ranges::count(part.fates, Fate::layer), 100);
}

TEST(KeepHexahedra, leavesWholeCellsAsTheyAre) {
    const PolyMesh mesh = trimmedBall();
    const Part part = divideInPart(mesh);
    const MeshGeometry before = computeGeometry(part.divisible.mesh);
    const MeshGeometry after = computeGeometry(part.partly.mesh);
    for (std::size_t c = 0; c < part.fates.size(); ++c) {
        if (part.fates[c] != Fate::whole) continue;
        const std::size_t now = index(part.partly.firstCell[c]);
        EXPECT_EQ(part.partly.firstCell[c + 1], part.partly.firstCell[c] + 1);
        EXPECT_NEAR(after.cellVolumes[now], before.cellVolumes[c], 1e-18);
        EXPECT_NEAR(norm(after.cellCentres[now] - before.cellCentres[c]), 0, 1e-15);
    }
}

TEST(KeepHexahedra, changesNothingWhereAllAreHexahedra) {
    const PolyMesh mesh = jittered(box(4, 3, 2), 0.03);
    EXPECT_EQ(differenceOf(divideInPart(mesh).partly.mesh, mesh, 0), "");
}

TEST(KeepHexahedra, dividesAllWhereNoneIs) {
    const Part part = divideInPart(prismFan(7));
    EXPECT_EQ(differenceOf(part.partly.mesh, part.whole, 0), "");
}

TEST(KeepHexahedra, takesZonesAlong) {
    PolyMesh mesh = trimmedBall();
    std::vector<Label> all(index(mesh.cellCount));
    std::iota(all.begin(), all.end(), 0);
    mesh.cellZones.push_back({"all", all, {}});
    Zone inner{"inner", {}, {}};
    for (Label f = 0; f < mesh.internalFaceCount(); f += 3) {
        inner.labels.push_back(f);
        inner.flip.push_back(f % 2 == 0);
    }
    mesh.faceZones.push_back(inner);
    const double area = [&] { // of the faces, each with its sign
        double sum = 0;
        for (std::size_t i = 0; i < inner.labels.size(); ++i) {
            const Vec3 own = faceGeometry(mesh.points, mesh.faces[inner.labels[i]]).area;
            sum += (inner.flip[i] ? -1 : 1) * (own.x + 2 * own.y + 3 * own.z);
        }
        return sum;
    }();
    Part part{makeDivisible(mesh, {{1, 1}, {}}, Hexahedra::kept), {}, {}, {}};
    part.fates = fatesOf(part.divisible.mesh, part.divisible.plan, part.divisible.bends);
    part.whole = divide(part.divisible.mesh, std::move(part.divisible.plan));
    const PolyMesh result = keepHexahedra(part.divisible, part.fates, part.whole).mesh;
    ASSERT_EQ(result.cellZones.size(), 1U);
    EXPECT_EQ(toLabel(result.cellZones[0].labels.size()), result.cellCount);
    ASSERT_EQ(result.faceZones.size(), 1U);
    const Zone& pieces = result.faceZones[0];
    double sum = 0;
    for (std::size_t i = 0; i < pieces.labels.size(); ++i) {
        const Vec3 own = faceGeometry(result.points, result.faces[pieces.labels[i]]).area;
        sum += (pieces.flip[i] ? -1 : 1) * (own.x + 2 * own.y + 3 * own.z);
    }
    EXPECT_NEAR(sum / area, 1, 1e-3); // some points inside have moved
}

} // namespace
} // namespace polymesh::test
