// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/separatePinches.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/quality/cellTopology.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace polymesh {

namespace {

using Fan = std::vector<Label>; // faces round an edge

/// The uses of one edge by a cell.
std::vector<EdgeUse> usesOf(const MeshEditor& editor, Label cell, const EdgeUse& edge) {
    std::vector<EdgeUse> uses;
    collectEdgeUses(editor.mesh(), cell, uses);
    std::erase_if(uses,
                  [&](const EdgeUse& use) { return use.low != edge.low || use.high != edge.high; });
    return uses;
}

/// The face across the edge from a face of a cell, within the cell; -1 when there is none.
Label partnerOf(MeshEditor& editor, Label cell, Label face, const EdgeUse& edge) {
    const std::vector<EdgeUse> uses = usesOf(editor, cell, edge);
    if (uses.size() == 2) return uses[uses[0].face == face ? 1 : 0].face;
    for (const auto& [a, b] : wedgesRound(editor, cell, uses))
        if (a == face || b == face) return a == face ? b : a;
    return -1;
}

/// Adds the faces beyond `face`, which leaves `cell`, as far as internal faces go on. False where
/// they come back to that cell or to a frozen one.
bool follow(MeshEditor& editor, Label cell, Label face, const EdgeUse& edge, Fan& fan) {
    Label here = cell;
    while (true) {
        here = editor.otherCell(face, here);
        if (here < 0) return true;
        if (here == cell || editor.isFrozen(here)) return false;
        face = partnerOf(editor, here, face, edge);
        if (face < 0 || std::ranges::find(fan, face) != fan.end()) return false;
        fan.push_back(face);
    }
}

/// All faces that a wedge hangs together with round its edge, from boundary to boundary.
std::optional<Fan>
fanOf(MeshEditor& editor, Label cell, const std::array<Label, 2>& wedge, const EdgeUse& edge) {
    Fan fan(wedge.begin(), wedge.end());
    for (const Label face : wedge)
        if (!follow(editor, cell, face, edge, fan)) return std::nullopt;
    return fan;
}

void putIntoEdge(MeshEditor& editor, Label face, const EdgeUse& edge, Label point) {
    const Polygon& old = editor.face(face).points;
    Polygon points;
    for (std::size_t i = 0; i < old.size(); ++i) {
        points.push_back(old[i]);
        if (std::minmax(old[i], old[(i + 1) % old.size()]) ==
            std::pair<const Label&, const Label&>(edge.low, edge.high))
            points.push_back(point);
    }
    editor.setFacePoints(face, points);
}

/// Separates the wedges of a cell at one edge.
void separateAt(MeshEditor& editor, Label cell, std::span<const EdgeUse> uses) {
    const EdgeUse edge = uses[0];
    const Wedges wedges = wedgesRound(editor, cell, uses);
    for (std::size_t w = 1; w < wedges.size(); ++w) {
        const auto fan = fanOf(editor, cell, wedges[w], edge);
        if (!fan) continue;
        const Vec3 middle = 0.5 * (editor.point(edge.low) + editor.point(edge.high));
        const Label point = editor.addPoint(middle, PointRank::corner);
        for (const Label face : *fan)
            putIntoEdge(editor, face, edge, point);
    }
}

void separateWedges(MeshEditor& editor, Label cell) {
    std::vector<EdgeUse> uses;
    collectEdgeUses(editor.mesh(), cell, uses);
    for (auto first = uses.begin(); first != uses.end();) {
        const auto last = std::find_if(first, uses.end(), [&](const EdgeUse& use) {
            return use.low != first->low || use.high != first->high;
        });
        if (last - first > 2) separateAt(editor, cell, {first, last});
        first = last;
    }
}

std::vector<Label> brokenCells(const EditMesh& mesh) {
    std::vector<std::uint8_t> isBroken(mesh.cells.size(), 0);
    parallelFor(toLabel(mesh.cells.size()), [&](Label c) {
        const EditCell& cell = mesh.cells[index(c)];
        if (cell.frozen || cell.isRemoved()) return;
        isBroken[index(c)] = cellShape(mesh, c) == CellShape::broken ? 1 : 0;
    });
    std::vector<Label> cells;
    for (std::size_t c = 0; c < isBroken.size(); ++c)
        if (isBroken[c] != 0) cells.push_back(toLabel(c));
    return cells;
}

} // namespace

Label separatePinches(MeshEditor& editor) {
    Label left = 0;
    for (const Label c : brokenCells(editor.mesh())) {
        separateWedges(editor, c);
        left += cellShape(editor.mesh(), c) == CellShape::broken ? 1 : 0;
    }
    return left;
}

} // namespace polymesh
