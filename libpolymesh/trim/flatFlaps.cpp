// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/flatFlaps.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/collapsePoints.h"
#include "libpolymesh/quality/polygons.h"
#include "libpolymesh/trim/bridges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace polymesh {

namespace {

constexpr double roundOff = 1e-10; // of a cell's size

using DirectedEdge = std::array<Label, 2>;

/// The corners of a face as seen from outside a cell.
Polygon outwardCorners(const EditFace& face, Label cell) {
    Polygon corners = face.points;
    if (face.owner != cell) std::reverse(corners.begin(), corners.end());
    return corners;
}

/// Looks for flaps of one cell.
class FlapSearch {
public:
    FlapSearch(MeshEditor& editor, Label cell)
        : editor_(editor), cell_(cell), tolerance_(roundOff * editor.cell(cell).size) {}

    /// The flaps that lie on a face.
    std::vector<Label> flapsOn(Label whole) {
        std::vector<Label> flaps;
        if (editor_.isFrozenFace(whole)) return flaps;
        for (const Label f : editor_.cell(cell_).faces)
            if (f != whole && editor_.face(f).isBoundary() && liesOn(f, whole)) flaps.push_back(f);
        std::ranges::sort(flaps);
        return flaps;
    }

private:
    Vec3 outwardArea(Label f) {
        const Vec3 area = editor_.faceGeometry(f).area;
        return editor_.face(f).owner == cell_ ? area : -1.0 * area;
    }

    bool liesOn(Label part, Label whole) {
        const Vec3 area = outwardArea(whole);
        const Vec3 partArea = outwardArea(part);
        const double size = norm(area);
        const double partSize = norm(partArea);
        if (dot(area, partArea) >= -0.999 * size * partSize) return false;
        if (partSize <= tolerance_ * editor_.cell(cell_).size) return false;
        const Polygon& corners = editor_.face(part).points;
        const Vec3& origin = editor_.point(editor_.face(whole).points[0]);
        return std::ranges::all_of(corners, [&](Label corner) {
            const Vec3 p = editor_.point(corner);
            return std::abs(dot(p - origin, area)) <= tolerance_ * size &&
                   isWithin(p, whole, area / size);
        });
    }

    /// Whether a point in the plane of a face is in it or on its outline.
    bool isWithin(const Vec3& p, Label whole, const Vec3& normal) const {
        const Polygon& polygon = editor_.face(whole).points;
        double winding = 0; // [rad]
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec3 a = editor_.point(polygon[i]) - p;
            const Vec3 b = editor_.point(polygon[(i + 1) % polygon.size()]) - p;
            const double across = dot(cross(a, b), normal);
            if (std::abs(across) <= tolerance_ * norm(b - a) && dot(a, b) <= 0) return true;
            if (norm(a) <= tolerance_ || norm(b) <= tolerance_) return true;
            winding += std::atan2(across, dot(a, b));
        }
        return std::abs(winding) > 1;
    }

    MeshEditor& editor_;
    Label cell_;
    double tolerance_;
};

/// What is left of a face without the flaps: their edges together, less those that are used in
/// both directions.
std::vector<DirectedEdge>
edgesOfRest(const MeshEditor& editor, Label cell, Label whole, const std::vector<Label>& flaps) {
    std::vector<DirectedEdge> edges;
    const auto add = [&](Label f) {
        const Polygon corners = outwardCorners(editor.face(f), cell);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const DirectedEdge edge{corners[i], corners[(i + 1) % corners.size()]};
            const auto reverse = std::ranges::find(edges, DirectedEdge{edge[1], edge[0]});
            if (reverse == edges.end())
                edges.push_back(edge);
            else
                edges.erase(reverse);
        }
    };
    add(whole);
    for (const Label f : flaps)
        add(f);
    return edges;
}

