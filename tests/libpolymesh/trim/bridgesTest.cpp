// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/bridges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <set>

namespace polymesh::test {
namespace {

/// Loops in a plane of space.
class Face {
public:
    /// A regular polygon; `turn` 1 runs as the face does, -1 against it.
    LoopPolygon ring(std::size_t n, double x, double y, double radius, int turn) {
        LoopPolygon loop;
        for (std::size_t i = 0; i < n; ++i) {
            const double angle = turn * (0.1 + 2 * std::numbers::pi * static_cast<double>(i) /
                                                   static_cast<double>(n));
            loop.push_back(toLabel(points.size()));
            points.push_back((x + radius * std::cos(angle)) * u +
                             (y + radius * std::sin(angle)) * v + offset);
        }
        return loop;
    }

    LoopPolygon polygon(std::initializer_list<std::array<double, 2>> corners) {
        LoopPolygon loop;
        for (const auto& [x, y] : corners) {
            loop.push_back(toLabel(points.size()));
            points.push_back(x * u + y * v + offset);
        }
        return loop;
    }

    /// Whether edges of a loop cross each other.
    bool crossesItself(const LoopPolygon& loop) const {
        const auto turn = [&](Label a, Label b, Label c) {
            return dot(
                cross(points[index(b)] - points[index(a)], points[index(c)] - points[index(a)]),
                normal);
        };
        const std::size_t n = loop.size();
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i + 1; j < n; ++j) {
                const Label a = loop[i];
                const Label b = loop[(i + 1) % n];
                const Label c = loop[j];
                const Label d = loop[(j + 1) % n];
                if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0)
                    return true;
            }
        return false;
    }

    double area(const LoopPolygon& loop) const {
        Vec3 sum;
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            sum += cross(points[index(loop[i])] - points[index(loop[0])],
                         points[index(loop[i + 1])] - points[index(loop[0])]);
        return 0.5 * dot(sum, normal);
    }

    Vec3 u{0.6, 0.8, 0};
    Vec3 v{0, 0, 1};
    Vec3 normal = cross(u, v);
    Vec3 offset{3, -2, 5};
    std::vector<Vec3> points;
};

using DirectedEdges = std::map<std::pair<Label, Label>, int>;

/// How often each edge is used, opposite uses taken off: bridges cancel.
DirectedEdges netEdges(const std::vector<LoopPolygon>& loops) {
    DirectedEdges uses;
    for (const LoopPolygon& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Label a = loop[i];
            const Label b = loop[(i + 1) % loop.size()];
            ++uses[{a, b}];
            --uses[{b, a}];
        }
    std::erase_if(uses, [](const auto& use) { return use.second == 0; });
    return uses;
}

bool hasRepeatedPoint(const LoopPolygon& loop) {
    return std::set<Label>(loop.begin(), loop.end()).size() != loop.size();
}

struct Opened {
    std::vector<LoopPolygon> polygons;
    std::vector<Label> needed;
    Label holes = 0;
};

/// Opens holes and checks what holds always: area, edges, no keyhole.
Opened open(const Face& face,
            std::vector<LoopPolygon> outlines,
            std::vector<LoopPolygon> closed,
            bool isPlain) {
    std::vector<LoopPolygon> all = outlines;
    all.insert(all.end(), closed.begin(), closed.end());
    double area = 0;
    for (const LoopPolygon& loop : all)
        area += face.area(loop);
    CurvesOnFace curves{std::move(outlines), std::move(closed), isPlain};
    Opened result;
    result.holes = openHoles(face.points, face.normal, curves, result.needed);
    result.polygons = std::move(curves.polygons);
    double opened = 0;
    for (const LoopPolygon& polygon : result.polygons) {
        opened += face.area(polygon);
        EXPECT_GT(face.area(polygon), 0);
        EXPECT_FALSE(hasRepeatedPoint(polygon));
        EXPECT_FALSE(face.crossesItself(polygon));
    }
    EXPECT_NEAR(opened, area, 1e-12);
    EXPECT_EQ(netEdges(result.polygons), netEdges(all));
    return result;
}

/// How many points of a loop must stay.
std::size_t neededOf(const Opened& opened, const LoopPolygon& loop) {
    return static_cast<std::size_t>(std::ranges::count_if(
        loop, [&](Label p) { return std::ranges::find(opened.needed, p) != opened.needed.end(); }));
}

TEST(OpenHoles, oneHoleMakesTwoPolygons) {
    Face face;
    const LoopPolygon outline = face.ring(6, 0, 0, 2, 1);
    const LoopPolygon hole = face.ring(5, 0.3, -0.2, 0.5, -1);
    const Opened result = open(face, {outline}, {hole}, true);
    EXPECT_EQ(result.holes, 1);
    EXPECT_EQ(result.polygons.size(), 2U);
    EXPECT_EQ(neededOf(result, outline), 2U);
    EXPECT_GE(neededOf(result, hole), 3U); // two bridges, and it stays open
}

