// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/faceTriangles.h"

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/quality/cutCell.h"
#include "libpolymesh/shapes/baseShapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace polymesh {

namespace {

using Places = std::array<std::size_t, 3>; // of corners of a polygon
using Triangulation = std::vector<Places>;

/// All triangulations of the polygon of the corners first, first + 1, ..., last.
std::vector<Triangulation> triangulations(std::size_t first, std::size_t last) {
    if (last < first + 2) return {{}};
    std::vector<Triangulation> all;
    for (std::size_t middle = first + 1; middle < last; ++middle)
        for (const Triangulation& left : triangulations(first, middle))
            for (const Triangulation& right : triangulations(middle, last)) {
                all.push_back({{first, middle, last}});
                all.back().insert(all.back().end(), left.begin(), left.end());
                all.back().insert(all.back().end(), right.begin(), right.end());
            }
    return all;
}

/// A triangle's area vector [m^2] and centre.
struct Flat {
    Vec3 area;
    Vec3 centre;
};

Flat flatOf(const Vec3& a, const Vec3& b, const Vec3& c) {
    return {0.5 * cross(b - a, c - a), (a + b + c) / 3};
}

/// Area over squared perimeter.
double roundness(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double perimeter = norm(b - a) + norm(c - b) + norm(a - c);
    return norm(flatOf(a, b, c).area) / (perimeter * perimeter);
}

/// A face, its corners and what its triangles have to bound.
class Cutter {
public:
    Cutter(const MeshEditor& editor, Label f) : editor_(editor), f_(f) {
        for (const Label p : editor.face(f).points)
            corners_.push_back(editor.point(p));
        const Polygon& points = editor.face(f).points;
        whole_ = faceGeometry(editor.mesh().points, {points.data(), points.size()});
    }

    /// The triangulation of least area without chords that are edges of the cell, by dynamic
    /// programming over the rows of corners from one to another; none when there is no such.
    /// Source: Barequet and Sharir (1995).
    std::vector<Triangulation> ofLeastArea() const {
        constexpr double none = std::numeric_limits<double>::infinity();
        const std::size_t n = corners_.size();
        std::vector<double> least(n * n, none); // [first * n + last]
        std::vector<std::size_t> middle(n * n, 0);
        for (std::size_t i = 0; i + 1 < n; ++i)
            least[i * n + i + 1] = 0;
        for (std::size_t length = 2; length < n; ++length)
            for (std::size_t i = 0; i + length < n; ++i) {
                const std::size_t j = i + length;
                if (!isFree(i, j)) continue;
                for (std::size_t k = i + 1; k < j; ++k) {
                    const double area = least[i * n + k] + least[k * n + j] +
                                        norm(flatOf(corners_[i], corners_[k], corners_[j]).area);
                    if (area >= least[i * n + j]) continue;
                    least[i * n + j] = area;
                    middle[i * n + j] = k;
                }
            }
        if (least[n - 1] == none) return {};
        Triangulation triangles;
        std::vector<std::array<std::size_t, 2>> rows{{0, n - 1}};
        while (!rows.empty()) {
            const auto [i, j] = rows.back();
            rows.pop_back();
            if (j < i + 2) continue;
            const std::size_t k = middle[i * n + j];
            triangles.push_back({i, k, j});
            rows.push_back({i, k});
            rows.push_back({k, j});
        }
        return {triangles};
    }

    bool hasFreeChords(const Triangulation& triangles) const {
        return std::ranges::all_of(triangles, [&](const Places& t) {
            return isFree(t[0], t[1]) && isFree(t[1], t[2]) && isFree(t[0], t[2]);
        });
    }

