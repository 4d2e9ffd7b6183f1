// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/curves.h"

#include "libpolymesh/base/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polymesh::test {
namespace {

const std::vector<double> quarters{0, 0.25, 0.5, 0.75, 1};

void expectNear(const Vec3& a, const Vec3& b) {
    EXPECT_NEAR(norm(a - b), 0, 1e-12) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Curves, everyKindBeginsAndEndsAtTheVertices) {
    const Vec3 start{1, 0, 0.1};
    const Vec3 end{0, 1, 0.3};
    const std::vector<Vec3> knots{{0.8, 0.7, 0.2}, {0.3, 1.2, 0.2}};
    for (const Curve& curve : {lineCurve(),
                               arcThrough({0.8, 0.8, 0.2}, "a:1"),
                               arcAbout({0.1, 0, 0}, "a:1"),
                               polyLineCurve(knots),
                               splineCurve(knots),
                               bSplineCurve(knots)}) {
        const std::vector<Vec3> points = curve(start, end, quarters);
        ASSERT_EQ(points.size(), quarters.size());
        EXPECT_EQ(points.front(), start);
        EXPECT_EQ(points.back(), end);
    }
}

TEST(Curves, arcGoesThroughItsPointInEqualAngles) {
    const std::vector<Vec3> points = arcThrough({0, 2, 1}, "a:1")({2, 0, 1}, {-2, 0, 1}, quarters);
    for (const Vec3& p : points)
        EXPECT_NEAR(norm(p - Vec3{0, 0, 1}), 2, 1e-12);
    expectNear(points[2], {0, 2, 1});
    expectNear(points[1], {std::sqrt(2.0), std::sqrt(2.0), 1});
}

TEST(Curves, arcMayBeLongerThanHalfACircle) {
    expectNear(arcThrough({-1, 0, 0}, "a:1")({0, 1, 0}, {1, 0, 0}, quarters)[2],
               {-std::sqrt(0.5), -std::sqrt(0.5), 0});
}

TEST(Curves, arcAboutACentreIsTheShorterOne) {
    expectNear(arcAbout({0, 0, 0}, "a:1")({1, 0, 0}, {0, 1, 0}, quarters)[2],
               {std::sqrt(0.5), std::sqrt(0.5), 0});
}

TEST(Curves, arcOfThreePointsOnALineIsRefusedWithItsPlace) {
    try {
        arcThrough({2, 0, 0}, "dict:7")({0, 0, 0}, {1, 0, 0}, quarters);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("dict:7: ")) << error.what();
    }
    EXPECT_THROW(arcAbout({0.5, 0, 0}, "a:1")({0, 0, 0}, {1, 0, 0}, quarters), InputError);
}

TEST(Curves, polyLineIsDividedByLength) {
    const std::vector<Vec3> points = polyLineCurve({{3, 0, 0}})({0, 0, 0}, {3, 1, 0}, quarters);
    expectNear(points[1], {1, 0, 0});
    expectNear(points[3], {3, 0, 0});
}

TEST(Curves, splineGoesThroughItsKnotsAndBSplineBesideThem) {
    const std::vector<Vec3> knots{{1, 1, 0}, {2, 0, 0}, {3, 1, 0}};
    const Vec3 end{4, 0, 0};
    expectNear(splineCurve(knots)({0, 0, 0}, end, quarters)[1], knots[0]);
    // a uniform cubic B-spline passes a control point at (before + 4 point + after) / 6
    expectNear(bSplineCurve(knots)({0, 0, 0}, end, quarters)[1], {1, 4.0 / 6, 0});
}

TEST(Curves, splinesOfPointsOnALineStayOnIt) {
    const std::vector<Vec3> knots{{1, 1, 1}, {2, 2, 2}};
    for (const Curve& curve : {splineCurve(knots), bSplineCurve(knots)})
        for (const Vec3& p : curve({0, 0, 0}, {3, 3, 3}, std::vector<double>{0, 0.1, 0.6, 1}))
            EXPECT_NEAR(norm(p - Vec3{p.x, p.x, p.x}), 0, 1e-14);
}

} // namespace
} // namespace polymesh::test
