// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/validateEdit.h"

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/polygons.h"

#include <fmt/format.h>

#include <algorithm>

namespace polymesh {

namespace {

bool lists(const EditMesh& mesh, Label cell, Label face) {
    const auto& faces = mesh.cells[index(cell)].faces;
    return std::count(faces.begin(), faces.end(), face) == 1;
}

void checkFace(const EditMesh& mesh, Label f, std::vector<std::string>& defects) {
    const EditFace& face = mesh.faces[index(f)];
    if (face.points.size() < 3) defects.push_back(fmt::format("face {}: fewer than 3 points", f));
    for (const Label p : face.points)
        if (std::count(face.points.begin(), face.points.end(), p) != 1)
            defects.push_back(fmt::format("face {}: lists point {} twice", f, p));
    if (face.isBoundary() != (face.patch >= 0))
        defects.push_back(fmt::format(
            "face {}: neighbour {} does not go with patch {}", f, face.neighbour, face.patch));
    if (face.owner == face.neighbour)
        defects.push_back(fmt::format("face {}: cell {} on both sides", f, face.owner));
    for (const Label c : {face.owner, face.neighbour}) {
        if (c < 0) continue;
        if (!lists(mesh, c, f)) defects.push_back(fmt::format("face {}: not in cell {}", f, c));
        if (!mesh.cells[index(c)].frozen) continue;
        for (const Label p : face.points)
            if (mesh.ranks[index(p)] != PointRank::fixed)
                defects.push_back(fmt::format("point {}: of a frozen cell but not fixed", p));
    }
}

void checkCell(const EditMesh& mesh, Label c, std::vector<std::string>& defects) {
    const EditCell& cell = mesh.cells[index(c)];
    for (const Label f : cell.faces) {
        const EditFace& face = mesh.faces[index(f)];
        if (face.isRemoved() || (face.owner != c && face.neighbour != c))
            defects.push_back(fmt::format("cell {}: lists face {}, which is not its own", c, f));
    }
    if (cell.frozen) return;
    if (cell.faces.size() < 4) defects.push_back(fmt::format("cell {}: fewer than 4 faces", c));
    if (cellShape(mesh, c) == CellShape::broken)
        defects.push_back(fmt::format("cell {}: its faces do not close it", c));
    std::vector<Polygon> sorted;
    for (const Label f : cell.faces) {
        sorted.push_back(mesh.faces[index(f)].points);
        std::sort(sorted.back().begin(), sorted.back().end());
    }
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
        defects.push_back(fmt::format("cell {}: two faces with the same points", c));
}

} // namespace

std::vector<std::string> validateEdit(const EditMesh& mesh) {
    std::vector<std::string> defects;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        if (!mesh.faces[f].isRemoved()) checkFace(mesh, toLabel(f), defects);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        if (!mesh.cells[c].isRemoved()) checkCell(mesh, toLabel(c), defects);
    return defects;
}

} // namespace polymesh
