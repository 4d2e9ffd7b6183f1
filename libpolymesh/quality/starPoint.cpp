// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/starPoint.h"

#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/quality/cellTopology.h"

#include <algorithm>
#include <array>
#include <limits>

namespace polymesh {

namespace {

/// A triangle of a face; its normal points into the cell.
struct Triangle {
    std::array<Vec3, 3> corners;
    Vec3 normal; // unit; zero when the triangle has no area

    double height(const Vec3& p) const { return dot(normal, p - corners[0]); }
};

/// The fans of triangles round the centres of a cell's faces; faces with 3 corners as they are.
std::vector<Triangle> fansOf(MeshEditor& editor, Label cell) {
    std::vector<Triangle> fans;
    for (const Label f : editor.cell(cell).faces) {
        const EditFace& face = editor.face(f);
        const auto& points = face.points;
        const Vec3 centre = editor.faceGeometry(f).centre;
        for (std::size_t i = 0; i < points.size(); ++i) {
            std::array<Vec3, 3> t{
                editor.point(points[i]), editor.point(points[(i + 1) % points.size()]), centre};
            if (points.size() == 3) t[2] = editor.point(points[(i + 2) % 3]);
            if (face.owner == cell) std::swap(t[0], t[1]);
            const Vec3 area = cross(t[1] - t[0], t[2] - t[0]);
            const double length = norm(area);
            if (length > 0) fans.push_back({t, area / length});
            if (points.size() == 3) break;
        }
    }
    return fans;
}

const Triangle& lowestUnder(const std::vector<Triangle>& fans, const Vec3& p) {
    return *std::min_element(fans.begin(), fans.end(), [&](const Triangle& a, const Triangle& b) {
        return a.height(p) < b.height(p);
    });
}

} // namespace

std::optional<Vec3> starPoint(MeshEditor& editor, Label cell) {
    constexpr int steps = 100;
    const std::vector<Triangle> fans = fansOf(editor, cell);
    if (fans.size() < 4) return std::nullopt;
    const double size = editor.cell(cell).size;
    Vec3 p = editor.cellGeometry(cell).centre;
    Vec3 best = p;
    double bestHeight = -std::numeric_limits<double>::infinity();
    // Each step goes away from the plane that is nearest, or most in front, by less and less.
    for (int step = 0; step < steps; ++step) {
        const Triangle& lowest = lowestUnder(fans, p);
        const double height = lowest.height(p);
        if (height > bestHeight) {
            best = p;
            bestHeight = height;
        }
        p += (std::max(-height, 0.0) + 0.3 * size / (step + 3)) * lowest.normal;
    }
    const bool seesAll = std::all_of(fans.begin(), fans.end(), [&](const Triangle& t) {
        return orient3d(t.corners[0], t.corners[1], t.corners[2], best) > 0;
    });
    if (!seesAll || bestHeight < 1e-3 * size) return std::nullopt;
    return best;
}

std::vector<Label> makePyramids(MeshEditor& editor, Label cell, const Vec3& apex) {
    if (cellShape(editor.mesh(), cell) != CellShape::ball) return {};
    std::vector<EdgeUse> uses;
    collectEdgeUses(editor.mesh(), cell, uses);
    const auto faces = editor.cell(cell).faces; // a copy: giving faces away changes the list
    const Label point = editor.addPoint(apex, PointRank::interior);
    std::vector<Label> pyramids{cell};
    for (std::size_t i = 1; i < faces.size(); ++i) {
        pyramids.push_back(editor.addPartOf(cell));
        editor.giveFace(faces[i], cell, pyramids.back());
    }
    const auto pyramidOn = [&](Label f) {
        return pyramids[static_cast<std::size_t>(std::find(faces.begin(), faces.end(), f) -
                                                 faces.begin())];
    };
    for (std::size_t i = 0; i + 1 < uses.size(); i += 2) {
        const EdgeUse& forward = uses[i].forward ? uses[i] : uses[i + 1];
        const EdgeUse& backward = uses[i].forward ? uses[i + 1] : uses[i];
        // Seen from outside the face runs low-high; the side below it runs high-low.
        EditFace side;
        side.points = {forward.high, forward.low, point};
        side.owner = pyramidOn(forward.face);
        side.neighbour = pyramidOn(backward.face);
        editor.addFace(side);
    }
    return pyramids;
}

} // namespace polymesh
