// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/unsuitableFaces.h"

#include "libpolymesh/shapeSplit/editedShape.h"
#include "libpolymesh/shapeSplit/faceCuts.h"
#include "libpolymesh/shapeSplit/faceTriangles.h"
#include "libpolymesh/shapeSplit/fillWithTetrahedra.h"
#include "libpolymesh/shapes/baseShapes.h"

#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace polymesh {

namespace {

bool putTriangles(MeshEditor& editor, Label f) {
    const std::vector<FaceTriangles> ways = trianglesKeepingVolume(editor, f);
    if (ways.empty() || ways.front().isTurned) return false;
    replaceByTriangles(editor, f, ways.front());
    return true;
}

/// Parts of a face round its middle; each has two points more than edges of the face.
std::size_t partsOf(std::size_t points) {
    return (points + 3) / 4;
}

/// Of ways to cut a boundary face that is folded, seen against its normal, the one after which the
/// fewest faces of the cell cross.
bool cutFoldedFace(MeshEditor& editor, Label f) {
    const std::size_t size = editor.face(f).points.size();
    constexpr std::size_t most = 8;
    std::vector<std::function<bool()>> ways;
    for (FaceTriangles& triangles : trianglesKeepingVolume(editor, f)) {
        if (ways.size() == most) break;
        ways.emplace_back([&editor, f, triangles = std::move(triangles)] {
            replaceByTriangles(editor, f, triangles);
            return true;
        });
    }
    ways.emplace_back([&] { return cutFromMiddle(editor, f, partsOf(size), Parts::any); });
    ways.emplace_back([&] { return cutFromMiddle(editor, f, size, Parts::any); });
    const MeshEditor::Mark mark = editor.mark();
    std::optional<std::size_t> best;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const std::size_t left =
            ways[i]() ? facesInTheWay(editor, editor.face(f).owner).size() : fewest;
        editor.undoTo(mark);
        if (left >= fewest) continue;
        best = i;
        fewest = left;
    }
    return best && ways[*best]();
}

bool cutLargeFace(MeshEditor& editor, Label f) {
    const std::size_t size = editor.face(f).points.size();
    if (!editor.face(f).isBoundary() || isPlane(editor, f))
        return cutByChords(editor, f, maxShapeFacePoints);
    return cutFromMiddle(editor, f, partsOf(size)) ||
           cutByChordsKeepingVolume(editor, f, maxShapeFacePoints) ||
           cutFromMiddle(editor, f, size) || cutFoldedFace(editor, f);
}

bool cutConcaveFace(MeshEditor& editor, Label f) {
    if (editor.face(f).isBoundary() && !isPlane(editor, f)) return putTriangles(editor, f);
    return cutByChords(editor, f, editor.face(f).points.size() - 1);
}

/// Cuts the faces of a cell that are to be cut, where it stays sound.
template<class IsToBeCut, class CutFace>
Label cutFaces(MeshEditor& editor, Label cell, const IsToBeCut& isToBeCut, const CutFace& cutFace) {
    Label count = 0;
    const auto faces = editor.cell(cell).faces; // a copy: cutting changes the list
    for (const Label f : faces) {
        if (!isToBeCut(f)) continue;
        const MeshEditor::Mark mark = editor.mark();
        if (cutFace(f) && areSound(editor, mark))
            ++count;
        else
            editor.undoTo(mark);
    }
    return count;
}

} // namespace

Label cutLargeFaces(MeshEditor& editor, Label cell) {
    return cutFaces(
        editor,
        cell,
        [&](Label f) { return editor.face(f).points.size() > maxShapeFacePoints; },
        [&](Label f) { return cutLargeFace(editor, f); });
}

Label cutConcaveFaces(MeshEditor& editor, Label cell) {
    if (isAcceptable(editor, cell)) return 0;
    return cutFaces(
        editor,
        cell,
        [&](Label f) {
            const Label other = editor.otherCell(f, cell);
            const bool isOthers =
                other >= 0 && (editor.isFrozen(other) || isAcceptable(editor, other));
            return !isOthers && !isStarShaped(editor, f);
        },
        [&](Label f) { return cutConcaveFace(editor, f); });
}

} // namespace polymesh
