// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surfaceRepair/uniteSurface.h"

#include "libpolymesh/surface/check.h"
#include "libpolymesh/surface/surfaceBuilder.h"
#include "libpolymesh/surfaceRepair/boundaryOfInside.h"
#include "libpolymesh/surfaceRepair/divideTriangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace polymesh {

namespace {

// More pairs than this are no flaw of a surface but noise.
constexpr Label mostPairs = 1'000'000;

// Bits of the largest coordinate that a round keeps; 0: those of double precision.
constexpr std::array<int, 12> bitsOfRound{0, 0, 44, 42, 40, 38, 36, 34, 31, 28, 25, 23};

double largestCoordinate(const TriSurface& surface) {
    double largest = 0;
    for (const Vec3& p : surface.points)
        for (int axis = 0; axis < 3; ++axis)
            largest = std::max(largest, std::abs(p[axis]));
    return largest;
}

/// Rounds points to multiples of `grid` [m], a power of two, or (0) to double precision.
class Rounding {
public:
    explicit Rounding(double grid) : grid_(grid) {}

    Vec3 operator()(const ExactPoint& exact) {
        const auto& value = CGAL::exact(exact);
        Vec3 p{CGAL::to_double(value.x()), CGAL::to_double(value.y()), CGAL::to_double(value.z())};
        const Vec3 unrounded = p;
        if (grid_ > 0)
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = grid_ * std::nearbyint(p[axis] / grid_);
        constexpr double epsilon = std::numeric_limits<double>::epsilon();
        const bool isExact = grid_ == 0 && exact == ExactPoint(p.x, p.y, p.z);
        if (!isExact)
            largestMove_ = std::max(largestMove_, norm(p - unrounded) + epsilon * norm(p));
        return p;
    }

    double largestMove() const { return largestMove_; }

private:
    double grid_;
    double largestMove_ = 0;
};

/// The points of triangles that intersect others.
std::vector<char> pointsToRound(const ExactSoup& soup,
                                Label triangleCount,
                                const std::vector<std::array<Label, 2>>& pairs) {
    std::vector<char> isDivided(index(triangleCount), 0);
    for (const auto& pair : pairs)
        for (Label t : pair)
            isDivided[index(t)] = 1;
    std::vector<char> isMarked(soup.points.size(), 0);
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
        for (Label corner : soup.triangles[t])
            if (isDivided[index(soup.source[t])] != 0) isMarked[index(corner)] = 1;
    return isMarked;
}

/// The chosen triangles of the soup with the regions of `original`. Triangles that collapse go, so
/// that what was closed stays closed.
TriSurface toSurface(const TriSurface& original,
                     const ExactSoup& soup,
                     const std::vector<Label>& triangles,
                     const std::vector<Vec3>& points) {
    SurfaceBuilder builder;
    for (const std::string& name : original.regionNames)
        builder.addRegion(name);
    for (Label t : triangles) {
        std::array<Label, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = builder.addPoint(points[index(soup.triangles[index(t)][i])]);
        builder.addPolygon(corners, original.region[index(soup.source[index(t)])]);
    }
    TriSurface surface = builder.finish("");
    // A region that is gone keeps its name, and the others their labels.
    const std::vector<std::string> kept = std::move(surface.regionNames);
    for (Label& region : surface.region)
        region = toLabel(
            static_cast<std::size_t>(std::ranges::find(original.regionNames, kept[index(region)]) -
                                     original.regionNames.begin()));
    surface.regionNames = original.regionNames;
    return surface;
}

/// Divides, chooses and rounds once.
TriSurface uniteOnce(const TriSurface& surface,
                     const std::vector<std::array<Label, 2>>& pairs,
                     Rounding& round) {
    const ExactSoup soup = divideTriangles(surface, pairs);
    const std::vector<Label> boundary = boundaryOfInside(surface, soup);
    const std::vector<char> isRounded = pointsToRound(soup, surface.triangleCount(), pairs);
    std::vector<Vec3> points(soup.points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
        points[p] = isRounded[p] != 0 ? round(soup.points[p]) : surface.points[p];
    return toSurface(surface, soup, boundary, points);
}

Label countDivided(const std::vector<std::array<Label, 2>>& pairs) {
    std::set<Label> divided;
    for (const auto& pair : pairs)
        divided.insert(pair.begin(), pair.end());
    return toLabel(divided.size());
}

/// Whether rounding makes more pairs than it takes away.
bool isHopeless(Label pairs, Label fewest) {
    constexpr Label few = 100; // these may come and go
    return pairs > mostPairs || pairs > 2 * fewest + few;
}

} // namespace

std::optional<UnitedSurface> uniteSurface(const TriSurface& surface) {
    const double scale = std::exp2(std::ceil(std::log2(largestCoordinate(surface))));
    auto pairs = findSelfIntersections(surface, mostPairs + 1);
    UnitedSurface last{surface, countDivided(pairs.first), pairs.count, 0, 0};
    UnitedSurface best = last;
    for (const int bits : bitsOfRound) {
        if (last.pairsLeft == 0 || isHopeless(last.pairsLeft, best.pairsLeft)) break;
        Rounding round(bits == 0 ? 0 : std::ldexp(scale, -bits));
        last.surface = uniteOnce(last.surface, pairs.first, round);
        if (last.surface.triangles.empty() || !checkSurface(last.surface).isClosed()) break;
        pairs = findSelfIntersections(last.surface, mostPairs + 1);
        last.pairsLeft = pairs.count;
        last.largestMove += round.largestMove();
        ++last.rounds;
        if (last.rounds == 1 || last.pairsLeft < best.pairsLeft) best = last;
    }
    const bool isDone = best.pairsLeft == 0 || best.rounds > 0;
    return isDone ? std::optional(std::move(best)) : std::nullopt;
}

} // namespace polymesh
