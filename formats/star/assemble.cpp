// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/assemble.h"

#include <algorithm>

namespace polymesh::star {

namespace {

/// Adds faces of cells to a mesh.
class FaceAdder {
public:
    FaceAdder(const CellRecords& cells, const FacePairs& pairs, PolyMesh& mesh)
        : cells_(cells), pairs_(pairs), mesh_(mesh) {
        const auto internal = static_cast<std::size_t>(
            std::ranges::count_if(pairs.partner, [](Label p) { return p >= 0; }) / 2);
        const std::size_t faceCount = cells.faceTotal() - internal;
        mesh_.neighbour.reserve(internal);
        mesh_.owner.reserve(faceCount);
        mesh_.faces.offsets.reserve(faceCount + 1);
        mesh_.faces.values.reserve(cells.faces.values.size() / cells.faceTotal() * faceCount);
    }

    void addInternal() {
        std::vector<std::pair<Label, Label>> later; // cell behind, face
        for (Label c = 0; c < cells_.count(); ++c) {
            later.clear();
            for (Label f = cells_.firstFaces[index(c)]; f < cells_.firstFaces[index(c) + 1]; ++f) {
                const Label other = pairs_.partner[index(f)];
                const Label behind = other < 0 ? -1 : pairs_.cellOf[index(other)];
                if (behind > c) later.emplace_back(behind, f);
            }
            std::sort(later.begin(), later.end());
            for (const auto& [behind, f] : later) {
                mesh_.neighbour.push_back(behind);
                add(f);
            }
        }
    }

    void add(Label face) {
        mesh_.faces.add(cells_.faces[face]);
        mesh_.owner.push_back(pairs_.cellOf[index(face)]);
    }

private:
    const CellRecords& cells_;
    const FacePairs& pairs_;
    PolyMesh& mesh_;
};

void addBoundary(FaceAdder& adder, PatchFaces boundary, PolyMesh& mesh) {
    std::vector<Label> order(boundary.faces.size());
    for (const Label p : boundary.patchOf)
        ++boundary.patches[index(p)].size;
    std::vector<Label> next;
    Label start = 0;
    for (Patch& patch : boundary.patches) {
        patch.start = mesh.internalFaceCount() + start;
        next.push_back(start);
        start += patch.size;
    }
    for (std::size_t i = 0; i < order.size(); ++i)
        order[index(next[index(boundary.patchOf[i])]++)] = boundary.faces[i];
    for (const Label f : order)
        adder.add(f);
    mesh.patches = std::move(boundary.patches);
}

void dropUnusedPoints(PolyMesh& mesh) {
    std::vector<Label> newLabel(mesh.points.size(), -1);
    for (const Label p : mesh.faces.values)
        newLabel[index(p)] = 0;
    Label count = 0;
    for (std::size_t p = 0; p < mesh.points.size(); ++p) {
        if (newLabel[p] < 0) continue;
        mesh.points[index(count)] = mesh.points[p];
        newLabel[p] = count++;
    }
    if (count == mesh.pointCount()) return;
    mesh.points.resize(index(count));
    for (Label& p : mesh.faces.values)
        p = newLabel[index(p)];
}

} // namespace

PolyMesh assemble(std::vector<Vec3> points,
                  const CellRecords& cells,
                  const FacePairs& pairs,
                  PatchFaces boundary) {
    PolyMesh mesh;
    mesh.points = std::move(points);
    mesh.cellCount = cells.count();
    FaceAdder adder(cells, pairs, mesh);
    adder.addInternal();
    addBoundary(adder, std::move(boundary), mesh);
    dropUnusedPoints(mesh);
    return mesh;
}

} // namespace polymesh::star
