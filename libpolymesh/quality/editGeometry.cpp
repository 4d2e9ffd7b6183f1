// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/editGeometry.h"

namespace polymesh {

FaceGeometry polygonGeometry(const std::vector<Vec3>& points, const Polygon& corners) {
    // Relative to the first corner: no cancellation of large coordinates.
    const Vec3 origin = points[index(corners[0])];
    if (corners.size() == 3) {
        const Vec3 u = points[index(corners[1])] - origin;
        const Vec3 v = points[index(corners[2])] - origin;
        return {0.5 * cross(u, v), origin + (u + v) / 3.0};
    }
    Vec3 mean;
    for (const Label p : corners)
        mean += points[index(p)] - origin;
    mean = mean / static_cast<double>(corners.size());
    Vec3 area;
    Vec3 weighted;
    double weight = 0;
    Vec3 u = points[index(corners.back())] - origin;
    for (const Label p : corners) {
        const Vec3 v = points[index(p)] - origin;
        const Vec3 part = 0.5 * cross(u - mean, v - mean);
        const double size = norm(part);
        area += part;
        weighted += (size / 3.0) * (u + v + mean);
        weight += size;
        u = v;
    }
    return {area, origin + (weight > 0 ? weighted / weight : mean)};
}

double distanceFromLine(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double length = norm(b - a);
    return length > 0 ? norm(cross(b - a, p - a)) / length : norm(p - a);
}

} // namespace polymesh
