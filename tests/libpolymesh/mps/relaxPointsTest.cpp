// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/relaxPoints.h"

#include "libpolymesh/base/threadLimit.h"
#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/mps/makeDivisible.h"
#include "libpolymesh/mps/movingMesh.h"
#include "libpolymesh/mps/pointStar.h"
#include "libpolymesh/quality/checks.h"
#include "tests/libpolymesh/mps/divided.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <random>

namespace polymesh {

namespace {

struct Division {
    PolyMesh mesh;
    Label firstNew = 0;
    std::vector<char> isGood;
};

Division division(const PolyMesh& whole) {
    SubdivisionPlan plan = planSubdivision(whole);
    Division result{{}, whole.pointCount(), partsOfBoxes(whole, plan)};
    result.mesh = divide(whole, std::move(plan));
    return result;
}

PolyMesh box(Label n) {
    return cartesianMesh({{{0, 0, 0}, {1, 1, 1}}, {n, n, n}});
}

/// The new point next to a place.
Label newPointAt(const Division& d, const Vec3& place) {
    Label best = d.firstNew;
    for (Label p = d.firstNew; p < d.mesh.pointCount(); ++p)
        if (norm(d.mesh.points[index(p)] - place) < norm(d.mesh.points[index(best)] - place))
            best = p;
    return best;
}

Label failures(const PolyMesh& mesh) {
    const MeshReport report = checkMesh(mesh, {});
    return toLabel(report[CheckId::aspectRatio].offenders.size() +
                   report[CheckId::skewness].offenders.size() +
                   report[CheckId::facePyramids].offenders.size());
}

/// Two tetrahedra on both sides of a triangle that lean over, so that its parts are seen from the
/// middles at a slant.
Division leaning(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> over(2, 9);
    std::uniform_real_distribution<double> height(.15, .3);
    return division(test::meshOf({{0, 0, 0},
                                  {1, 0, 0},
                                  {0, 1, 0},
                                  {over(random), over(random), height(random)},
                                  {over(random), over(random), -height(random)}},
                                 {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                                  {{0, 1, 2}, {0, 4, 1}, {1, 4, 2}, {2, 4, 0}}}));
}

} // namespace

TEST(RelaxPoints, goodMeshStaysBitForBit) {
    Division d = division(box(4));
    EXPECT_EQ(std::ranges::count(d.isGood, 1), 8 * 64);
    const PolyMesh before = d.mesh;
    for (const bool isKnown : {true, false}) {
        const RelaxCounts counts =
            relaxPoints(d.mesh, d.firstNew, isKnown ? d.isGood : std::vector<char>{});
        EXPECT_EQ(counts.offenders, 0);
        EXPECT_EQ(counts.moved, 0);
        EXPECT_EQ(d.mesh, before);
    }
}

TEST(RelaxPoints, cellsThatAreNoBoxesOrHaveAMovedPointAreLookedAt) {
    PolyMesh sheared = box(2);
    for (Vec3& p : sheared.points)
        p.x += 0.1 * p.y;
    EXPECT_EQ(std::ranges::count(division(sheared).isGood, 1), 0);
    const PolyMesh whole = box(2);
    SubdivisionPlan plan = planSubdivision(whole);
    plan.points[index(plan.layout.firstFace)].x += 1e-3; // of an internal face
    EXPECT_EQ(std::ranges::count(partsOfBoxes(whole, plan), 0), 16);
    const PolyMesh thin = cartesianMesh({{{0, 0, 0}, {1, 1, .05}}, {1, 1, 1}});
    EXPECT_EQ(std::ranges::count(division(thin).isGood, 1), 0);
}

TEST(RelaxPoints, skewFacesOfALeaningTetrahedronAreMended) {
    PolyMesh mesh = test::tetrahedron();
    mesh.points[3] = {6, 6, .25};
    Division d = division(mesh);
    ASSERT_EQ(failures(d.mesh), 3);
    const double volume = boundedVolume(d.mesh);
    const RelaxCounts counts = relaxPoints(d.mesh, d.firstNew, d.isGood);
    EXPECT_EQ(counts.offenders, 3);
    EXPECT_EQ(counts.left, 0);
    EXPECT_GT(counts.moved, 0);
    EXPECT_EQ(failures(d.mesh), 0);
    EXPECT_NEAR(boundedVolume(d.mesh), volume, 1e-15);
}

TEST(RelaxPoints, pointsOfTheUndividedMeshAndOfSharpEdgesStay) {
    Label moved = 0;
    for (unsigned seed = 0; seed < 10; ++seed) {
        Division d = leaning(seed);
        const PolyMesh before = d.mesh;
        const Rows<Label> faces = pointFaces(before);
        moved += relaxPoints(d.mesh, d.firstNew).moved;
        for (Label p = 0; p < d.mesh.pointCount(); ++p) {
            if (p < d.firstNew) {
                EXPECT_EQ(d.mesh.points[index(p)], before.points[index(p)]);
                continue;
            }
            for (const Label face : faces[p]) {
                if (before.isInternal(face)) continue;
                const FaceGeometry own = faceGeometry(before.points, before.faces[face]);
                const Vec3 by = d.mesh.points[index(p)] - before.points[index(p)];
                EXPECT_LE(std::abs(dot(own.area, by)), 0.35 * norm(own.area) * norm(by));
            }
        }
    }
    EXPECT_GT(moved, 10);
}

TEST(RelaxPoints, leaningPairsGetBetterAndKeepVolumeAndConvexity) {
    Label before = 0;
    Label after = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        Division d = leaning(seed);
        const Label bad = failures(d.mesh);
        const double volume = boundedVolume(d.mesh);
        const RelaxCounts counts = relaxPoints(d.mesh, d.firstNew);
        EXPECT_EQ(counts.offenders, bad) << seed;
        EXPECT_EQ(counts.left, failures(d.mesh)) << seed;
        EXPECT_LE(counts.left, bad) << seed;
        EXPECT_GT(test::leastJacobianOfFaces(d.mesh), 1e-6) << seed;
        EXPECT_NEAR(boundedVolume(d.mesh), volume, 1e-13 * volume) << seed;
        before += bad;
        after += counts.left;
    }
    EXPECT_GT(before, 50);
    EXPECT_LT(after, before / 2);
}

