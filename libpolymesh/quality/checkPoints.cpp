// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/checkParts.h"

#include <cmath>
#include <iterator>

namespace polymesh {

namespace {

constexpr double great = 1e15; // OpenFOAM's GREAT

void makeUnique(std::vector<Label>& labels) {
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
}

void checkEdgeLengths(const CheckContext& context, double squaredLimit) {
    const PolyMesh& mesh = context.mesh;
    double least = great * great;
    double most = -great * great;
    std::vector<Label> ends;
    for (Label face = 0; face < mesh.faceCount(); ++face) {
        const std::span<const Label> points = mesh.faces[face];
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Label next = points[i + 1 == points.size() ? 0 : i + 1];
            const double squared =
                squaredNorm(mesh.points[index(points[i])] - mesh.points[index(next)]);
            if (squared < squaredLimit) ends.insert(ends.end(), {points[i], next});
            least = std::min(least, squared);
            most = std::max(most, squared);
        }
    }
    makeUnique(ends);
    context.report.figures.edgeLength = {std::sqrt(least), std::sqrt(most)};
    store(context, CheckId::shortEdges, std::move(ends));
}

/// Points in pairs closer than the limit. As in OpenFOAM only pairs count whose squared distances
/// from the origin differ by less than the squared limit, too.
std::vector<Label> nearPoints(std::span<const Vec3> points, double squaredLimit) {
    // Along a direction that no mesh is aligned with, few points lie within the limit of another.
    const Vec3 direction{0.43812345, 0.61598765, 0.65461357};
    std::vector<std::pair<double, Label>> sorted(points.size());
    parallelFor(toLabel(points.size()), [&](Label p) {
        sorted[index(p)] = {dot(direction, points[index(p)]), p};
    });
    std::sort(sorted.begin(), sorted.end());
    const double window = 1.01 * std::sqrt(squaredLimit);
    const auto isNear = [&](const Vec3& a, const Vec3& b) {
        const double atA = squaredNorm(a);
        const double atB = squaredNorm(b);
        return std::min(atA, atB) > std::max(atA, atB) - squaredLimit &&
               squaredNorm(a - b) < squaredLimit;
    };
    std::vector<Label> near;
    for (std::size_t i = 0; i < sorted.size(); ++i)
        for (std::size_t j = i + 1;
             j < sorted.size() && sorted[j].first - sorted[i].first <= window;
             ++j)
            if (isNear(points[index(sorted[i].second)], points[index(sorted[j].second)]))
                near.insert(near.end(), {sorted[i].second, sorted[j].second});
    makeUnique(near);
    return near;
}

} // namespace

void checkPointDistances(const CheckContext& context) {
    const Vec3 limit = limits::edgeLength * context.report.figures.bounds.size();
    const double squaredLimit = context.mesh.points.empty() ? 0 : squaredNorm(limit);
    checkEdgeLengths(context, squaredLimit);
    const std::vector<Label>& ends = context.report[CheckId::shortEdges].offenders;
    const std::vector<Label> near = nearPoints(context.mesh.points, squaredLimit);
    std::vector<Label> both; // OpenFOAM's set holds the ends of short edges too
    std::set_union(ends.begin(), ends.end(), near.begin(), near.end(), std::back_inserter(both));
    if (both.size() == ends.size()) both.clear();
    store(context, CheckId::nearPoints, std::move(both));
}

} // namespace polymesh
