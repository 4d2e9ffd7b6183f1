// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/refine.h"
#include "libpolymesh/refine/regionCriteria.h"
#include "libpolymesh/refine/surfaceCriteria.h"
#include "libpolymesh/refine/surfaceCurvature.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <random>

namespace polymesh {
namespace {

std::shared_ptr<const NearTriangles> near(TriSurface surface) {
    return std::make_shared<const NearTriangles>(
        std::make_shared<const TriSurface>(std::move(surface)));
}

RefineCell ball(const Vec3& centre, double radius, int level = 0) {
    return {centre, radius, 2 * radius / std::sqrt(3), level, 0};
}

/// Levels of the cells of a cube, as many as the finest cells would be, found by looking at all
/// cells again and again.
class SlowLevels {
public:
    SlowLevels(int cells, int most) : n_(cells << most), most_(most), levels_(size(n_), 0) {}

    /// `wants(centre, half diagonal, size, level)`, for a cube of edge length 1 from the origin.
    template<class Wants>
    void select(Wants&& wants) {
        for (int level = 0; level < most_; ++level)
            forCells([&](std::array<int, 3> at, int width, int own) {
                const double h = static_cast<double>(width) / n_;
                const auto middle = [&](int i) {
                    const int place = i / width;
                    return h * (place + 0.5);
                };
                const Vec3 centre{middle(at[0]), middle(at[1]), middle(at[2])};
                if (own == level && wants(centre, 0.5 * std::sqrt(3) * h, h, level))
                    set(at, width, level + 1);
            });
    }

    void balance() {
        bool again = true;
        while (again) {
            again = false;
            forCells([&](std::array<int, 3> at, int width, int own) {
                if (mostAround(at, width) <= own + 1) return;
                set(at, width, own + 1);
                again = true;
            });
        }
    }

    std::vector<Label> counts() {
        std::vector<Label> result(static_cast<std::size_t>(most_) + 1, 0);
        forCells(
            [&](std::array<int, 3>, int, int own) { ++result[static_cast<std::size_t>(own)]; });
        return result;
    }

private:
    static std::size_t size(int n) {
        return static_cast<std::size_t>(n) * static_cast<std::size_t>(n * n);
    }

    int& at(int i, int j, int k) { return levels_[index(i + n_ * (j + n_ * k))]; }

    template<class Visit>
    void forCells(Visit&& visit) {
        for (int k = 0; k < n_; ++k)
            for (int j = 0; j < n_; ++j)
                for (int i = 0; i < n_; ++i) {
                    const int own = at(i, j, k);
                    const int width = 1 << (most_ - own);
                    if (i % width == 0 && j % width == 0 && k % width == 0)
                        visit(std::array<int, 3>{i, j, k}, width, own);
                }
    }

    void set(const std::array<int, 3>& low, int width, int level) {
        for (int k = low[2]; k < low[2] + width; ++k)
            for (int j = low[1]; j < low[1] + width; ++j)
                for (int i = low[0]; i < low[0] + width; ++i)
                    at(i, j, k) = level;
    }

    int mostAround(const std::array<int, 3>& low, int width) {
        int most = 0;
        const auto from = [&](std::size_t a) { return std::max(0, low[a] - 1); };
        const auto to = [&](std::size_t a) { return std::min(n_ - 1, low[a] + width); };
        for (int k = from(2); k <= to(2); ++k)
            for (int j = from(1); j <= to(1); ++j)
                for (int i = from(0); i <= to(0); ++i)
                    most = std::max(most, at(i, j, k));
        return most;
    }

