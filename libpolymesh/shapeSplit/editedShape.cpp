// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/editedShape.h"

#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/shapes/recognise.h"

#include <algorithm>

namespace polymesh {

bool isAcceptable(const MeshEditor& editor, Label cell) {
    FaceGraph graph;
    for (const Label f : editor.cell(cell).faces) {
        const EditFace& face = editor.face(f);
        if (!graph.addFace({face.points.data(), face.points.size()}, face.owner != cell))
            return false;
    }
    return graph.close() && recognise(graph).has_value();
}

bool hasLargeFace(const MeshEditor& editor, Label cell) {
    return std::ranges::any_of(editor.cell(cell).faces, [&](Label f) {
        return editor.face(f).points.size() > maxShapeFacePoints;
    });
}

bool isPositive(MeshEditor& editor, Label cell) {
    constexpr double rounding = 1e-10;
    const double size = editor.cell(cell).size;
    return editor.cellGeometry(cell).volume > rounding * size * size * size;
}

bool areSound(MeshEditor& editor, const MeshEditor::Mark& mark) {
    std::vector<Label> cells = editor.reshapedSince(mark);
    std::erase_if(cells, [&](Label c) { return editor.isFrozen(c); });
    return std::ranges::all_of(cells, [&](Label c) { return isPositive(editor, c); }) &&
           badnessOf(editor, cells).invalid == 0;
}

} // namespace polymesh
