// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/metrics.h"

#include <algorithm>
#include <cmath>

namespace polymesh {

namespace {

constexpr double small = 1e-15;       // OpenFOAM's SMALL
constexpr double great = 1e15;        // GREAT
constexpr double rootTiny = 1e-150;   // ROOTVSMALL
constexpr double tiny = 1e-300;       // VSMALL
constexpr double vast = 1e300;        // VGREAT
constexpr double planarCosine = 1e-6; // planarCosAngle_

const Vec3& at(std::span<const Vec3> points, Label label) {
    return points[index(label)];
}

std::size_t after(std::span<const Label> face, std::size_t i) {
    return i + 1 == face.size() ? 0 : i + 1;
}

double sumOf(const Vec3& v) {
    return v.x + v.y + v.z;
}

/// The skewness with its line `d`; `share` of the line's length is the least extent.
double skewness(std::span<const Vec3> points,
                std::span<const Label> face,
                const FaceGeometry& geometry,
                const Vec3& toFace,
                const std::pair<Vec3, double>& lineAndShare) {
    const auto& [d, share] = lineAndShare;
    const Vec3 skew =
        toFace - (dot(geometry.area, toFace) / (dot(geometry.area, d) + rootTiny)) * d;
    const Vec3 direction = skew / (norm(skew) + rootTiny);
    double extent = share * norm(d) + rootTiny;
    for (const Label point : face)
        extent = std::max(extent, std::abs(dot(direction, at(points, point) - geometry.centre)));
    return norm(skew) / extent;
}

double circumRadius(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double lambda = squaredNorm(c) - dot(a, c);
    const double mu = squaredNorm(b) - dot(a, b);
    const Vec3 ba = cross(b, a);
    const Vec3 ca = cross(c, a);
    const Vec3 numerator = lambda * ba - mu * ca;
    const double denominator = dot(c, ba);
    if (std::abs(denominator) < rootTiny) return great;
    return norm(0.5 * (a + numerator / denominator));
}

/// Symmetric 3 x 3 matrix.
struct SymmetricTensor {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

    void addSquare(const Vec3& v) {
        xx += v.x * v.x;
        xy += v.x * v.y;
        xz += v.x * v.z;
        yy += v.y * v.y;
        yz += v.y * v.z;
        zz += v.z * v.z;
    }

    double determinant() const {
        return xx * yy * zz + xy * yz * xz + xz * xy * yz - xx * yz * yz - xy * xy * zz -
               xz * yy * xz;
    }
};

} // namespace

double orthogonality(const Vec3& ownerCentre, const Vec3& neighbourCentre, const Vec3& area) {
    const Vec3 d = neighbourCentre - ownerCentre;
    return dot(d, area) / (norm(d) * norm(area) + rootTiny);
}

double internalSkewness(std::span<const Vec3> points,
                        std::span<const Label> face,
                        const FaceGeometry& geometry,
                        const Vec3& ownerCentre,
                        const Vec3& neighbourCentre) {
    return skewness(points,
                    face,
                    geometry,
                    geometry.centre - ownerCentre,
                    {neighbourCentre - ownerCentre, 0.2});
}

double boundarySkewness(std::span<const Vec3> points,
                        std::span<const Label> face,
                        const FaceGeometry& geometry,
                        const Vec3& ownerCentre) {
    const Vec3 toFace = geometry.centre - ownerCentre;
    const Vec3 normal = geometry.area / (norm(geometry.area) + rootTiny);
    return skewness(points, face, geometry, toFace, {dot(normal, toFace) * normal, 0.4});
}

double pyramidVolume(const FaceGeometry& geometry, const Vec3& apex) {
    return (1.0 / 3.0) * dot(geometry.area, geometry.centre - apex);
}

double tetQuality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 ad = d - a;
    const double volume = (1.0 / 6.0) * dot(cross(ab, ac), ad);
    const double radius = std::min(circumRadius(ab, ac, ad), great);
    return volume / (8.0 / (9.0 * std::sqrt(3.0)) * (radius * radius * radius) + rootTiny);
}

double faceTetQuality(std::span<const Vec3> points,
                      std::span<const Label> face,
                      const Vec3& faceCentre,
                      const Vec3& apex,
                      bool isNeighbour) {
    double lowest = 1;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const double quality =
            tetQuality(at(points, face[i]), at(points, face[after(face, i)]), faceCentre, apex);
        lowest = std::min(lowest, isNeighbour ? quality : -quality);
    }
    return lowest;
}