    /// With a new point over each one of the triangles in turn; where each would be a spike, over
    /// all at once.
    void addWaysToRaise(const Triangulation& triangles, std::vector<FaceTriangles>& ways) const {
        constexpr double steep = 0.25;
        std::vector<std::size_t> all;
        double leastSlope = std::numeric_limits<double>::max();
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            all.push_back(i);
            if (const auto slope = slopeOf(triangles, {i}))
                leastSlope = std::min(leastSlope, std::abs(*slope));
            if (auto way = withPointsOver(triangles, {i})) ways.push_back(std::move(*way));
        }
        if (leastSlope < steep) return;
        if (auto way = withPointsOver(triangles, all)) ways.push_back(std::move(*way));
    }

private:
    /// New points over the triangles with these numbers, all as steep.
    std::optional<FaceTriangles> withPointsOver(const Triangulation& triangles,
                                                const std::vector<std::size_t>& raised) const {
        constexpr double leastRoundness = 1e-6;
        constexpr double steepness = 5; // how much a height counts
        const auto slope = slopeOf(triangles, raised);
        if (!slope) return std::nullopt;
        FaceTriangles cut;
        cut.roundness = std::numeric_limits<double>::max();
        cut.slope = std::abs(*slope);
        for (const std::size_t i : raised) {
            const auto& [a, b, c] = triangles[i];
            const Flat under = flatOf(corners_[a], corners_[b], corners_[c]);
            cut.positions.push_back(under.centre +
                                    (*slope / std::sqrt(norm(under.area))) * under.area);
        }
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const auto& [a, b, c] = triangles[i];
            const auto over = std::ranges::find(raised, i);
            if (over == raised.end()) {
                add(cut, {label(a), label(b), label(c)});
                continue;
            }
            const Label middle =
                FaceTriangles::placeholder(static_cast<std::size_t>(over - raised.begin()));
            for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
                add(cut, {label(p), label(q), middle});
        }
        if (cut.roundness <= leastRoundness) return std::nullopt;
        cut.roundness /= 1 + steepness * steepness * cut.slope * cut.slope;
        return cut;
    }

    Label label(std::size_t place) const { return editor_.face(f_).points[place]; }

    /// The height of new points, by the root of the area of the triangle under them, that makes up
    /// for the volume that the triangles bound too much.
    std::optional<double> slopeOf(const Triangulation& triangles,
                                  const std::vector<std::size_t>& raised) const {
        double gained = 0; // seen from the centre of the whole
        for (const auto& [i, j, k] : triangles) {
            const Flat flat = flatOf(corners_[i], corners_[j], corners_[k]);
            gained += dot(flat.area, flat.centre - whole_.centre) / 3;
        }
        double volumeOfSlope = 0;
        for (const std::size_t r : raised) {
            const auto& [i, j, k] = triangles[r];
            const double area = norm(flatOf(corners_[i], corners_[j], corners_[k]).area);
            if (area <= 0) return std::nullopt;
            volumeOfSlope += area * std::sqrt(area) / 3;
        }
        return -gained / volumeOfSlope;
    }

    /// True for edges of the face, and for chords that are no edges of the cell.
    bool isFree(std::size_t a, std::size_t b) const {
        return b == a + 1 || (a == 0 && b + 1 == corners_.size()) ||
               !cellHasEdge(editor_, editor_.face(f_).owner, label(a), label(b));
    }

    void add(FaceTriangles& cut, const Polygon& triangle) const {
        std::array<Vec3, 3> at;
        for (std::size_t i = 0; i < 3; ++i)
            at[i] = triangle[i] < 0 ? cut.positions[FaceTriangles::number(triangle[i])]
                                    : editor_.point(triangle[i]);
        cut.roundness = std::min(cut.roundness, roundness(at[0], at[1], at[2]));
        if (dot(flatOf(at[0], at[1], at[2]).area, whole_.area) <= 0) cut.isTurned = true;
        cut.triangles.push_back(triangle);
    }

    const MeshEditor& editor_;
    Label f_;
    std::vector<Vec3> corners_;
    FaceGeometry whole_;
};

/// Erases those that are steep and much steeper than others.
void eraseSpikes(std::vector<FaceTriangles>& ways) {
    constexpr double steep = 0.5;
    if (ways.empty()) return;
    const double least = std::ranges::min_element(ways, {}, &FaceTriangles::slope)->slope;
    std::erase_if(
        ways, [&](const FaceTriangles& way) { return way.slope > steep && way.slope > 2 * least; });
}

} // namespace

std::vector<FaceTriangles> trianglesKeepingVolume(const MeshEditor& editor, Label face) {
    std::vector<FaceTriangles> found;
    const std::size_t size = editor.face(face).points.size();
    if (editor.isFrozenFace(face)) return found;
    const Cutter cutter(editor, face);
    for (const Triangulation& triangles :
         size > maxShapeFacePoints ? cutter.ofLeastArea() : triangulations(0, size - 1)) {
        if (!cutter.hasFreeChords(triangles)) continue;
        cutter.addWaysToRaise(triangles, found);
    }
    eraseSpikes(found);
    std::ranges::stable_sort(found, {}, [](const FaceTriangles& way) {
        return std::pair(way.isTurned, -way.roundness);
    });
    return found;
}

void replaceByTriangles(MeshEditor& editor, Label face, const FaceTriangles& triangles) {
    std::vector<Label> added;
    for (const Vec3& position : triangles.positions)
        added.push_back(editor.addPoint(position, PointRank::surface));
    EditFace part = editor.face(face);
    for (std::size_t t = 0; t < triangles.triangles.size(); ++t) {
        part.points = triangles.triangles[t];
        for (Label& p : part.points)
            if (p < 0) p = added[FaceTriangles::number(p)];
        if (t == 0)
            editor.setFacePoints(face, part.points);
        else
            editor.addFace(part);
    }
}

} // namespace polymesh
