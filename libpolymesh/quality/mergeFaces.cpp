// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/mergeFaces.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/polygons.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polymesh {

namespace {

// Constructed points lie in the plane that they should be in up to some rounding errors of their
// coordinates; relative to the size of a cell in a box of thousands of cells that is this much.
constexpr double roundOff = 1e-10;

Polygon outwardPolygon(const EditFace& face, Label cell) {
    Polygon polygon = face.points;
    if (face.owner != cell) std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

// Every merge judges its cell, so that cells with very many faces (a cell that holds thousands of
// triangles, kept one by one) would take quadratic time; they stay as they are.
constexpr std::size_t manyFaces = 64;

/// True when the cell has two faces that might be merged: a cheap test that reads only labels.
bool hasRepeatedInterface(const MeshEditor& editor, Label c) {
    const auto& faces = editor.cell(c).faces;
    if (faces.size() > manyFaces) return false;
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = i + 1; j < faces.size(); ++j)
            if (isSameInterface(editor, faces[i], faces[j], c)) return true;
    return false;
}

bool tryUnite(MeshEditor& editor, Label f, Label g, Label c) {
    const Label other = editor.otherCell(f, c);
    const std::array<Label, 2> cells{c, other < 0 ? c : other};
    const std::vector<Label> region = withNeighbours(editor, cells);
    const Badness before = badnessOf(editor, region);
    const MeshEditor::Mark mark = editor.mark();
    const Polygon ends = editor.face(g).points;
    bool done = uniteFaces(editor, f, g, c);
    if (done)
        for (const Label p : ends)
            dropRedundantPoint(editor, p);
    done = done && allBalls(editor, cells) && isNoWorse(badnessOf(editor, region), before);
    if (!done) editor.undoTo(mark);
    return done;
}

/// Merges what can be merged in one cell, the first pair first.
Label mergeFacesOfCell(MeshEditor& editor, Label c, double angle) {
    Label merged = 0;
    for (std::size_t i = 0; i < editor.cell(c).faces.size(); ++i)
        for (std::size_t j = 0; j < editor.cell(c).faces.size(); ++j) {
            const auto& faces = editor.cell(c).faces;
            if (i == j || i >= faces.size()) continue;
            const Label f = faces[i];
            const Label g = faces[j];
            if (!isSameInterface(editor, f, g, c) || !isCoplanar(editor, f, g, c, angle)) continue;
            if (unitedPolygon(editor.face(f).points, editor.face(g).points).empty()) continue;
            if (!tryUnite(editor, f, g, c)) continue;
            ++merged;
            i = 0;
            j = 0;
        }
    return merged;
}

} // namespace

bool isSameInterface(const MeshEditor& editor, Label f, Label g, Label cell) {
    return editor.otherCell(f, cell) == editor.otherCell(g, cell) &&
           editor.face(f).patch == editor.face(g).patch;
}

bool isCoplanar(MeshEditor& editor, Label f, Label g, Label cell, double angle) {
    const bool sameSide = (editor.face(f).owner == cell) == (editor.face(g).owner == cell);
    const FaceGeometry a = editor.faceGeometry(f);
    const FaceGeometry b = editor.faceGeometry(g);
    const double product = norm(a.area) * norm(b.area);
    if (product <= 0) return false;
    const double cosine = (sameSide ? 1.0 : -1.0) * dot(a.area, b.area) / product;
    if (angle > 0) return cosine >= std::cos(angle);
    const Vec3 normal = a.area / norm(a.area);
    const double tolerance = roundOff * editor.cell(cell).size;
    const auto isInPlane = [&](Label p) {
        return std::abs(dot(normal, editor.point(p) - a.centre)) <= tolerance;
    };
    const auto& fPoints = editor.face(f).points;
    const auto& gPoints = editor.face(g).points;
    return cosine > 0 && std::all_of(fPoints.begin(), fPoints.end(), isInPlane) &&
           std::all_of(gPoints.begin(), gPoints.end(), isInPlane);
}

bool uniteFaces(MeshEditor& editor, Label f, Label g, Label cell) {
    if (editor.isFrozenFace(f) || editor.isFrozenFace(g)) return false;
    EditFace value = editor.face(f);
    value.points = unitedPolygon(outwardPolygon(value, cell), outwardPolygon(editor.face(g), cell));
    if (value.points.empty()) return false;
    if (value.owner != cell) std::reverse(value.points.begin(), value.points.end());
    editor.removeFace(g);
    editor.replaceFace(f, value);
    return true;
}

bool dropRedundantPoint(MeshEditor& editor, Label p) {
    const PointRank rank = editor.rank(p);
    if (rank == PointRank::fixed || rank == PointRank::corner) return false;
    const std::vector<Label> faces(editor.facesOfPoint(p).begin(), editor.facesOfPoint(p).end());
    if (faces.empty()) return false;
    const Label a = cornerBefore(editor.face(faces[0]).points, p);
    const Label b = cornerAfter(editor.face(faces[0]).points, p);
    for (const Label f : faces) {
        const Polygon& polygon = editor.face(f).points;
        if (polygon.size() < 4 || !hasEdge(polygon, p, a) || !hasEdge(polygon, p, b)) return false;
        if (editor.isFrozenFace(f)) return false;
    }
    for (const Label f : editor.facesOfPoint(a))
        if (hasEdge(editor.face(f).points, a, b)) return false;
    const Vec3 toA = editor.point(a) - editor.point(p);
    const Vec3 toB = editor.point(b) - editor.point(p);
    const double offLine = distanceFromLine(editor.point(p), editor.point(a), editor.point(b));
    if (dot(toA, toB) >= 0 || offLine > roundOff * editor.cell(editor.face(faces[0]).owner).size)
        return false;
    for (const Label f : faces) {
        Polygon polygon = editor.face(f).points;
        polygon.erase(std::find(polygon.begin(), polygon.end(), p));
        editor.setFacePoints(f, polygon);
    }
    return true;
}

Label mergeFaces(MeshEditor& editor, double angle) {
    std::vector<std::uint8_t> candidate(index(editor.cellCount()), 0);
    parallelFor(editor.cellCount(), [&](Label c) {
        candidate[index(c)] = !editor.isFrozen(c) && hasRepeatedInterface(editor, c);
    });
    Label merged = 0;
    for (std::size_t c = 0; c < candidate.size(); ++c) {
        if (!candidate[c]) continue;
        merged += mergeFacesOfCell(editor, toLabel(c), angle);
        editor.commit();
    }
    return merged;
}

} // namespace polymesh
