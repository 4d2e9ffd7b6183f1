// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/splitTogether.h"

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/starPoint.h"
#include "libpolymesh/shapeSplit/editedShape.h"
#include "libpolymesh/shapeSplit/innerPoint.h"

#include <algorithm>
#include <vector>

namespace polymesh {

namespace {

/// Removes the faces between two cells and gives those of `other` to `cell`.
void unite(MeshEditor& editor, Label cell, Label other) {
    const auto faces = editor.cell(other).faces; // a copy: giving faces away changes the list
    for (const Label f : faces)
        if (editor.otherCell(f, other) == cell)
            editor.removeFace(f);
        else
            editor.giveFace(f, other, cell);
}

/// Gives all faces of a cell to one that has none.
void rename(MeshEditor& editor, Label from, Label to) {
    const auto faces = editor.cell(from).faces; // a copy: giving faces away changes the list
    for (const Label f : faces)
        editor.giveFace(f, from, to);
}

/// True when a point below `firstNewPoint` that the cells share is used by them alone, on the faces
/// between them: it would be left without a face.
bool hasPointBetween(const MeshEditor& editor, Label cell, Label other, Label firstNewPoint) {
    for (const Label f : editor.cell(cell).faces) {
        if (editor.otherCell(f, cell) != other) continue;
        for (const Label p : editor.face(f).points)
            if (p < firstNewPoint && std::ranges::all_of(editor.facesOfPoint(p), [&](Label g) {
                    const EditFace& face = editor.face(g);
                    return std::minmax(face.owner, face.neighbour) == std::minmax(cell, other);
                }))
                return true;
    }
    return false;
}

} // namespace

bool uniteCells(MeshEditor& editor,
                Label cell,
                std::span<const Label> others,
                Label firstNewPoint) {
    const MeshEditor::Mark mark = editor.mark();
    for (const Label other : others) {
        if (hasPointBetween(editor, cell, other, firstNewPoint)) {
            editor.undoTo(mark);
            return false;
        }
        unite(editor, cell, other);
    }
    if (cellShape(editor.mesh(), cell) == CellShape::ball) return true;
    editor.undoTo(mark);
    return false;
}

void nameAfterCells(MeshEditor& editor,
                    std::span<const Label> pieces,
                    std::span<const Label> others) {
    for (std::size_t k = 0; k < others.size(); ++k)
        rename(editor, pieces[pieces.size() - 1 - k], others[k]);
}

bool splitTogether(MeshEditor& editor, Label cell, std::span<const Label> others, bool mayFold) {
    const MeshEditor::Mark mark = editor.mark();
    if (!uniteCells(editor, cell, others)) return false;
    if (!hasLargeFace(editor, cell)) {
        auto apex = innerPoint(editor, cell);
        if (!apex && mayFold) apex = pointBehindFaces(editor, cell);
        if (apex) {
            nameAfterCells(editor, makePyramids(editor, cell, *apex), others);
            return true;
        }
    }
    editor.undoTo(mark);
    return false;
}

std::optional<Filled> fillTogether(MeshEditor& editor,
                                   Label cell,
                                   std::span<const Label> others,
                                   const Tetrahedraliser& tetrahedralise) {
    const MeshEditor::Mark mark = editor.mark();
    if (!uniteCells(editor, cell, others)) return std::nullopt;
    Filled filled = fillWithTetrahedra(editor, cell, tetrahedralise);
    if (filled.pieces.size() > others.size()) {
        nameAfterCells(editor, filled.pieces, others);
    } else {
        filled.pieces.clear();
        editor.undoTo(mark);
    }
    return filled;
}

} // namespace polymesh
