// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/curves.h"

#include "libpolymesh/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace polymesh {
namespace {

/// Points on the circle about `centre` from `start` by the angle [rad] round the unit `axis`.
std::vector<Vec3> circlePoints(const Vec3& centre,
                               const Vec3& axis,
                               const Vec3& start,
                               double angle,
                               std::span<const double> parameters) {
    const Vec3 radius = start - centre;
    const Vec3 across = cross(axis, radius);
    std::vector<Vec3> points;
    points.reserve(parameters.size());
    for (const double t : parameters)
        points.push_back(centre + std::cos(t * angle) * radius + std::sin(t * angle) * across);
    return points;
}

/// Rounding must not part edges from the vertices that they share.
void fixEnds(std::vector<Vec3>& points,
             const Vec3& start,
             const Vec3& end,
             std::span<const double> parameters) {
    if (parameters.front() <= 0) points.front() = start;
    if (parameters.back() >= 1) points.back() = end;
}

/// Four consecutive points of a spline: those round a segment.
using Span4 = std::array<Vec3, 4>;

Vec3 catmullRom(const Span4& p, double t) {
    const Vec3 linear = p[2] - p[0];
    const Vec3 square = 2 * p[0] - 5 * p[1] + 4 * p[2] - p[3];
    const Vec3 cubic = 3 * (p[1] - p[2]) + p[3] - p[0];
    return p[1] + 0.5 * t * (linear + t * (square + t * cubic));
}

Vec3 cubicBSpline(const Span4& p, double t) {
    const Vec3 constant = p[0] + 4 * p[1] + p[2];
    const Vec3 linear = 3 * (p[2] - p[0]);
    const Vec3 square = 3 * (p[0] - 2 * p[1] + p[2]);
    const Vec3 cubic = 3 * (p[1] - p[2]) + p[3] - p[0];
    return (constant + t * (linear + t * (square + t * cubic))) / 6;
}

Vec3 straight(const Span4& p, double t) {
    return p[1] + t * (p[2] - p[1]);
}

using Segment = Vec3 (*)(const Span4&, double);

/// The share of the length up to each point of a chain of straight lines.
std::vector<double> lengthShares(const std::vector<Vec3>& chain) {
    std::vector<double> shares{0};
    for (std::size_t i = 1; i < chain.size(); ++i)
        shares.push_back(shares.back() + norm(chain[i] - chain[i - 1]));
    const double length = shares.back();
    for (double& share : shares)
        share /= length > 0 ? length : 1;
    return shares;
}

Span4 roundSegment(const std::vector<Vec3>& chain, std::size_t s) {
    const Vec3& p = chain[s];
    const Vec3& q = chain[s + 1];
    return {
        s == 0 ? 2 * p - q : chain[s - 1], p, q, s + 2 == chain.size() ? 2 * q - p : chain[s + 2]};
}

Curve chainCurve(std::vector<Vec3> knots, Segment segment) {
    return [knots = std::move(knots),
            segment](const Vec3& start, const Vec3& end, std::span<const double> parameters) {
        std::vector<Vec3> chain{start};
        chain.insert(chain.end(), knots.begin(), knots.end());
        chain.push_back(end);
        const std::vector<double> shares = lengthShares(chain);
        std::vector<Vec3> points;
        points.reserve(parameters.size());
        for (const double t : parameters) {
            // the segment whose end is the first not before t
            const auto after = std::lower_bound(shares.begin() + 1, shares.end() - 1, t);
            const auto s = static_cast<std::size_t>(after - shares.begin()) - 1;
            const double length = shares[s + 1] - shares[s];
            const double local = length > 0 ? (t - shares[s]) / length : 0;
            points.push_back(segment(roundSegment(chain, s), local));
        }
        fixEnds(points, start, end, parameters);
        return points;
    };
}

} // namespace

Curve lineCurve() {
    return chainCurve({}, straight);
}

Curve arcThrough(const Vec3& middle, std::string where) {
    return [middle, where = std::move(where)](
               const Vec3& start, const Vec3& end, std::span<const double> parameters) {
        const Vec3 a = middle - start;
        const Vec3 b = end - start;
        const Vec3 n = cross(a, b);
        const double area2 = squaredNorm(n);
        require(area2 > 1e-24 * squaredNorm(a) * squaredNorm(b),
                "{}: the three points of this arc lie on a line; move the middle one or use line",
                where);
        const Vec3 toCentre =
            (squaredNorm(a) * cross(b, n) + squaredNorm(b) * cross(n, a)) / (2 * area2);
        const Vec3 centre = start + toCentre;
        // The shorter arc, unless the middle lies on the other side of the start. (A middle beyond
        // the end thus gives the shorter arc too, as in blockMesh.)
        const Vec3 from = start - centre;
        const Vec3 to = end - centre;
        const Vec3 overMiddle = cross(from, middle - centre);
        const Vec3 overEnd = cross(from, to);
        const bool isHalf = squaredNorm(overEnd) < 1e-6 * squaredNorm(from) * squaredNorm(to);
        const bool isLonger = dot(overMiddle, overEnd) < 0;
        const Vec3 along = isHalf ? overMiddle : isLonger ? -overEnd : overEnd;
        const Vec3 axis = along / norm(along);
        double angle = std::atan2(dot(axis, overEnd), dot(from, to));
        if (angle <= 0) angle += 2 * std::acos(-1.0);
        std::vector<Vec3> points = circlePoints(centre, axis, start, angle, parameters);
        fixEnds(points, start, end, parameters);
        return points;
    };
}

Curve arcAbout(const Vec3& centre, std::string where) {
    return [centre, where = std::move(where)](
               const Vec3& start, const Vec3& end, std::span<const double> parameters) {
        const Vec3 chord = end - start;
        const Vec3 middle = 0.5 * (start + end);
        require(squaredNorm(chord) > 0,
                "{}: the ends of this arc coincide; leave the edge out or move a vertex",
                where);
        // Moved into the plane of symmetry of the ends, within the plane of the three points.
        const Vec3 moved = centre - (dot(centre - middle, chord) / squaredNorm(chord)) * chord;
        const Vec3 from = start - moved;
        const Vec3 to = end - moved;
        const Vec3 n = cross(from, to);
        require(squaredNorm(n) > 1e-24 * squaredNorm(from) * squaredNorm(to),
                "{}: the origin of this arc lies on the line between its ends, so the arc has no "
                "plane; give a point on the arc instead",
                where);
        const double angle = std::atan2(norm(n), dot(from, to));
        std::vector<Vec3> points = circlePoints(moved, n / norm(n), start, angle, parameters);
        fixEnds(points, start, end, parameters);
        return points;
    };
}

Curve polyLineCurve(std::vector<Vec3> knots) {
    return chainCurve(std::move(knots), straight);
}

Curve splineCurve(std::vector<Vec3> knots) {
    return chainCurve(std::move(knots), catmullRom);
}

Curve bSplineCurve(std::vector<Vec3> knots) {
    return chainCurve(std::move(knots), cubicBSpline);
}

} // namespace polymesh
