// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/boxTree.h"
#include "libpolymesh/surface/distance.h"
#include "libpolymesh/surface/triSurface.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace polymesh {

/// Some triangles of a surface, to be asked what is near. Queries are thread-safe.
class NearTriangles {
public:
    /// Keeps a share in the surface. Cost: n log n.
    NearTriangles(std::shared_ptr<const TriSurface> surface, std::vector<Label> triangles);

    /// All triangles.
    explicit NearTriangles(const std::shared_ptr<const TriSurface>& surface);

    /// The closest point, when it is at most so far away. Cost: next to nothing for far points.
    std::optional<ClosestPoint> closest(const Vec3& p, double atMost) const;

    /// Calls visit(triangle, its point closest to p) for the triangles at most so far away.
    template<class Visit>
    void forNear(const Vec3& p, double atMost, Visit&& visit) const {
        const Vec3 reach{atMost, atMost, atMost};
        tree_.forEachNear({p - reach, p + reach}, [&](Label item) {
            const Label t = triangles_[index(item)];
            const Vec3 q = closestPoint(cornersOf(t), p);
            if (squaredNorm(q - p) <= atMost * atMost) visit(t, q);
        });
    }

    /// Calls visit(triangle) for the triangles near a box: at least those that meet it.
    template<class Visit>
    void forBox(const Box& box, Visit&& visit) const {
        tree_.forEachNear(box, [&](Label item) { visit(triangles_[index(item)]); });
    }

    /// The share of the way from a to b at which the segment first meets a triangle that `counts`;
    /// empty when there is none.
    std::optional<double>
    firstHit(const Vec3& a, const Vec3& b, const std::function<bool(Label)>& counts) const;

    const TriSurface& surface() const { return *surface_; }

    std::array<Vec3, 3> cornersOf(Label t) const {
        return {surface_->corner(t, 0), surface_->corner(t, 1), surface_->corner(t, 2)};
    }

private:
    std::shared_ptr<const TriSurface> surface_;
    std::vector<Label> triangles_;
    BoxTree tree_;
};

/// The unit normal of a triangle; 0 when it has no area.
Vec3 unitNormal(const std::array<Vec3, 3>& triangle);

} // namespace polymesh