TEST(RelaxPoints, sameBytesForAnyNumberOfThreads) {
    Division d = leaning(3);
    PolyMesh alone = d.mesh;
    {
        const ThreadLimit one(1);
        relaxPoints(alone, d.firstNew);
    }
    for (const std::size_t threads : {2U, 8U}) {
        const ThreadLimit limit(threads);
        PolyMesh mesh = d.mesh;
        relaxPoints(mesh, d.firstNew);
        EXPECT_EQ(mesh, alone);
    }
}

TEST(MovingMesh, measuresAreOpenFoamsByTheirLimits) {
    Division d = leaning(1);
    const Rows<Label> faces = cellFaces(d.mesh);
    MovingMesh moving(d.mesh, faces);
    moving.measure(std::vector<char>(index(d.mesh.cellCount), 1));
    double stretch = 0;
    for (Label cell = 0; cell < d.mesh.cellCount; ++cell)
        stretch = std::max(stretch, moving.stretch(cell));
    double skewness = 0;
    for (Label face = 0; face < d.mesh.faceCount(); ++face) {
        skewness = std::max(skewness, moving.skewness(face));
        const double large = moving.largeSkewness(face);
        EXPECT_TRUE(large == moving.skewness(face) || (large == 0 && moving.skewness(face) <= .5));
    }
    const MeshFigures figures = checkMesh(d.mesh, {}).figures;
    EXPECT_NEAR(stretch, figures.maxAspectRatio / limits::aspectRatio, 1e-12 * stretch);
    EXPECT_NEAR(skewness, figures.maxSkewness / limits::skewness, 1e-12 * skewness);
}

TEST(PointStar, boundaryPointGoesAlongAWarpedFaceAndKeepsTheVolume) {
    PolyMesh whole = box(1);
    whole.points[0].z -= 0.1; // warps three faces
    Division d = division(whole);
    const Rows<Label> cells = cellFaces(d.mesh);
    const Rows<Label> points = pointFaces(d.mesh);
    const double volume = boundedVolume(d.mesh);
    const Label point = newPointAt(d, {.5, .5, -.025});
    MovingMesh moving(d.mesh, cells);
    PointStar star(moving, point, points[point]);
    ASSERT_TRUE(star.isFree());
    ASSERT_EQ(star.axes().size(), 2U);
    const Vec3 before = star.place();
    star.move(before + Vec3{.1, .05, .2});
    EXPECT_GT(norm(star.place() - before), .1);
    EXPECT_LT(std::abs(star.place().z - before.z), .02);
    EXPECT_NEAR(boundedVolume(d.mesh), volume, 1e-15);
    star.restore();
    EXPECT_EQ(star.place(), before);
    const Label edge = newPointAt(d, {.5, 1, 1});
    EXPECT_FALSE(PointStar(moving, edge, points[edge]).isFree());
}

} // namespace polymesh