    int n_;
    int most_;
    std::vector<int> levels_; // of each finest cell
};

std::vector<Label> countsOf(const RefinedMesh& refined, int most) {
    std::vector<Label> counts(static_cast<std::size_t>(most) + 1, 0);
    for (const Label level : refined.cellLevel)
        ++counts[index(level)];
    return counts;
}

} // namespace

TEST(Curvature, isThatOfASphereAndACylinder) {
    const std::vector<double> ofSphere =
        largestCurvatures(test::sphere(4, 2), std::numbers::pi / 6);
    double sum = 0;
    for (const double c : ofSphere) {
        EXPECT_NEAR(c, 0.5, 0.13) << "triangles of other shapes bend more across one way";
        sum += c;
    }
    EXPECT_NEAR(sum / static_cast<double>(ofSphere.size()), 0.5, 0.03);
    const TriSurface cylinder = test::cylinder(48);
    const std::vector<double> curvatures = largestCurvatures(cylinder, std::numbers::pi / 6);
    double most = 0;
    for (const double c : curvatures)
        most = std::max(most, c);
    EXPECT_NEAR(most, 1, 0.02);
}

TEST(Curvature, flatSidesAndSharpEdgesHaveNone) {
    const auto curvatures = largestCurvatures(test::cuboid(), std::numbers::pi / 6);
    EXPECT_EQ(curvatures.size(), 12U);
    for (const double c : curvatures)
        EXPECT_EQ(c, 0);
}

TEST(Criteria, aSphereByCurvatureHasTheCellsThatALongerWayFinds) {
    constexpr int cells = 4;
    constexpr int most = 3;
    constexpr double radius = 0.31;
    const Vec3 centre{0.52, 0.47, 0.49};
    const TriSurface sphere = test::sphere(3, radius, centre);
    // Four cells a radius: those of level 2 are 0.0625 long and a quarter of it is 0.0775.
    const RefinedMesh refined =
        refine(hexCells({{{0, 0, 0}, {1, 1, 1}}, {cells, cells, cells}}),
               {{curvatureCriterion(near(sphere), {8, most, std::numbers::pi / 6})}, 1});
    SlowLevels slow(cells, most);
    slow.select([&](const Vec3& at, double reach, double size, int) {
        double least2 = Box::inf;
        for (Label t = 0; t < sphere.triangleCount(); ++t)
            least2 = std::min(
                least2,
                squaredNorm(
                    at - closestPoint(
                             {sphere.corner(t, 0), sphere.corner(t, 1), sphere.corner(t, 2)}, at)));
        return least2 <= reach * reach && size > radius / 8;
    });
    slow.balance();
    EXPECT_EQ(countsOf(refined, most), slow.counts());
    EXPECT_GT(slow.counts()[3], 1000);
}

TEST(Criteria, shellsWantTheLevelOfTheirDistance) {
    const Criterion shells = distanceCriterion(near(test::cuboid()), {{0, 3}, {0.5, 1}});
    EXPECT_TRUE(shells(ball({1.05, 0.5, 0.5}, 0.06, 2)));
    EXPECT_FALSE(shells(ball({1.05, 0.5, 0.5}, 0.06, 3)));
    EXPECT_FALSE(shells(ball({1.05, 0.5, 0.5}, 0.04, 2)));
    EXPECT_TRUE(shells(ball({1.55, 0.5, 0.5}, 0.06, 0)));
    EXPECT_FALSE(shells(ball({1.55, 0.5, 0.5}, 0.06, 1)));
    EXPECT_FALSE(shells(ball({1.55, 0.5, 0.5}, 0.04, 0)));
}

TEST(Criteria, featuresAreSharpEdgesAndEnds) {
    const Criterion sharp = featureCriterion(test::cuboid(), {std::numbers::pi / 6, {0.1, 2}});
    EXPECT_TRUE(sharp(ball({1.05, 1.05, 0.5}, 0.01, 1)));
    EXPECT_FALSE(sharp(ball({1.05, 1.05, 0.5}, 0.01, 2)));
    EXPECT_FALSE(sharp(ball({1, 0.5, 0.5}, 0.1, 0))) << "amid a side, on its diagonal";
    const Criterion blunt = featureCriterion(test::cuboid(), {0.6 * std::numbers::pi, {0.1, 2}});
    EXPECT_FALSE(blunt(ball({1.05, 1.05, 0.5}, 0.01, 1)));
    const Criterion open = featureCriterion(test::without(test::cuboid(), 0), {3, {0.1, 2}});
    EXPECT_TRUE(open(ball({0, 0, 0}, 0.01, 1)) || open(ball({1, 1, 1}, 0.01, 1)));
}

TEST(Criteria, gapsGetTheirNumberOfCells) {
    const TriSurface plates = test::join(test::cuboid({0.1, 0.1, 0.3}, {0.9, 0.9, 0.45}),
                                         test::cuboid({0.1, 0.1, 0.55}, {0.9, 0.9, 0.7}));
    const RefinedMesh refined = refine(hexCells({{{0, 0, 0}, {1, 1, 1}}, {8, 8, 8}}),
                                       {{gapCriterion(near(plates), {3, 4})}, 1});
    // 0.1 wide: cells of 1/32 are enough and those of 1/16 are not.
    const std::vector<Label> counts = countsOf(refined, 4);
    EXPECT_EQ(counts[3] + counts[4], 0);
    EXPECT_GE(counts[2], 25 * 25 * 4) << "all of the gap";
    const Criterion gap = gapCriterion(near(plates), {3, 4});
    EXPECT_TRUE(gap(ball({0.5, 0.5, 0.5}, 0.02 * std::sqrt(3), 1)))
        << "in the middle, touching none";
    EXPECT_FALSE(gap(ball({0.5, 0.5, 0.9}, 0.02, 1))) << "above both";
}

TEST(Criteria, regionsAreAskedInsideAndOutside) {
    std::mt19937 random(3);
    const auto number = [&] { return 3 * static_cast<double>(random()) / 4294967296.0 - 1; };
    const Box unit{{0, 0, 0}, {1, 1, 1}};
    const Region box = boxRegion(unit);
    const Region surface = surfaceRegion(near(test::cuboid()));
    const Region sphere = sphereRegion({0.5, 0.5, 0.5}, 1);
    const Region cylinder = cylinderRegion({0, 0, 0}, {0, 0, 1}, 0.7);
    for (int n = 0; n < 500; ++n) {
        const Vec3 p{number(), number(), number()};
        const bool in = unit.contains(p);
        EXPECT_EQ(box.touches(p, 0), in);
        EXPECT_EQ(box.touchesOutside(p, 0), !in);
        EXPECT_EQ(surface.touches(p, 1e-9), in);
        EXPECT_EQ(surface.touchesOutside(p, 1e-9), !in);
        EXPECT_EQ(surface.touches(p, 0.2), box.touches(p, 0.2));
        EXPECT_EQ(sphere.touches(p, 0.1), norm(p - Vec3{0.5, 0.5, 0.5}) <= 1.1);
        EXPECT_EQ(cylinder.touches(p, 0), p.z >= 0 && p.z <= 1 && std::hypot(p.x, p.y) <= 0.7);
    }
    EXPECT_FALSE(regionCriterion(box, RegionSide::inside, 2)(ball({0.5, 0.5, 0.5}, 0.1, 2)));
    EXPECT_TRUE(regionCriterion(box, RegionSide::inside, 2)(ball({0.5, 0.5, 0.5}, 0.1, 1)));
    EXPECT_FALSE(regionCriterion(box, RegionSide::outside, 2)(ball({0.5, 0.5, 0.5}, 0.1, 1)));
}

TEST(Criteria, aClosedSurfaceHoldsPointsInLineWithItsEdges) {
    const Region surface = surfaceRegion(near(test::cuboid()));
    EXPECT_TRUE(surface.touches({0.5, 0.5, 0.5}, 1e-9)) << "the ray meets a diagonal";
    EXPECT_FALSE(surface.touches({-0.5, 0.5, 0.5}, 1e-9));
    EXPECT_FALSE(surface.touches({-0.5, 0, 0}, 1e-9)) << "the ray runs along an edge";
}

} // namespace polymesh