TEST(OpenHoles, noBridgeCrossesTheHole) {
    Face face; // a dent of the outline is closest to the point of the hole behind its long edge
    const LoopPolygon outline = face.polygon({{-3, -3}, {3, -3}, {3, 3}, {0, 0.5}, {-3, 3}});
    const LoopPolygon hole = face.polygon({{-2, 0}, {2, 0}, {0, -0.5}});
    open(face, {outline}, {hole}, true);
}

TEST(OpenHoles, bridgesDoNotCrossEachOther) {
    Face face; // without the first bridge, (0 1) to (0 0), the best one is (1 1) to (-1 0)
    const LoopPolygon outline =
        face.polygon({{-6, -6}, {12, -6}, {12, 1}, {1, 1}, {0, 1}, {-6, 1}});
    const LoopPolygon hole = face.polygon({{-1, 0}, {0, 0}, {5, 0}, {5, -1}, {-1, -1}});
    open(face, {outline}, {hole}, true);
}

TEST(OpenHoles, severalHolesAreEachOpened) {
    Face face;
    const LoopPolygon outline = face.ring(4, 0, 0, 3, 1);
    std::vector<LoopPolygon> holes;
    for (const double x : {-0.9, 0.0, 0.9})
        for (const double y : {-0.45, 0.45})
            holes.push_back(face.ring(7, x, y, 0.3, -1));
    const Opened result = open(face, {outline}, holes, false);
    EXPECT_EQ(result.holes, 6);
    EXPECT_EQ(result.polygons.size(), 7U);
}

TEST(OpenHoles, islandsArePolygonsOfTheirOwn) {
    Face face;
    const LoopPolygon island = face.ring(5, 0, 0, 1, 1);
    const Opened alone = open(face, {}, {island}, false);
    EXPECT_EQ(alone.holes, 0);
    ASSERT_EQ(alone.polygons.size(), 1U);
    EXPECT_EQ(alone.polygons[0], island);
    EXPECT_EQ(neededOf(alone, island), 3U);
}

TEST(OpenHoles, aHoleGoesToTheSmallestPolygonRoundIt) {
    Face face;
    const LoopPolygon outline = face.ring(12, 0, 0, 4, 1);
    const LoopPolygon ditch = face.ring(12, 0, 0, 3, -1);
    const LoopPolygon island = face.ring(12, 0, 0, 2, 1);
    const LoopPolygon pond = face.ring(4, 0, 0, 0.5, -1);
    for (const auto& outlines : {std::vector{outline, island}, std::vector{island, outline}}) {
        const Opened result = open(face, outlines, {ditch, pond}, false);
        EXPECT_EQ(result.holes, 2);
        ASSERT_EQ(result.polygons.size(), 4U);
        for (const LoopPolygon& polygon : result.polygons) {
            const bool isOuter = std::ranges::find(polygon, outline[0]) != polygon.end() ||
                                 std::ranges::find(polygon, ditch[0]) != polygon.end();
            for (const Label p : pond)
                EXPECT_FALSE(isOuter && std::ranges::find(polygon, p) != polygon.end());
        }
    }
}

TEST(OpenHoles, aLoneLoopInAPlainOutlineIsAHoleHoweverSmall) {
    Face face;
    const LoopPolygon outline = face.ring(4, 0, 0, 1, 1);
    LoopPolygon dust = face.ring(3, 0.1, 0.1, 0, -1); // no area at all
    CurvesOnFace curves{{outline}, {dust}, true};
    std::vector<Label> needed;
    EXPECT_EQ(openHoles(face.points, face.normal, curves, needed), 1);
    EXPECT_EQ(curves.polygons.size(), 2U);
    EXPECT_EQ(netEdges(curves.polygons), netEdges({outline, dust}));
}

TEST(OpenHoles, facesSeenFromEitherSideAndAlongAnyAxis) {
    for (const Vec3& normal : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
        Face face;
        face.normal = normal;
        face.u = Vec3{normal.y, normal.z, normal.x};
        face.v = cross(normal, face.u);
        const LoopPolygon outline = face.ring(8, 0, 0, 2, 1);
        const LoopPolygon hole = face.ring(8, 0, 0, 1, -1);
        EXPECT_EQ(open(face, {outline}, {hole}, true).holes, 1);
    }
}

TEST(OpenHoles, withoutClosedLoopsNothingHappens) {
    Face face;
    const LoopPolygon outline = face.ring(4, 0, 0, 1, 1);
    const Opened result = open(face, {outline}, {}, true);
    EXPECT_EQ(result.polygons, std::vector<LoopPolygon>{outline});
}

} // namespace
} // namespace polymesh::test
