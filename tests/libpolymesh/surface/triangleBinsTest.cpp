// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/triangleBins.h"

#include "libpolymesh/surface/triangleBoxes.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace polymesh::test {
namespace {

/// Whether the triangle meets the closed box, by cutting it with the box's six planes.
bool doesMeet(const TriSurface& surface, Label t, const Box& box) {
    std::vector<Vec3> polygon{surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)};
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            const double limit = sign * (sign < 0 ? box.min : box.max)[axis];
            std::vector<Vec3> rest;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Vec3& a = polygon[i];
                const Vec3& b = polygon[(i + 1) % polygon.size()];
                const double da = sign * a[axis] - limit;
                const double db = sign * b[axis] - limit;
                if (da <= 0) rest.push_back(a);
                if ((da < 0 && db > 0) || (da > 0 && db < 0))
                    rest.push_back(a + da / (da - db) * (b - a));
            }
            polygon = rest;
        }
    return !polygon.empty();
}

class Boxes {
public:
    Box next() {
        Box box;
        const Vec3 corner = point();
        box.add(corner);
        box.add(corner + 0.2 * (point() + Vec3{1.5, 1.5, 1.5}));
        return box;
    }

private:
    Vec3 point() { return {unit_(random_), unit_(random_), unit_(random_)}; }

    std::mt19937 random_{1};
    std::uniform_real_distribution<double> unit_{-1.5, 1.5};
};

TriangleBins::Range rangeOf(const TriangleBins& bins, const Box& box) {
    TriangleBins::Range range;
    range.add(bins.binOf(box.min));
    range.add(bins.binOf(box.max));
    return range;
}

void expectFindsAllTriangles(const TriSurface& surface, double binSize) {
    const TriangleBins bins(surface, binSize);
    Boxes boxes;
    for (int i = 0; i < 200; ++i) {
        const Box box = boxes.next();
        const TriangleBins::Range range = rangeOf(bins, box);
        std::vector<Label> found{-7};
        bins.collect(range, found);
        ASSERT_EQ(found.front(), -7); // appends
        ASSERT_TRUE(std::ranges::is_sorted(found));
        ASSERT_TRUE(std::ranges::adjacent_find(found) == found.end());
        ASSERT_EQ(bins.isOccupied(range), found.size() > 1);
        for (Label t = 0; t < surface.triangleCount(); ++t)
            if (doesMeet(surface, t, box)) {
                ASSERT_TRUE(std::ranges::binary_search(found, t)) << "triangle " << t;
            }
    }
}

TEST(TriangleBins, findEveryTriangleThatMeetsABox) {
    for (const double binSize : {0.03, 0.1, 0.4, 100.0})
        expectFindsAllTriangles(sphere(3), binSize);
    expectFindsAllTriangles(cylinder(5, 1), 0.07);
    expectFindsAllTriangles(cuboid({-1, -1, -1}, {1, 1, 1}), 0.25); // sides on bin borders
}

TEST(TriangleBins, findFewTrianglesThatAreFarAway) {
    const TriSurface surface = sphere(4);
    const double binSize = 0.05;
    const TriangleBins bins(surface, binSize);
    Boxes boxes;
    for (int i = 0; i < 200; ++i) {
        Box box = boxes.next();
        std::vector<Label> found;
        bins.collect(rangeOf(bins, box), found);
        const Vec3 near{2 * binSize, 2 * binSize, 2 * binSize};
        box.min -= near;
        box.max += near;
        for (const Label t : found)
            ASSERT_TRUE(overlaps(triangleBox(surface, t), box));
    }
}

TEST(TriangleBins, placesOutsideTheSurfacesBoxAreEmpty) {
    const TriangleBins bins(cuboid(), 0.3);
    for (const Vec3& p : {Vec3{2, .5, .5}, Vec3{.5, -9, .5}, Vec3{.5, .5, 1e300}}) {
        TriangleBins::Range range;
        range.add(bins.binOf(p));
        EXPECT_FALSE(bins.isOccupied(range));
    }
    TriangleBins::Range all;
    all.add(bins.binOf({-5, -5, -5}));
    all.add(bins.binOf({5, 5, 5}));
    std::vector<Label> found;
    bins.collect(all, found);
    EXPECT_EQ(found.size(), 12U);
}

TEST(TriangleBins, numbersOfBinsGrowWithTheCoordinate) {
    const TriangleBins bins(sphere(1), 0.013);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-1.2, 1.2);
    for (int i = 0; i < 1000; ++i) {
        const double low = unit(random);
        const double high = unit(random);
        const auto a = bins.binOf({low, high, low});
        const auto b = bins.binOf({high, low, high});
        EXPECT_EQ(a[0] <= b[0], low <= high || a[0] == b[0]);
        EXPECT_EQ(a[1] <= b[1], high <= low || a[1] == b[1]);
    }
}

TEST(TriangleBins, flatAndHugeSurfacesNeedNoMoreMemoryThanOthers) {
    const TriSurface sheet = surfaceOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
    expectFindsAllTriangles(sheet, 0.01);
    const TriangleBins tiny(sphere(1, 1e6), 1e-3); // 1e27 bins of the size wished for
    TriangleBins::Range all;
    all.add(tiny.binOf({-2e6, -2e6, -2e6}));
    all.add(tiny.binOf({2e6, 2e6, 2e6}));
    EXPECT_TRUE(tiny.isOccupied(all));
}

} // namespace
} // namespace polymesh::test
