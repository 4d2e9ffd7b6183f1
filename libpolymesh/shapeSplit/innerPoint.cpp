// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/innerPoint.h"

#include "libpolymesh/geometry/box.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/mps/pointWithin.h"
#include "libpolymesh/quality/starPoint.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace polymesh {

namespace {

/// The corners of a face as seen from inside the cell: clockwise seen from outside.
std::vector<Vec3> inwardCorners(const MeshEditor& editor, Label cell, Label f) {
    std::vector<Vec3> corners;
    for (const Label p : editor.face(f).points)
        corners.push_back(editor.point(p));
    if (editor.face(f).owner == cell) std::ranges::reverse(corners);
    return corners;
}

Vec3 inwardArea(MeshEditor& editor, Label cell, Label f) {
    const Vec3& area = editor.faceGeometry(f).area;
    return editor.face(f).owner == cell ? -area : area;
}

/// True when the pyramid from the point to the face has a positive volume that is not only
/// rounding, as on corners in one line.
bool isBehind(MeshEditor& editor, Label cell, Label f, const Vec3& point) {
    constexpr double rounding = 1e-10;
    const double size = editor.cell(cell).size;
    return dot(inwardArea(editor, cell, f), point - editor.faceGeometry(f).centre) >
           rounding * size * size * size;
}

/// True when the triangle of a polygon's corner and its neighbours is seen from the point and no
/// other corner lies in front of it.
bool isEar(const std::vector<Vec3>& corners, std::size_t i, const Vec3& point) {
    const std::size_t n = corners.size();
    const Vec3& a = corners[(i + n - 1) % n];
    const Vec3& b = corners[i];
    const Vec3& c = corners[(i + 1) % n];
    if (orient3d(a, b, c, point) <= 0) return false;
    for (std::size_t k = (i + 2) % n; k != (i + n - 1) % n; k = (k + 1) % n)
        if (orient3d(a, b, corners[k], point) >= 0 && orient3d(b, c, corners[k], point) >= 0 &&
            orient3d(c, a, corners[k], point) >= 0)
            return false;
    return true;
}

bool seesAll(MeshEditor& editor, Label cell, const Vec3& point) {
    return std::ranges::all_of(editor.cell(cell).faces,
                               [&](Label f) { return isSeenFrom(editor, cell, f, point); });
}

/// Which side of a face the point has to be on.
enum class Demand : std::uint8_t { wholeFace, everyTriangle };

/// Adds the half-space behind the whole face; with `everyTriangle` those behind the triangles
/// between its edges and its centre, unless some of these look the other way.
void addDemand(
    MeshEditor& editor, Label cell, Label f, Demand demand, std::vector<HalfSpace>& halfSpaces) {
    const Vec3 area = inwardArea(editor, cell, f);
    const Vec3 centre = editor.faceGeometry(f).centre;
    const double size = norm(area);
    if (size > 0) halfSpaces.push_back({area / size, centre});
    if (demand == Demand::wholeFace) return;
    const std::vector<Vec3> corners = inwardCorners(editor, cell, f);
    const std::size_t first = halfSpaces.size();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3& a = corners[i];
        const Vec3& b = corners[(i + 1) % corners.size()];
        if (dot(cross(b - a, centre - a), area) <= 0) {
            halfSpaces.resize(first);
            return;
        }
        addHalfSpace(b - a, centre - a, a, halfSpaces);
    }
}

constexpr Search wellWithin{.least = 8e-4};

