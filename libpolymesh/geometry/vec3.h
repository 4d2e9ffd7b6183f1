// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace polymesh {

/// A point or a vector in space [m], or an area vector [m^2].
struct Vec3 {
    double x = 0;
    double y = 0;
    double z = 0;

    double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

    double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }

    Vec3& operator+=(const Vec3& b) { return *this = {x + b.x, y + b.y, z + b.z}; }

    Vec3& operator-=(const Vec3& b) { return *this = {x - b.x, y - b.y, z - b.z}; }

    bool operator==(const Vec3&) const = default;
    // Lexicographic. NOLINTNEXTLINE(modernize-use-nullptr): what the compiler makes of it
    auto operator<=>(const Vec3&) const = default;
};

inline Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Vec3 operator-(const Vec3& a) {
    return {-a.x, -a.y, -a.z};
}

inline Vec3 operator*(double s, const Vec3& a) {
    return {s * a.x, s * a.y, s * a.z};
}

inline Vec3 operator/(const Vec3& a, double s) {
    return {a.x / s, a.y / s, a.z / s};
}

inline double dot(const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double squaredNorm(const Vec3& a) {
    return dot(a, a);
}

inline double norm(const Vec3& a) {
    return std::sqrt(dot(a, a));
}

inline bool isFinite(const Vec3& a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

} // namespace polymesh
