// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/geometry/solidAngle.h"

#include <gtest/gtest.h>

#include <numbers>

namespace polymesh {
namespace {

constexpr double pi = std::numbers::pi;
const Vec3 ex{1, 0, 0};
const Vec3 ey{0, 1, 0};
const Vec3 ez{0, 0, 1};

TEST(SolidAngle, anOctantIsHalfPi) {
    EXPECT_NEAR(solidAngle({}, ex, ey, ez), pi / 2, 1e-15);
    EXPECT_NEAR(solidAngle({}, ex, ez, ey), -pi / 2, 1e-15) << "turned round";
    const Vec3 p{3, -2, 5};
    EXPECT_NEAR(solidAngle(p, p + 0.1 * ex, p + 7 * ey, p + 2 * ez), pi / 2, 1e-14);
}

TEST(SolidAngle, ofATriangleCloseByIsHalfOfAllDirections) {
    EXPECT_NEAR(solidAngle({0.3, 0.3, -1e-9}, {}, ex, ey), 2 * pi, 1e-7);
    EXPECT_NEAR(solidAngle({0.3, 0.3, 1e-9}, {}, ex, ey), -2 * pi, 1e-7);
    EXPECT_EQ(solidAngle({2, 2, 0}, {}, ex, ey), 0) << "seen from its plane";
}

TEST(SolidAngle, addsUpToAllDirectionsInsideATetrahedron) {
    const auto sum = [](const Vec3& p) {
        return solidAngle(p, ex, ey, ez) + solidAngle(p, {}, ey, ex) + solidAngle(p, {}, ez, ey) +
               solidAngle(p, {}, ex, ez);
    };
    EXPECT_NEAR(sum({0.1, 0.2, 0.3}), 4 * pi, 1e-13);
    EXPECT_NEAR(sum({0.5, 0.5, 0.5}), 0, 1e-13);
}

} // namespace
} // namespace polymesh
