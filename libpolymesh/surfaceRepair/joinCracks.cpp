// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surfaceRepair/joinCracks.h"

#include "libpolymesh/surface/check.h"
#include "libpolymesh/surface/edgeUses.h"
#include "libpolymesh/surface/surfaceBuilder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace polymesh {

namespace {

constexpr int fewestDigits = 6; // of "%g", the coarsest that programs write

/// Decimal digits that it takes to write `x` so that it is read back the same.
int digitsOf(double x) {
    std::string digits = fmt::format("{}", std::abs(x)); // the shortest text that is x
    digits.resize(std::min(digits.find('e'), digits.size()));
    std::erase(digits, '.');
    const auto first = digits.find_first_not_of('0');
    if (first == std::string::npos) return 0;
    return static_cast<int>(digits.find_last_not_of('0') - first) + 1;
}

/// The ends of edges that an odd number of triangles use, ascending.
std::vector<Label> pointsOfOpenEdges(const TriSurface& surface) {
    std::vector<Label> points;
    const Rows<SurfaceEdgeUse> uses = collectEdgeUses(surface);
    for (Label lower = 0; lower < uses.size(); ++lower)
        forEachEdge(uses[lower], [&](std::span<const SurfaceEdgeUse> edge) {
            if (edge.size() % 2 == 0) return;
            points.push_back(lower);
            points.push_back(edge.front().upper);
        });
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

double precisionLimit(const TriSurface& surface) {
    double largest = 0;
    int digits = fewestDigits;
    for (const Vec3& p : surface.points)
        for (int axis = 0; axis < 3; ++axis) {
            largest = std::max(largest, std::abs(p[axis]));
            digits = std::max(digits, digitsOf(p[axis]));
        }
    const double decimalUnit = std::pow(10, std::floor(std::log10(largest)) + 1 - digits);
    const double singleUnit = std::exp2(std::floor(std::log2(largest)) - 23);
    return 2 * std::max(decimalUnit, singleUnit);
}

double largestDifference(const Vec3& a, const Vec3& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

/// For each point the one that it becomes: the lowest label among those of `points` that are
/// within the limit of each other. Points in order of x have these close by.
std::vector<Label>
nearestTwins(const TriSurface& surface, std::vector<Label> points, double limit) {
    std::vector<Label> twin(surface.points.size());
    std::iota(twin.begin(), twin.end(), Label{0});
    const auto at = [&](Label point) -> const Vec3& { return surface.points[index(point)]; };
    std::ranges::sort(points, {}, [&](Label point) { return std::pair(at(point).x, point); });
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            if (at(points[j]).x - at(points[i]).x > limit) break;
            if (largestDifference(at(points[i]), at(points[j])) > limit) continue;
            const auto [low, high] = std::minmax({points[i], points[j]});
            twin[index(high)] = std::min(twin[index(high)], low);
        }
    // Chains of near points would end out of reach: a twin has no other.
    for (Label& point : twin)
        if (twin[index(point)] != point) return {};
    return twin;
}

TriSurface withTwinsJoined(const TriSurface& surface, const std::vector<Label>& twin) {
    SurfaceBuilder builder;
    for (const std::string& name : surface.regionNames)
        builder.addRegion(name);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        std::array<Label, 3> corners = surface.triangles[t];
        for (Label& corner : corners)
            corner = builder.addPoint(surface.points[index(twin[index(corner)])]);
        builder.addPolygon(corners, surface.region[t]);
    }
    return builder.finish("");
}

} // namespace

std::optional<JoinedCracks> joinCracks(TriSurface& surface) {
    const std::vector<Label> points = pointsOfOpenEdges(surface);
    JoinedCracks joined;
    joined.openEdges = checkSurface(surface).openEdges.count;
    joined.limit = precisionLimit(surface);
    const std::vector<Label> twin = nearestTwins(surface, points, joined.limit);
    if (twin.empty()) return std::nullopt;
    for (Label point : points) {
        const Label other = twin[index(point)];
        if (other == point) continue;
        ++joined.points;
        const Vec3 move = surface.points[index(other)] - surface.points[index(point)];
        joined.largestMove = std::max(joined.largestMove, norm(move));
    }
    TriSurface closed = withTwinsJoined(surface, twin);
    if (closed.triangles.empty() || checkSurface(closed).openEdges.count > 0) return std::nullopt;
    surface = std::move(closed);
    return joined;
}

} // namespace polymesh
