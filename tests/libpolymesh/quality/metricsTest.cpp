// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace polymesh {
namespace {

const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<Label> loop{0, 1, 2, 3};
constexpr Directions all{true, true, true};

TEST(Orthogonality, isTheCosineOfTheAngle) {
    EXPECT_DOUBLE_EQ(orthogonality({0, 0, 0}, {0, 0, 2}, {0, 0, 5}), 1);
    EXPECT_NEAR(orthogonality({0, 0, 0}, {1, 0, 1}, {0, 0, 3}), std::numbers::sqrt2 / 2, 1e-15);
    EXPECT_LT(orthogonality({0, 0, 0}, {0, 0, -1}, {0, 0, 1}), 0);
}

TEST(Skewness, isZeroWhenTheLineMeetsTheCentre) {
    const FaceGeometry face = faceGeometry(square, loop);
    EXPECT_NEAR(internalSkewness(square, loop, face, {0.5, 0.5, -1}, {0.5, 0.5, 1}), 0, 1e-15);
    EXPECT_NEAR(boundarySkewness(square, loop, face, {0.5, 0.5, -1}), 0, 1e-15);
}

TEST(Skewness, isOneWhenTheLineMeetsAnEdge) {
    const FaceGeometry face = faceGeometry(square, loop);
    EXPECT_NEAR(internalSkewness(square, loop, face, {1, 0.5, -1}, {1, 0.5, 1}), 1, 1e-14);
    EXPECT_NEAR(boundarySkewness(square, loop, face, {1, 0.5, -1}), 1, 1e-14);
}

TEST(PyramidVolume, hasTheSignOfTheSide) {
    const FaceGeometry face = faceGeometry(square, loop);
    EXPECT_NEAR(pyramidVolume(face, {0.2, 0.7, -3}), 1, 1e-15);
    EXPECT_NEAR(pyramidVolume(face, {0.2, 0.7, 3}), -1, 1e-15);
}

TEST(TetQuality, isOneForTheRegularTetrahedron) {
    EXPECT_NEAR(tetQuality({1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}), 1, 1e-14);
    EXPECT_NEAR(tetQuality({1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}), -1, 1e-14);
}

TEST(TetQuality, isTinyForADegenerateTetrahedron) {
    EXPECT_NEAR(tetQuality({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}), 0, 1e-30);
    EXPECT_EQ(tetQuality({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}), 0);
}

TEST(FaceTets, arePositiveSeenFromBothSides) {
    const FaceGeometry face = faceGeometry(square, loop);
    const Vec3 below{0.5, 0.5, -1};
    const Vec3 above{0.5, 0.5, 1};
    EXPECT_GT(faceTetQuality(square, loop, face.centre, below, false), 0.1);
    EXPECT_GT(faceTetQuality(square, loop, face.centre, above, true), 0.1);
    EXPECT_LT(faceTetQuality(square, loop, face.centre, above, false), -0.1);
    EXPECT_TRUE(hasTetBasePoint(square, loop, below, &above, 1e-30));
    EXPECT_TRUE(hasTetBasePoint(square, loop, below, nullptr, 1e-30));
    EXPECT_FALSE(hasTetBasePoint(square, loop, above, nullptr, 1e-30));
}

TEST(FaceTets, needABasePointThatSeesTheWholeFace) {
    // A dart: only its reflex corner and the tip opposite see all of it.
    const std::vector<Vec3> dart{{4, 4, 0}, {0, 1, 0}, {-4, 4, 0}, {0, 0, 0}};
    const Vec3 below{0, 0.5, -1};
    EXPECT_TRUE(hasTetBasePoint(dart, loop, below, nullptr, 1e-30));
    // A zigzag polygon that no corner sees whole.
    const std::vector<Vec3> zigzag{
        {0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2, 0}, {4, 2, 0}, {4, 3, 0}, {0, 3, 0}};
    const std::vector<Label> corners{0, 1, 2, 3, 4, 5, 6, 7};
    EXPECT_FALSE(hasTetBasePoint(zigzag, corners, {0.5, 1.5, -1}, nullptr, 1e-30));
}

TEST(FaceConcavity, isTheSineOfAReflexTurn) {
    const std::vector<Vec3> points{
        {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
    const std::vector<Label> corners{0, 1, 2, 3, 4, 5};
    EXPECT_NEAR(faceConcavity(points, corners, {0, 0, 3}, 0.17), 1, 1e-15);
    EXPECT_EQ(faceConcavity(square, loop, {0, 0, 1}, 0.17), 0);
    EXPECT_EQ(faceConcavity(points, {}, {}, 0.17), 0);
}

TEST(FaceConcavity, ignoresSmallTurns) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0.1, 0}, {2, 0, 0}, {1, 2, 0}};
    EXPECT_EQ(faceConcavity(points, loop, {0, 0, 1}, 0.25), 0);
    EXPECT_GT(faceConcavity(points, loop, {0, 0, 1}, 0.15), 0.15);
}