/// The points of a grid round the cell that are behind all faces, those farthest from the planes
/// through the faces' centres first.
std::vector<Vec3> pointsOfGrid(MeshEditor& editor, Label cell) {
    constexpr int divisions = 9;
    const double least = 1e-4 * editor.cell(cell).size;
    std::vector<HalfSpace> behind;
    Box box;
    for (const Label f : editor.cell(cell).faces) {
        addDemand(editor, cell, f, Demand::wholeFace, behind);
        for (const Label p : editor.face(f).points)
            box.add(editor.point(p));
    }
    const auto height = [&](const Vec3& p) {
        double lowest = std::numeric_limits<double>::max();
        for (const HalfSpace& h : behind)
            lowest = std::min(lowest, dot(h.normal, p - h.at));
        return lowest;
    };
    const Vec3 step = box.size() / divisions;
    std::vector<std::pair<double, Vec3>> found;
    for (int i = 0; i < divisions * divisions * divisions; ++i) {
        const int j = i / divisions % divisions;
        const int k = i / (divisions * divisions);
        const Vec3 p =
            box.min + Vec3{(i % divisions + 0.5) * step.x, (j + 0.5) * step.y, (k + 0.5) * step.z};
        if (const double h = height(p); h > least) found.emplace_back(-h, p);
    }
    std::ranges::sort(found);
    std::vector<Vec3> points;
    points.reserve(found.size());
    for (const auto& [h, p] : found)
        points.push_back(p);
    return points;
}

/// The first point of the grid that sees all faces: finds what has room, of whatever form it is.
std::optional<Vec3> gridPoint(MeshEditor& editor, Label cell) {
    for (const Vec3& p : pointsOfGrid(editor, cell))
        if (seesAll(editor, cell, p)) return p;
    return std::nullopt;
}

} // namespace

// Cuts off ears until a triangle is left; a polygon that does not cross itself always has one.
bool isSimpleSeenFrom(std::vector<Vec3> corners, const Vec3& point) {
    while (corners.size() > 3) {
        std::size_t i = 0;
        while (i < corners.size() && !isEar(corners, i, point))
            ++i;
        if (i == corners.size()) return false;
        corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return orient3d(corners[0], corners[1], corners[2], point) > 0;
}

bool isSeenFrom(MeshEditor& editor, Label cell, Label face, const Vec3& point) {
    return isBehind(editor, cell, face, point) &&
           isSimpleSeenFrom(inwardCorners(editor, cell, face), point);
}

std::optional<Vec3> innerPoint(MeshEditor& editor, Label cell) {
    if (const auto found = starPoint(editor, cell); found && seesAll(editor, cell, *found))
        return found;
    using enum Demand;
    for (const auto& [onShared, onBoundary] : {std::pair{everyTriangle, everyTriangle},
                                               std::pair{everyTriangle, wholeFace},
                                               std::pair{wholeFace, everyTriangle},
                                               std::pair{wholeFace, wholeFace}}) {
        std::vector<HalfSpace> halfSpaces;
        for (const Label f : editor.cell(cell).faces)
            addDemand(
                editor, cell, f, editor.face(f).isBoundary() ? onBoundary : onShared, halfSpaces);
        const auto found = pointWithin(
            halfSpaces, editor.cellGeometry(cell).centre, editor.cell(cell).size, wellWithin);
        if (found && seesAll(editor, cell, *found)) return found;
    }
    return gridPoint(editor, cell);
}

std::vector<Vec3> innerPoints(MeshEditor& editor, Label cell) {
    std::vector<Vec3> points;
    if (const auto first = innerPoint(editor, cell)) points.push_back(*first);
    if (points.empty()) return points;
    if (const Vec3 centre = editor.cellGeometry(cell).centre; seesAll(editor, cell, centre))
        points.push_back(centre);
    constexpr std::size_t most = 12;
    const double apart = 0.15 * editor.cell(cell).size;
    for (const Vec3& p : pointsOfGrid(editor, cell)) {
        const auto isNear = [&](const Vec3& q) { return norm(p - q) < apart; };
        if (points.size() == most) break;
        if (std::ranges::none_of(points, isNear) && seesAll(editor, cell, p)) points.push_back(p);
    }
    return points;
}

std::optional<Vec3> pointBehindFaces(MeshEditor& editor, Label cell) {
    std::vector<HalfSpace> halfSpaces;
    for (const Label f : editor.cell(cell).faces)
        addDemand(editor, cell, f, Demand::wholeFace, halfSpaces);
    const auto found = pointWithin(
        halfSpaces, editor.cellGeometry(cell).centre, editor.cell(cell).size, wellWithin);
    const bool isBehindAll = found && std::ranges::all_of(editor.cell(cell).faces, [&](Label f) {
                                 return isBehind(editor, cell, f, *found);
                             });
    return isBehindAll ? found : std::nullopt;
}

} // namespace polymesh
