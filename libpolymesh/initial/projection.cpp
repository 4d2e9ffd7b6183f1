// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/projection.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace polymesh {
namespace {

// The limits of OpenFOAM's blockMesh, which decide when its iteration ends.
constexpr int mostPasses = 10;
constexpr double enoughReduction = 0.1;
constexpr double enoughShift = 5e-5;

/// Moves each point to the nearest one of the shape that is nearer than `reach`.
void moveOnto(const Shape& shape, double reach2, std::vector<Vec3>& points) {
    for (Vec3& p : points) {
        const Vec3 nearest = shape.nearest(p);
        if (squaredNorm(nearest - p) < reach2) p = nearest;
    }
}

/// A line of points inside a larger array.
struct Line {
    std::size_t first;
    std::size_t step;
    std::size_t count;

    std::size_t at(std::size_t i) const { return first + i * step; }
};

/// The share of the length up to each point of a line; empty when the line has no length.
std::vector<double> shares(const std::vector<Vec3>& points, const Line& line) {
    std::vector<double> result{0};
    for (std::size_t i = 1; i < line.count; ++i)
        result.push_back(result.back() + norm(points[line.at(i)] - points[line.at(i - 1)]));
    const double length = result.back();
    if (!(length > 0)) return {};
    for (double& share : result)
        share /= length;
    return result;
}

/// The point on the polygon through the points of a line at a share of its length.
Vec3 pointAt(const std::vector<Vec3>& points,
             const Line& line,
             const std::vector<double>& found,
             double share) {
    const auto after = std::lower_bound(found.begin() + 1, found.end() - 1, share);
    const auto i = static_cast<std::size_t>(after - found.begin());
    const double length = found[i] - found[i - 1];
    const double local = length > 0 ? (share - found[i - 1]) / length : 0;
    const Vec3& p = points[line.at(i - 1)];
    return p + local * (points[line.at(i)] - p);
}

/// What moves the inner points of a line to the wanted shares of its length, into `shift`.
/// Returns the sum of the lengths.
double shiftsAlong(const std::vector<Vec3>& points,
                   const Line& line,
                   const std::vector<double>& wanted,
                   std::vector<Vec3>& shift) {
    const std::vector<double> found = shares(points, line);
    if (found.empty() || wanted.empty()) return 0;
    double sum = 0;
    for (std::size_t i = 1; i + 1 < line.count; ++i) {
        const std::size_t p = line.at(i);
        shift[p] = pointAt(points, line, found, wanted[i]) - points[p];
        sum += norm(shift[p]);
    }
    return sum;
}

void addShifts(std::vector<Vec3>& points, const std::vector<Vec3>& shifts) {
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] += shifts[i];
}

/// The inner rows and columns of a grid of points, with the shares of length that they had.
struct FaceLines {
    std::vector<Line> lines;
    std::vector<std::vector<double>> wanted;

    void add(const std::vector<Vec3>& points, const Line& line) {
        lines.push_back(line);
        wanted.push_back(shares(points, line));
    }

    /// Shifts all points along their lines; returns by how much in all.
    double relax(std::vector<Vec3>& points) const {
        std::vector<Vec3> shift(points.size());
        double sum = 0;
        for (std::size_t i = 0; i < lines.size(); ++i)
            sum += shiftsAlong(points, lines[i], wanted[i], shift);
        addShifts(points, shift);
        return sum;
    }
};

} // namespace

Vec3 projectedVertex(const Vec3& vertex, const Shape& shape) {
    const Vec3 nearest = shape.nearest(vertex);
    const double size2 = squaredNorm(shape.bounds.max - shape.bounds.min);
    return squaredNorm(nearest - vertex) < size2 ? nearest : vertex;
}

Curve projectedCurve(Shape shape) {
    return [shape = std::move(shape)](
               const Vec3& start, const Vec3& end, std::span<const double> parameters) {
        const std::vector<double> wanted(parameters.begin(), parameters.end());
        std::vector<Vec3> points;
        points.reserve(wanted.size());
        for (const double t : wanted)
            points.push_back(start + t * (end - start));
        const Line line{0, 1, points.size()};
        std::vector<Vec3> shift(points.size());
        double first = 0;
        for (int pass = 0; pass < mostPasses; ++pass) {
            moveOnto(shape, squaredNorm(end - start), points);
            points.front() = start;
            points.back() = end;
            const double sum = shiftsAlong(points, line, wanted, shift);
            if (sum < enoughShift * static_cast<double>(points.size())) break;
            if (pass == 0) first = sum;
            if (pass > 0 && sum < enoughReduction * first) break;
            addShifts(points, shift);
        }
        return points;
    };
}

void projectFace(std::vector<Vec3>& points, std::array<std::size_t, 2> counts, const Shape& shape) {
    const auto [columns, rows] = counts;
    FaceLines alongRows;
    FaceLines alongColumns;
    for (std::size_t j = 1; j + 1 < rows; ++j)
        alongRows.add(points, {j * columns, 1, columns});
    for (std::size_t i = 1; i + 1 < columns; ++i)
        alongColumns.add(points, {i, columns, rows});
    double first = 0;
    double sum = 0;
    for (int pass = 0; pass < mostPasses; ++pass) {
        moveOnto(shape, squaredNorm(points.front() - points.back()), points);
        if (pass > 0 && (first < 1e-150 || sum < enoughReduction * first)) return;
        sum = alongRows.relax(points);
        sum += alongColumns.relax(points);
        if (pass == 0) first = sum;
    }
}

} // namespace polymesh