/// The closed loops that the edges make.
std::vector<LoopPolygon> loopsOf(std::vector<DirectedEdge> edges) {
    std::vector<LoopPolygon> loops;
    while (!edges.empty()) {
        Polygon walk;
        Label at = edges.front()[0];
        for (auto next = edges.begin(); next != edges.end();
             next = std::ranges::find(edges, at, [](const DirectedEdge& e) { return e[0]; })) {
            walk.push_back(at);
            at = (*next)[1];
            edges.erase(next);
        }
        for (const Polygon& loop : simpleLoops(walk))
            loops.emplace_back(loop.begin(), loop.end());
    }
    return loops;
}

Vec3 areaOf(const MeshEditor& editor, const LoopPolygon& loop) {
    Vec3 area;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        area += cross(editor.point(loop[i]) - editor.point(loop[0]),
                      editor.point(loop[i + 1]) - editor.point(loop[0]));
    return area;
}

/// The polygons of what is left of a face, as seen from outside the cell.
std::vector<LoopPolygon>
restOf(MeshEditor& editor, Label cell, Label whole, const std::vector<Label>& flaps) {
    const double sign = editor.face(whole).owner == cell ? 1 : -1;
    const Vec3 normal = sign * editor.faceGeometry(whole).area;
    CurvesOnFace curves;
    for (LoopPolygon& loop : loopsOf(edgesOfRest(editor, cell, whole, flaps))) {
        const bool isHole = dot(areaOf(editor, loop), normal) <= 0;
        (isHole ? curves.closed : curves.polygons).push_back(std::move(loop));
    }
    std::vector<Label> ends;
    openHoles(editor.mesh().points, normal, curves, ends);
    return std::move(curves.polygons);
}

void setRest(MeshEditor& editor,
             Label cell,
             Label whole,
             const std::vector<LoopPolygon>& polygons) {
    const EditFace before = editor.face(whole);
    editor.removeFace(whole);
    for (const LoopPolygon& polygon : polygons) {
        EditFace part = before;
        part.points.assign(polygon.begin(), polygon.end());
        if (before.owner != cell) std::reverse(part.points.begin(), part.points.end());
        editor.addFace(part);
    }
}

/// Takes the flaps off; false, with nothing changed, when the cells would not close.
bool takeOff(MeshEditor& editor, Label cell, Label whole, const std::vector<Label>& flaps) {
    const MeshEditor::Mark mark = editor.mark();
    const Label beyond = editor.otherCell(whole, cell);
    setRest(editor, cell, whole, restOf(editor, cell, whole, flaps));
    for (const Label f : flaps) {
        if (beyond < 0)
            editor.removeFace(f);
        else
            editor.giveFace(f, cell, beyond);
    }
    std::vector<Label> touched{cell};
    if (beyond >= 0) touched.push_back(beyond);
    if (tidyCells(editor, touched).brokenCells == 0) {
        editor.commit();
        return true;
    }
    editor.undoTo(mark);
    return false;
}

} // namespace

Label removeFlatFlaps(MeshEditor& editor) {
    editor.computeGeometry();
    std::vector<std::uint8_t> isFolded(index(editor.cellCount()), 0);
    parallelFor(editor.cellCount(), [&](Label c) {
        if (editor.isFrozen(c) || editor.cell(c).isRemoved()) return;
        FlapSearch search(editor, c);
        isFolded[index(c)] = std::ranges::any_of(
            editor.cell(c).faces, [&](Label f) { return !search.flapsOn(f).empty(); });
    });
    Label count = 0;
    for (Label c = 0; c < toLabel(isFolded.size()); ++c) {
        if (isFolded[index(c)] == 0 || editor.cell(c).isRemoved()) continue;
        const auto faces = editor.cell(c).faces; // a copy: the list changes
        for (const Label whole : faces) {
            if (editor.face(whole).isRemoved() ||
                std::ranges::find(editor.cell(c).faces, whole) == editor.cell(c).faces.end())
                continue;
            const std::vector<Label> flaps = FlapSearch(editor, c).flapsOn(whole);
            if (!flaps.empty() && takeOff(editor, c, whole, flaps)) count += toLabel(flaps.size());
        }
    }
    return count;
}

} // namespace polymesh
