// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/slidePoints.h"

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mps/triangulatedFaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace polymesh {

namespace {

void sortUnique(std::vector<Label>& labels) {
    std::ranges::sort(labels);
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
}

class Slider {
public:
    Slider(PolyMesh& mesh, const SubdivisionPlan& plan)
        : mesh_(mesh), plan_(plan), pointCells_(pointCells(mesh)) {}

    /// Makes the first move of a point after which no triangles of the cells at it cross, or else
    /// the best; false when there is none.
    bool slide(Label cell) {
        std::optional<Move> best;
        for (const Label point : crossingPoints(cell)) {
            const auto cells = pointCells_[point];
            const Label before = crossings(cells, all);
            for (const Vec3& to : placesFor(point)) {
                const Vec3 from = std::exchange(mesh_.points[index(point)], to);
                const Label left = crossings(cells, before - (best ? best->gain : 0));
                if (left == 0) return true;
                mesh_.points[index(point)] = from;
                const Label gain = before - left;
                if (gain > (best ? best->gain : 0)) best = {point, to, gain};
            }
        }
        if (best) mesh_.points[index(best->point)] = best->to;
        return best.has_value();
    }

private:
    struct Move {
        Label point;
        Vec3 to;
        Label gain;
    };

    static constexpr Label all = std::numeric_limits<Label>::max();

    TriangulatedFaces trianglesOf(std::span<const Label> cells) const {
        std::vector<Label> faces;
        for (const Label cell : cells)
            faces.insert(faces.end(), plan_.cellFaces[cell].begin(), plan_.cellFaces[cell].end());
        sortUnique(faces);
        TriangulatedFaces triangles(mesh_, plan_, std::move(faces));
        triangles.avoidCrossings(cells);
        return triangles;
    }

    /// How many triangles of the cells cross; as soon as there are `most`, counting ends.
    Label crossings(std::span<const Label> cells, Label most) const {
        const TriangulatedFaces triangles = trianglesOf(cells);
        Label count = 0;
        for (const Label cell : cells) {
            if (count >= most) break;
            count += crossingsOf(triangles.hullOf(cell));
        }
        return count;
    }

    std::vector<Label> crossingPoints(Label cell) const {
        const TriangleHull hull = trianglesOf(std::span(&cell, 1)).hullOf(cell);
        std::vector<Label> points;
        for (const auto& pair : crossingPairs(hull))
            for (const Label triangle : pair)
                for (const Label p : hull.triangles[index(triangle)])
                    if (index(p) < hull.labels.size()) points.push_back(hull.labels[index(p)]);
        sortUnique(points);
        return points;
    }

    /// The boundary faces of a point.
    std::vector<Label> boundaryFacesOf(Label point) const {
        std::vector<Label> faces;
        for (const Label cell : pointCells_[point])
            for (const Label face : plan_.cellFaces[cell])
                if (!mesh_.isInternal(face) &&
                    std::ranges::find(mesh_.faces[face], point) != mesh_.faces[face].end())
                    faces.push_back(face);
        return faces;
    }

    Label patchOf(Label face) const {
        Label p = 0;
        while (face >= mesh_.patches[index(p)].start + mesh_.patches[index(p)].size)
            ++p;
        return p;
    }

    /// Whether the point stays in the plane of all boundary faces, which are in one patch.
    bool staysInPlane(Label point, const Vec3& to) const {
        constexpr double rounding = 1e-12;
        const std::vector<Label> faces = boundaryFacesOf(point);
        if (faces.empty()) return true;
        const Vec3 area = faceGeometry(mesh_.points, mesh_.faces[faces[0]]).area;
        const auto isIn = [&](const Vec3& x) {
            const Vec3 off = x - mesh_.points[index(point)];
            return std::abs(dot(area, off)) <= rounding * norm(area) * norm(off);
        };
        return isIn(to) && std::ranges::all_of(faces, [&](Label face) {
                   return patchOf(face) == patchOf(faces[0]) &&
                          std::ranges::all_of(mesh_.faces[face], [&](Label p) {
                              return isIn(mesh_.points[index(p)]);
                          });
               });
    }

    /// Short ways along the edges and face diagonals of a point.
    std::vector<Vec3> placesFor(Label point) const {
        std::vector<Label> others;
        for (const Label cell : pointCells_[point])
            for (const Label face : plan_.cellFaces[cell]) {
                const auto loop = mesh_.faces[face];
                if (std::ranges::find(loop, point) != loop.end())
                    others.insert(others.end(), loop.begin(), loop.end());
            }
        sortUnique(others);
        std::erase(others, point);
        const Vec3& from = mesh_.points[index(point)];
        std::vector<Vec3> places;
        for (const Label other : others)
            for (const double part : {0.1, 0.03}) {
                const Vec3 to = from + part * (mesh_.points[index(other)] - from);
                if (staysInPlane(point, to)) places.push_back(to);
            }
        return places;
    }

    PolyMesh& mesh_;
    const SubdivisionPlan& plan_;
    Rows<Label> pointCells_;
};

} // namespace

Label slidePoints(PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> cells) {
    constexpr int most = 3;
    Slider slider(mesh, plan);
    Label moved = 0;
    for (const Label cell : cells)
        for (int i = 0; i < most && slider.slide(cell); ++i)
            ++moved;
    return moved;
}

} // namespace polymesh
