// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surfaceRepair/divideTriangles.h"

#include "libpolymesh/base/rows.h"
#include "libpolymesh/surface/coplanar.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/intersections.h>
#include <map>
#include <utility>
#include <vector>

namespace polymesh {

namespace {

using Triangulation = CGAL::
    Constrained_Delaunay_triangulation_2<ExactKernel, CGAL::Default, CGAL::Exact_intersections_tag>;
using PlanePoint = ExactKernel::Point_2;

/// The plane of a triangle, seen along one of the axes that are not in it.
class View {
public:
    explicit View(const ExactKernel::Triangle_3& triangle) : plane_(triangle.supporting_plane()) {
        const ExactKernel::Vector_3 normal = plane_.orthogonal_vector();
        // The steepest view, in double precision, is one of those that are exact.
        for (int axis = 0; axis < 3; ++axis) {
            const double size = std::abs(CGAL::to_double(normal[axis]));
            if (CGAL::sign(normal[axis]) == CGAL::ZERO || size < steepest_) continue;
            axis_ = axis;
            steepest_ = size;
        }
        isMirrored_ = CGAL::sign(normal[axis_]) == CGAL::NEGATIVE;
    }

    PlanePoint flatten(const ExactPoint& p) const { return {p[first()], p[second()]}; }

    ExactPoint lift(const PlanePoint& q) const {
        std::array<ExactKernel::FT, 3> coordinates;
        const ExactKernel::Vector_3 normal = plane_.orthogonal_vector();
        coordinates[static_cast<std::size_t>(first())] = q.x();
        coordinates[static_cast<std::size_t>(second())] = q.y();
        coordinates[static_cast<std::size_t>(axis_)] =
            -(plane_.d() + normal[first()] * q.x() + normal[second()] * q.y()) / normal[axis_];
        return {coordinates[0], coordinates[1], coordinates[2]};
    }

    /// Whether a triangle that turns left in the view is turned against the triangle in space.
    bool isMirrored() const { return isMirrored_; }

private:
    int first() const { return (axis_ + 1) % 3; }

    int second() const { return (axis_ + 2) % 3; }

    ExactKernel::Plane_3 plane_;
    int axis_ = 0;
    double steepest_ = 0;
    bool isMirrored_ = false;
};

/// Puts what two triangles have in common into the triangulation of one.
struct InsertCommon {
    const View& view;
    Triangulation& triangulation;

    using result_type = void; // for boost's visitors

    void operator()(const ExactPoint& point) const { triangulation.insert(view.flatten(point)); }

    void operator()(const ExactKernel::Segment_3& segment) const {
        insertSide(segment.source(), segment.target());
    }

    void operator()(const ExactKernel::Triangle_3& triangle) const {
        for (int i = 0; i < 3; ++i)
            insertSide(triangle[i], triangle[i + 1]);
    }

    void operator()(const std::vector<ExactPoint>& polygon) const {
        for (std::size_t i = 0; i < polygon.size(); ++i)
            insertSide(polygon[i], polygon[(i + 1) % polygon.size()]);
    }

    void insertSide(const ExactPoint& a, const ExactPoint& b) const {
        triangulation.insert_constraint(view.flatten(a), view.flatten(b));
    }
};

using Common = decltype(CGAL::intersection(std::declval<ExactKernel::Triangle_3>(),
                                           std::declval<ExactKernel::Triangle_3>()));

/// What the triangles of each pair have in common: found once for both.
std::vector<Common> intersections(const TriSurface& surface,
                                  std::span<const std::array<Label, 2>> pairs) {
    std::vector<Common> common;
    common.reserve(pairs.size());
    for (const auto& [s, t] : pairs)
        common.push_back(CGAL::intersection(exactTriangle(surface, s), exactTriangle(surface, t)));
    return common;
}

class SoupMaker {
public:
    SoupMaker(const TriSurface& surface, std::span<const std::array<Label, 2>> pairs)
        : surface_(surface), common_(intersections(surface, pairs)) {
        soup_.points.reserve(surface.points.size());
        for (const Vec3& p : surface.points)
            soup_.points.push_back(toExact(p));
    }

    void addWhole(Label t) { addTriangle(surface_.triangles[index(t)], t); }

    void addDivided(Label t, std::span<const Label> pairs) {
        // Only corners of divided triangles can be new points of others.
        for (Label corner : surface_.triangles[index(t)])
            labels_.try_emplace(soup_.points[index(corner)], corner);
        divide(t, pairs);
    }

    ExactSoup take() { return std::move(soup_); }

private:
    void divide(Label t, std::span<const Label> pairs) {
        const ExactKernel::Triangle_3 triangle = exactTriangle(surface_, t);
        const View view(triangle);
        Triangulation triangulation;
        const InsertCommon insert{view, triangulation};
        insert(triangle);
        for (Label pair : pairs)
            if (const Common& common = common_[index(pair)]) boost::apply_visitor(insert, *common);
        std::map<Triangulation::Vertex_handle, Label> labels;
        for (const auto vertex : triangulation.finite_vertex_handles())
            labels[vertex] = addPoint(view.lift(vertex->point()));
        for (const auto face : triangulation.finite_face_handles()) {
            std::array<Label, 3> corners{
                labels[face->vertex(0)], labels[face->vertex(1)], labels[face->vertex(2)]};
            if (view.isMirrored()) std::swap(corners[1], corners[2]);
            addTriangle(corners, t);
        }
    }

    Label addPoint(const ExactPoint& point) {
        const auto [entry, isNew] = labels_.try_emplace(point, toLabel(soup_.points.size()));
        if (isNew) soup_.points.push_back(point);
        return entry->second;
    }

    void addTriangle(const std::array<Label, 3>& corners, Label source) {
        soup_.triangles.push_back(corners);
        soup_.source.push_back(source);
    }

    const TriSurface& surface_;
    std::vector<Common> common_; // one per pair
    ExactSoup soup_;
    std::map<ExactPoint, Label> labels_; // in the order of coordinates
};

/// For each triangle the pairs that it is in.
Rows<Label> pairsOf(Label triangleCount, std::span<const std::array<Label, 2>> pairs) {
    std::vector<std::vector<Label>> found(index(triangleCount));
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (Label t : pairs[i])
            found[index(t)].push_back(toLabel(i));
    Rows<Label> rows;
    for (const auto& row : found)
        rows.add(row);
    return rows;
}

} // namespace

ExactSoup divideTriangles(const TriSurface& surface, std::span<const std::array<Label, 2>> pairs) {
    const Rows<Label> own = pairsOf(surface.triangleCount(), pairs);
    SoupMaker soup(surface, pairs);
    for (Label t = 0; t < surface.triangleCount(); ++t) {
        if (areCollinear(surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)))
            continue;
        if (own.rowSize(t) == 0)
            soup.addWhole(t);
        else
            soup.addDivided(t, own[t]);
    }
    return soup.take();
}

} // namespace polymesh