bool hasTetBasePoint(std::span<const Vec3> points,
                     std::span<const Label> face,
                     const Vec3& ownerCentre,
                     const Vec3* neighbourCentre,
                     double limit) {
    for (std::size_t base = 0; base < face.size(); ++base) {
        const Vec3& corner = at(points, face[base]);
        double lowest = vast;
        for (std::size_t i = 1; i + 1 < face.size() && lowest > limit; ++i) {
            const std::size_t here = (base + i) % face.size();
            const Vec3& a = at(points, face[here]);
            const Vec3& b = at(points, face[after(face, here)]);
            lowest = std::min(lowest, tetQuality(ownerCentre, corner, a, b));
            if (neighbourCentre != nullptr)
                lowest = std::min(lowest, tetQuality(*neighbourCentre, corner, b, a));
        }
        if (lowest > limit) return true;
    }
    return false;
}

double faceConcavity(std::span<const Vec3> points,
                     std::span<const Label> face,
                     const Vec3& area,
                     double ignoredSine) {
    if (face.empty()) return 0;
    const Vec3 faceNormal = area / (norm(area) + rootTiny);
    const auto edge = [&](std::size_t from, std::size_t to) {
        return at(points, face[to]) - at(points, face[from]);
    };
    Vec3 previous = edge(face.size() - 1, 0);
    double previousLength = norm(previous);
    previous = previous / (previousLength + rootTiny);
    double largest = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
        Vec3 next = edge(i, after(face, i));
        const double length = norm(next);
        next = next / (length + rootTiny);
        if (previousLength > small && length > small) {
            const Vec3 turn = cross(previous, next);
            const double sine = norm(turn);
            if (!(sine < ignoredSine) && dot(turn / sine, faceNormal) < small)
                largest = std::max(largest, sine);
        }
        previous = next;
        previousLength = length;
    }
    return largest;
}

double faceFlatness(std::span<const Vec3> points,
                    std::span<const Label> face,
                    const FaceGeometry& geometry) {
    const double area = norm(geometry.area);
    if (face.size() <= 3 || !(area > rootTiny)) return 1;
    double sum = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3& here = at(points, face[i]);
        const Vec3& next = at(points, face[after(face, i)]);
        sum += norm(0.5 * cross(next - here, geometry.centre - here));
    }
    return area / (sum + rootTiny);
}

double
faceWeight(const FaceGeometry& geometry, const Vec3& ownerCentre, const Vec3& neighbourCentre) {
    const double owner = std::abs(dot(geometry.area, geometry.centre - ownerCentre));
    const double neighbour = std::abs(dot(geometry.area, neighbourCentre - geometry.centre));
    return std::min(neighbour, owner) / (neighbour + owner + tiny);
}

double volumeRatio(double ownerVolume, double neighbourVolume) {
    return std::min(ownerVolume, neighbourVolume) / (std::max(ownerVolume, neighbourVolume) + tiny);
}

CellClosedness
cellClosedness(std::span<const Vec3> outwardAreas, double volume, const Directions& directions) {
    Vec3 sum;
    Vec3 magnitudes;
    for (const Vec3& area : outwardAreas) {
        sum += area;
        magnitudes += Vec3{std::abs(area.x), std::abs(area.y), std::abs(area.z)};
    }
    CellClosedness result;
    double least = vast;
    double most = -vast;
    for (int axis = 0; axis < 3; ++axis) {
        result.openness =
            std::max(result.openness, std::abs(sum[axis]) / (magnitudes[axis] + rootTiny));
        if (!directions[static_cast<std::size_t>(axis)]) continue;
        least = std::min(least, magnitudes[axis]);
        most = std::max(most, magnitudes[axis]);
    }
    result.aspectRatio = most / (least + rootTiny);
    if (directions == Directions{true, true, true})
        result.aspectRatio = std::max(result.aspectRatio,
                                      1.0 / 6.0 * sumOf(magnitudes) /
                                          std::pow(std::max(rootTiny, volume), 2.0 / 3.0));
    return result;
}

double cellDeterminant(std::span<const Vec3> areas, const Directions& directions) {
    const auto count = std::count(directions.begin(), directions.end(), true);
    if (count == 1) return 1;
    double average = 0;
    for (const Vec3& area : areas)
        average += norm(area);
    if (areas.empty() || average < rootTiny) return 0;
    average /= static_cast<double>(areas.size());
    SymmetricTensor tensor;
    for (const Vec3& area : areas)
        tensor.addSquare(area / average);
    if (count == 2) { // the missing direction must not affect the determinant
        if (!directions[2])
            tensor.zz = 1;
        else if (!directions[1])
            tensor.yy = 1;
        else
            tensor.xx = 1;
    }
    return std::abs(tensor.determinant()) / 8.0;
}

bool isConcaveCell(std::span<const FaceGeometry> faces) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Vec3 normal = faces[i].area / std::max(norm(faces[i].area), tiny);
        for (std::size_t j = 0; j < faces.size(); ++j) {
            if (j == i) continue;
            const Vec3 d = faces[j].centre - faces[i].centre;
            if (dot(d / std::max(norm(d), tiny), normal) > -planarCosine) return true;
        }
    }
    return false;
}

} // namespace polymesh
