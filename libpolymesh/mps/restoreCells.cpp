// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/restoreCells.h"

#include "libpolymesh/mps/cellLoops.h"

#include <algorithm>
#include <map>
#include <set>

namespace polymesh {

namespace {

/// The faces of some cells that are not between two of them, seen from outside.
std::vector<Polygon>
outsideOf(const PolyMesh& mesh, const Rows<Label>& cellFaces, std::span<const Label> cells) {
    const auto isOne = [&](Label cell) { return std::ranges::find(cells, cell) != cells.end(); };
    std::vector<Polygon> loops;
    for (const Label cell : cells)
        for (const Label face : cellFaces[cell]) {
            const bool isOwned = mesh.owner[index(face)] == cell;
            if (mesh.isInternal(face) &&
                isOne(isOwned ? mesh.neighbour[index(face)] : mesh.owner[index(face)]))
                continue;
            loops.emplace_back(mesh.faces[face].begin(), mesh.faces[face].end());
            if (!isOwned) std::ranges::reverse(loops.back());
        }
    return loops;
}

/// The origins of cells and of those beside their pieces.
std::set<Label> originsRound(const EditedMesh& edited, std::span<const Label> cells) {
    const PolyMesh& mesh = edited.mesh;
    std::set<Label> inner;
    for (const Label cell : cells)
        inner.insert(edited.cellFrom[index(cell)]);
    std::set<Label> origins = inner;
    for (Label face = 0; face < mesh.internalFaceCount(); ++face) {
        const Label a = edited.cellFrom[index(mesh.owner[index(face)])];
        const Label b = edited.cellFrom[index(mesh.neighbour[index(face)])];
        if (inner.contains(a)) origins.insert(b);
        if (inner.contains(b)) origins.insert(a);
    }
    return origins;
}

} // namespace

std::vector<std::pair<Label, Label>>
piecesRound(const EditedMesh& edited, const Rows<Label>& cellFaces, std::span<const Label> cells) {
    const std::set<Label> origins = originsRound(edited, cells);
    std::map<Label, std::vector<Label>> pieces; // by origin
    for (Label cell = 0; cell < edited.mesh.cellCount; ++cell)
        if (const Label origin = edited.cellFrom[index(cell)]; origins.contains(origin))
            pieces[origin].push_back(cell);
    std::vector<std::pair<Label, Label>> pairs;
    for (const auto& [origin, own] : pieces) {
        if (!isClosed(outsideOf(edited.mesh, cellFaces, own))) continue;
        for (std::size_t i = 1; i < own.size(); ++i)
            pairs.emplace_back(own[0], own[i]);
    }
    return pairs;
}

void dropUnusedPoints(EditedMesh& edited) {
    PolyMesh& mesh = edited.mesh;
    std::vector<Label> number(index(mesh.pointCount()), -1);
    for (const Label p : mesh.faces.values)
        number[index(p)] = 0;
    Label count = 0;
    for (std::size_t p = 0; p < number.size(); ++p) {
        if (number[p] < 0) continue;
        mesh.points[index(count)] = mesh.points[p];
        number[p] = count++;
    }
    if (count == mesh.pointCount()) return;
    mesh.points.resize(index(count));
    for (Label& p : mesh.faces.values)
        p = number[index(p)];
    for (Zone& zone : mesh.pointZones) {
        for (Label& p : zone.labels)
            p = number[index(p)];
        std::erase(zone.labels, -1);
    }
    // The order stays, so that bends are still ascending.
    for (Bend& bend : edited.bends)
        for (Label& p : bend.ends)
            p = number[index(p)];
    std::erase_if(edited.bends, [](const Bend& b) { return b.ends[0] < 0 || b.ends[1] < 0; });
}

} // namespace polymesh
