// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapes/parentFit.h"

#include "libpolymesh/mesh/cellGeometry.h"

#include <algorithm>
#include <cmath>

namespace polymesh {

namespace {

/// The corners of a face of the base in the cell.
class MappedFace {
public:
    MappedFace(const Recognition& cell, std::size_t face) {
        for (const ShapeVertex v : tableOf(cell.base).faces[face])
            corners_[size_++] = cell.points[v];
    }

    std::span<const Label> corners() const { return std::span(corners_).first(size_); }

private:
    std::array<Label, maxShapeFacePoints> corners_{};
    std::size_t size_ = 0;
};

FaceGraph graphOf(const Recognition& cell) {
    FaceGraph graph;
    for (std::size_t f = 0; f < tableOf(cell.base).faces.size(); ++f)
        graph.addFace(MappedFace(cell, f).corners(), false);
    graph.close();
    return graph;
}

Vec3 unitNormal(const Recognition& cell, std::size_t face, std::span<const Vec3> points) {
    const Vec3 area = faceGeometry(points, MappedFace(cell, face).corners()).area;
    const double size = norm(area);
    return size > 0 ? area / size : area;
}

/// True for a face of the hexahedron whose opposite is gone (of sammTrim5).
bool isSingle(const BaseShapeTable& table, std::size_t face) {
    const auto holds = [&](const auto& pair) { return pair[0] == face || pair[1] == face; };
    return std::ranges::none_of(table.oppositeFaces, holds) &&
           std::ranges::find(table.cutFaces, face) == table.cutFaces.end();
}

/// The more, the more nearly the faces that should be opposite are, and the more nearly upright on
/// them those are that should be beside them.
double likeness(const Recognition& cell, std::span<const Vec3> points) {
    const BaseShapeTable& table = tableOf(cell.base);
    double sum = 0;
    for (const auto& [one, other] : table.oppositeFaces) {
        const Vec3 a = unitNormal(cell, one, points);
        const Vec3 b = unitNormal(cell, other, points);
        sum -= dot(a, b);
        for (std::size_t f = 0; f < table.faces.size(); ++f)
            if (isSingle(table, f)) sum -= std::abs(dot(unitNormal(cell, f, points), a - b)) / 2;
    }
    return sum;
}

bool isCut(const Recognition& cell, std::span<const Label> face) {
    return std::ranges::any_of(tableOf(cell.base).cutFaces, [&](std::size_t f) {
        const MappedFace cut(cell, f);
        return std::ranges::is_permutation(cut.corners(), face);
    });
}

/// Looks through the ways in which a cell is a base shape.
class Fit {
public:
    Fit(const Recognition& found, std::span<const Vec3> points, std::span<const Label> cutFace)
        : graph_(graphOf(found)),
          points_(points),
          cutFace_(cutFace),
          best_(found),
          bestScore_(scoreOf(found)) {}

    void tryBase(BaseShape base) {
        Recognition ownVertices{best_.shape, base, {}};
        for (std::size_t v = 0; v < maxShapePoints; ++v)
            ownVertices.points[v] = toLabel(v);
        const FaceGraph model = graphOf(ownVertices);
        const FaceGraph::Walk modelWalk = model.walk(0);
        for (std::size_t root = 0; root < graph_.dartCount(); ++root) {
            const FaceGraph::Walk walk = graph_.walk(root);
            if (walk.code != modelWalk.code) continue;
            Recognition way{best_.shape, base, {}};
            for (std::size_t met = 0; met < graph_.pointCount(); ++met)
                way.points[index(model.label(modelWalk.points[met]))] =
                    graph_.label(walk.points[met]);
            keepIfBetter(way);
        }
    }

    const Recognition& best() const { return best_; }

private:
    double scoreOf(const Recognition& way) const {
        constexpr double known = 100; // more than any sum of cosines
        return likeness(way, points_) + (!cutFace_.empty() && isCut(way, cutFace_) ? known : 0.0);
    }

    void keepIfBetter(const Recognition& way) {
        const double score = scoreOf(way);
        if (score <= bestScore_) return;
        best_ = way;
        bestScore_ = score;
    }

    FaceGraph graph_;
    std::span<const Vec3> points_;
    std::span<const Label> cutFace_;
    Recognition best_;
    double bestScore_;
};

} // namespace

Recognition fitToParent(const Recognition& found,
                        std::span<const Vec3> points,
                        std::span<const Label> cutFace) {
    const bool isTrimmed = !tableOf(found.base).cutFaces.empty();
    if (!isTrimmed || !Catalogue::instance()[found.shape].collapsed.empty()) return found;
    Fit fit(found, points, cutFace);
    fit.tryBase(found.base);
    if (found.base == BaseShape::sammTrim1) fit.tryBase(BaseShape::sammTrim3);
    return fit.best();
}

} // namespace polymesh
