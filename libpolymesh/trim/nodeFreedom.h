// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace polymesh {

/// How a node may move: anywhere, in a plane, along a line, or not at all; as the planes of the
/// mesh's boundary faces round it allow.
class NodeFreedom {
public:
    /// Holds the node in a plane with this unit normal. Normals that differ by less than 1e-6 rad
    /// are one.
    void addPlane(const Vec3& normal) {
        for (std::size_t i = 0; i < planes_; ++i)
            if (norm(cross(normal, normals_[i])) < 1e-6) return;
        if (planes_ == 2) {
            const Vec3 line = cross(normals_[0], normals_[1]);
            if (std::abs(dot(normal, line)) < 1e-6 * norm(line)) return;
        }
        if (planes_ < 3) normals_[planes_++] = normal;
    }

    bool isFree() const { return planes_ == 0; }

    bool isFixed() const { return planes_ == 3; }

    bool isPlane() const { return planes_ == 1; }

    /// Of a plane.
    const Vec3& normal() const { return normals_[0]; }

    /// The part of a way that the node can go.
    Vec3 along(const Vec3& way) const {
        if (planes_ == 0) return way;
        if (planes_ == 3) return {};
        if (planes_ == 1) return way - dot(way, normals_[0]) * normals_[0];
        const Vec3 line = cross(normals_[0], normals_[1]);
        return (dot(way, line) / squaredNorm(line)) * line;
    }

    /// The place with those coordinates of `from` that axis-parallel planes hold, to the bit.
    Vec3 held(Vec3 place, const Vec3& from) const {
        for (std::size_t i = 0; i < planes_; ++i)
            for (int axis = 0; axis < 3; ++axis)
                if (std::abs(normals_[i][axis]) == 1) place[axis] = from[axis];
        return place;
    }

private:
    std::array<Vec3, 3> normals_{};
    std::size_t planes_ = 0;
};

} // namespace polymesh