TEST(FaceFlatness, isLowForAButterfly) {
    EXPECT_DOUBLE_EQ(faceFlatness(square, loop, faceGeometry(square, loop)), 1);
    const std::vector<Vec3> butterfly{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}};
    EXPECT_LT(faceFlatness(butterfly, loop, faceGeometry(butterfly, loop)), 0.5);
    std::vector<Vec3> warped = square;
    warped[2].z = 1;
    EXPECT_LT(faceFlatness(warped, loop, faceGeometry(warped, loop)), 0.95);
    const std::vector<Label> triangle{0, 1, 2};
    EXPECT_EQ(faceFlatness(warped, triangle, faceGeometry(warped, triangle)), 1);
}

TEST(FaceWeight, isTheSmallerShareOfTheDistance) {
    const FaceGeometry face = faceGeometry(square, loop);
    EXPECT_DOUBLE_EQ(faceWeight(face, {0, 0, -1}, {0, 0, 3}), 0.25);
    EXPECT_DOUBLE_EQ(faceWeight(face, {0, 0, -3}, {0, 0, 1}), 0.25);
}

TEST(VolumeRatio, isSmallerByLarger) {
    EXPECT_DOUBLE_EQ(volumeRatio(1, 4), 0.25);
    EXPECT_DOUBLE_EQ(volumeRatio(4, 1), 0.25);
}

const std::vector<Vec3> cubeAreas{
    {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};

TEST(CellClosedness, ofACubeIsPerfect) {
    const CellClosedness cube = cellClosedness(cubeAreas, 1, all);
    EXPECT_EQ(cube.openness, 0);
    EXPECT_DOUBLE_EQ(cube.aspectRatio, 1);
}

TEST(CellClosedness, seesAMissingFaceAndStretching) {
    const std::vector<Vec3> open(cubeAreas.begin(), cubeAreas.end() - 1);
    EXPECT_DOUBLE_EQ(cellClosedness(open, 1, all).openness, 1);
    std::vector<Vec3> thin = cubeAreas;
    for (std::size_t i = 0; i < 4; ++i)
        thin[i] = 0.1 * thin[i];
    EXPECT_DOUBLE_EQ(cellClosedness(thin, 0.1, all).aspectRatio, 10);
    EXPECT_DOUBLE_EQ(cellClosedness(thin, 0.1, {true, true, false}).aspectRatio, 1);
}

TEST(CellDeterminant, isOneForACubeAndZeroWithoutNeighbours) {
    EXPECT_DOUBLE_EQ(cellDeterminant(cubeAreas, all), 1);
    EXPECT_EQ(cellDeterminant({}, all), 0);
    const std::vector<Vec3> oneWay{{-1, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(cellDeterminant(oneWay, all), 0);
    EXPECT_EQ(cellDeterminant(oneWay, {true, false, false}), 1);
    const std::vector<Vec3> flat(cubeAreas.begin(), cubeAreas.end() - 2);
    EXPECT_DOUBLE_EQ(cellDeterminant(flat, {true, true, false}), 0.5);
}

TEST(IsConcaveCell, holdsForCoplanarFaces) {
    std::vector<FaceGeometry> cube{{{-1, 0, 0}, {-4, 0, 0}},
                                   {{1, 0, 0}, {4, 0, 0}},
                                   {{0, -1, 0}, {0, -4, 0}},
                                   {{0, 1, 0}, {0, 4, 0}},
                                   {{0, 0, -1}, {0, 0, -4}},
                                   {{0, 0, 1}, {0, 0, 4}}};
    EXPECT_FALSE(isConcaveCell(cube));
    cube.back() = {{0.5, 0, 1}, {0, 0, 2}};
    cube.push_back({{-0.5, 0, 1}, {0, 0, 2}});
    EXPECT_TRUE(isConcaveCell(cube));
    EXPECT_FALSE(isConcaveCell({}));
}

} // namespace
} // namespace polymesh
