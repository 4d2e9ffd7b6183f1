// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/collapsePoints.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/polygons.h"

#include <algorithm>
#include <cassert>

namespace polymesh {

namespace {

/// The faces that have a point with another representative, ascending.
std::vector<Label> facesToChange(const EditMesh& mesh, std::span<const Label> representative) {
    std::vector<std::uint8_t> change(mesh.faces.size(), 0);
    parallelFor(toLabel(mesh.faces.size()), [&](Label f) {
        const EditFace& face = mesh.faces[index(f)];
        if (face.isRemoved()) return;
        change[index(f)] = std::any_of(face.points.begin(), face.points.end(), [&](Label p) {
            return representative[index(p)] != p;
        });
    });
    std::vector<Label> faces;
    for (std::size_t f = 0; f < change.size(); ++f)
        if (change[f]) faces.push_back(toLabel(f));
    return faces;
}

void sortUnique(std::vector<Label>& labels) {
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
}

} // namespace

void setFaceWalk(MeshEditor& editor, Label f, const Polygon& walk) {
    const EditFace before = editor.face(f);
    const std::vector<Polygon> loops = simpleLoops(walk);
    if (loops.empty()) return editor.removeFace(f);
    editor.setFacePoints(f, loops[0]);
    for (std::size_t i = 1; i < loops.size(); ++i) {
        EditFace part = before;
        part.points = loops[i];
        editor.addFace(part);
    }
}

CollapseCounts tidyCells(MeshEditor& editor, std::vector<Label> cells) {
    CollapseCounts counts;
    std::vector<Label> all;
    while (!cells.empty()) {
        sortUnique(cells);
        all.insert(all.end(), cells.begin(), cells.end());
        std::vector<Label> touched;
        for (const Label c : cells)
            if (!editor.isFrozen(c)) counts.removedFaces += 2 * cancelFlatPairs(editor, c, touched);
        cells = touched;
    }
    sortUnique(all);
    for (const Label c : all) {
        if (editor.isFrozen(c)) continue;
        if (editor.cell(c).isRemoved()) {
            ++counts.removedCells;
            continue;
        }
        if (cellShape(editor.mesh(), c) == CellShape::ball) continue;
        const Label added = separateParts(editor, c);
        counts.addedCells += added;
        for (Label part = editor.cellCount() - added; part < editor.cellCount(); ++part)
            counts.brokenCells += cellShape(editor.mesh(), part) == CellShape::broken;
        counts.brokenCells += cellShape(editor.mesh(), c) == CellShape::broken;
    }
    return counts;
}

CollapseCounts collapsePoints(MeshEditor& editor, std::span<const Label> representative) {
    assert(representative.size() == editor.mesh().points.size());
    CollapseCounts counts;
    std::vector<Label> cells;
    for (const Label f : facesToChange(editor.mesh(), representative)) {
        const EditFace& face = editor.face(f);
        cells.push_back(face.owner);
        if (face.neighbour >= 0) cells.push_back(face.neighbour);
        Polygon walk = face.points;
        for (Label& p : walk)
            p = representative[index(p)];
        setFaceWalk(editor, f, walk);
        counts.removedFaces += editor.face(f).isRemoved();
    }
    const CollapseCounts tidied = tidyCells(editor, std::move(cells));
    counts.removedFaces += tidied.removedFaces;
    counts.removedCells = tidied.removedCells;
    counts.addedCells = tidied.addedCells;
    counts.brokenCells = tidied.brokenCells;
    editor.commit();
    return counts;
}

CollapseCounts collapsePoints(EditMesh& mesh, std::span<const Label> representative) {
    MeshEditor editor(mesh);
    return collapsePoints(editor, representative);
}

} // namespace polymesh
