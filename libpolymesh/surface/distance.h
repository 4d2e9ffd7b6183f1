// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"

#include <array>
#include <memory>

namespace polymesh {

/// A point of a surface and how far it is away.
struct ClosestPoint {
    Vec3 point;          // on the triangle
    double distance = 0; // [m]
    Label triangle = -1;
};

/// The point of the triangle that is closest to p; also for triangles without area.
Vec3 closestPoint(const std::array<Vec3, 3>& triangle, const Vec3& p);

/// Finds closest points on a surface; queries are thread-safe.
class SurfaceTree {
public:
    /// Cost: O(n log n); 0.25 M triangles in 0.1 s. The surface must outlive the tree.
    /// Throws InputError for a surface without triangles.
    explicit SurfaceTree(const TriSurface& surface);
    ~SurfaceTree();
    SurfaceTree(SurfaceTree&&) noexcept;
    SurfaceTree& operator=(SurfaceTree&&) noexcept;
    SurfaceTree(const SurfaceTree&) = delete;
    SurfaceTree& operator=(const SurfaceTree&) = delete;

    /// The point of the surface closest to `p`; of equally close triangles the one with the lowest
    /// label among those looked at. Cost: O(log n) for points near the surface.
    ClosestPoint closest(const Vec3& p) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace polymesh
