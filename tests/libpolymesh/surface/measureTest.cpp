// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/measure.h"

#include "libpolymesh/base/threadLimit.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

namespace polymesh {

namespace {

TEST(Measure, givesVolumeAndAreasOfABoxFarFromTheOrigin) {
    TriSurface box = test::cuboid({1e6, -1e6, 1e6}, {1e6 + 1, -1e6 + 2, 1e6 + 3});
    box.regionNames.push_back("lid");
    box.region[10] = box.region[11] = 1;
    const SurfaceMeasure measured = measure(box);
    EXPECT_DOUBLE_EQ(measured.volume, 6);
    EXPECT_DOUBLE_EQ(measured.area, 22);
    ASSERT_EQ(measured.regionArea.size(), 2U);
    EXPECT_DOUBLE_EQ(measured.regionArea[0], 20);
    EXPECT_DOUBLE_EQ(measured.regionArea[1], 2);
}

TEST(Measure, isNegativeForASurfaceThatIsInsideOut) {
    EXPECT_DOUBLE_EQ(measure(test::inverted(test::cuboid())).volume, -1);
}

TEST(Measure, keepsItsDigitsOverManyTriangles) {
    // The prism's volume and area are known in closed form but for the corners' rounding.
    constexpr Label n = 20000;
    const double angle = 2 * std::numbers::pi / n;
    const SurfaceMeasure measured = measure(test::cylinder(n, 3));
    EXPECT_NEAR(measured.volume / (3 * 0.5 * n * std::sin(angle)), 1, 2e-15);
    EXPECT_NEAR(measured.area / (n * std::sin(angle) + 3 * n * 2 * std::sin(angle / 2)), 1, 2e-15);
}

TEST(Measure, doesNotDependOnTheNumberOfThreads) {
    const TriSurface surface = test::sphere(6, 0.7, {0.1, 0.2, 0.3});
    const SurfaceMeasure measured = measure(surface);
    const ThreadLimit limit(1);
    EXPECT_EQ(measure(surface).volume, measured.volume);
    EXPECT_EQ(measure(surface).area, measured.area);
}

TEST(Measure, takesAnEmptySurface) {
    EXPECT_EQ(measure(TriSurface{}).volume, 0);
}

} // namespace

} // namespace polymesh
