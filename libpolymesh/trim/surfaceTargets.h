// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/boxTree.h"
#include "libpolymesh/surface/distance.h"
#include "libpolymesh/surface/features.h"
#include "libpolymesh/trim/arrangement.h"
#include "libpolymesh/trim/nodeFreedom.h"
#include "libpolymesh/trim/nodeMove.h"

#include <optional>
#include <span>
#include <vector>

namespace polymesh {

/// What of the surface a node can be put onto, or keep away from. Edges and corners have trees of
/// their own. Queries are thread-safe; the surface and its features must outlive the object.
class SurfaceTargets {
public:
    SurfaceTargets(const CuttingSurface& cutter, const SurfaceFeatures& features);

    /// The closest point of the surface within reach of p; triangle -1: there is none.
    ClosestPoint closest(const Vec3& p, double reach) const;

    /// Unit normal of a triangle.
    Vec3 normal(Label triangle) const;

    /// The closest corner all of whose faces are within reach of p, or -1.
    Label nearestCorner(const Vec3& p, double reach) const;

    NodeMove onCorner(Label v) const;

    /// The closest place on a feature edge, with both faces within reach, that a node at p may go
    /// to.
    std::optional<NodeMove> onEdge(const Vec3& p, double reach, const NodeFreedom& freedom) const;

    /// The closest place on a triangle that a node at p may go to.
    std::optional<NodeMove> onFace(const Vec3& p, double reach, const NodeFreedom& freedom) const;

    /// Calls body(start, end) with the ends of the feature edges that may overlap the box.
    template<class Body>
    void forFeatureEdges(const Box& box, Body&& body) const {
        edgeTree_.forEachNear(box, [&](Label i) {
            const SurfaceEdge& edge = edges_[index(featureEdges_[index(i)])];
            body(surface_.points[index(edge.start)], surface_.points[index(edge.end)]);
        });
    }

    /// Calls body(place) for the corners that may be in the box.
    template<class Body>
    void forCorners(const Box& box, Body&& body) const {
        cornerTree_.forEachNear(box,
                                [&](Label i) { body(surface_.points[index(corners_[index(i)])]); });
    }

private:
    static std::vector<Label> listed(const std::vector<char>& flags);
    Label placeOf(Label v) const;
    void sumCornerNormals();
    std::optional<Vec3>
    placeOnEdge(const SurfaceEdge& edge, const Vec3& p, const NodeFreedom& freedom) const;
    Vec3 flush(const ClosestPoint& on, Vec3 place) const;

    const TriSurface& surface_;
    const std::vector<SurfaceEdge>& edges_;
    const SurfaceFeatures& features_;
    std::vector<Label> corners_;
    std::vector<Label> featureEdges_;
    BoxTree tree_;
    BoxTree cornerTree_;
    BoxTree edgeTree_;
    std::vector<Vec3> cornerNormals_; // beside corners_
    Rows<Label> cornerTriangles_;     // beside corners_
};

} // namespace polymesh
