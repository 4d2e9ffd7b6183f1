// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/projection.h"

#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace polymesh::test {
namespace {

TEST(Shapes, nearestPointIsOnTheShapeAndNearestAmongSamples) {
    const Box box{{-1, -2, -1}, {2, 1, 1}};
    const std::vector<Shape> shapes{sphereShape({0.5, 0, 0}, 1.5),
                                    cylinderShape({0, 0, -1}, {0.5, 0.5, 2}, 0.7),
                                    boxShape(box),
                                    plateShape({0, -1, -1}, {0, 2, 2}),
                                    surfaceShape(cuboid(box.min, box.max))};
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-3, 3);
    for (const Shape& shape : shapes) {
        std::vector<Vec3> samples(2000);
        for (Vec3& sample : samples)
            sample = shape.nearest({place(random), place(random), place(random)});
        for (int i = 0; i < 50; ++i) {
            const Vec3 p{place(random), place(random), place(random)};
            const Vec3 nearest = shape.nearest(p);
            EXPECT_NEAR(norm(shape.nearest(nearest) - nearest), 0, 1e-12);
            for (const Vec3& sample : samples)
                EXPECT_LE(norm(nearest - p), norm(sample - p) + 1e-12);
        }
    }
}

TEST(Projection, ofAVertexFarAwayLeavesIt) {
    const Shape sphere = sphereShape({0, 0, 0}, 1);
    EXPECT_NEAR(norm(projectedVertex({2, 0, 0}, sphere) - Vec3{1, 0, 0}), 0, 1e-15);
    EXPECT_EQ(projectedVertex({9, 0, 0}, sphere), (Vec3{9, 0, 0}));
}

TEST(Projection, ofAnEdgeKeepsTheSpacing) {
    const Vec3 start{std::sqrt(0.5), -std::sqrt(0.5), 0};
    const Vec3 end{std::sqrt(0.5), std::sqrt(0.5), 0};
    std::vector<double> parameters;
    for (int i = 0; i <= 20; ++i)
        parameters.push_back(i / 20.0);
    const std::vector<Vec3> points =
        projectedCurve(sphereShape({0, 0, 0}, 1))(start, end, parameters);
    EXPECT_EQ(points.front(), start);
    EXPECT_EQ(points.back(), end);
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_NEAR(norm(points[i]), 1, 1e-9);
        EXPECT_NEAR(norm(points[i] - points[i - 1]), 0.0785, 0.002);
    }
}

} // namespace
} // namespace polymesh::test
