// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/looseFaces.h"

#include <algorithm>
#include <utility>

namespace polymesh {

std::vector<LooseFace> internalFaces(const PolyMesh& mesh) {
    std::vector<LooseFace> loose;
    loose.reserve(mesh.neighbour.size());
    for (Label face = 0; face < mesh.internalFaceCount(); ++face)
        loose.push_back({mesh.owner[index(face)],
                         mesh.neighbour[index(face)],
                         {mesh.faces[face].begin(), mesh.faces[face].end()},
                         face});
    return loose;
}

void setInternalFaces(PolyMesh& mesh, std::vector<LooseFace>& loose) {
    std::ranges::stable_sort(
        loose, {}, [](const LooseFace& f) { return std::pair(f.owner, f.neighbour); });
    const Label oldInternal = mesh.internalFaceCount();
    const Label shift = toLabel(loose.size()) - oldInternal;
    std::vector<Label> place(index(mesh.faceCount()), -1);
    std::vector<char> isTurned(index(mesh.faceCount()), 0);
    Rows<Label> faces;
    std::vector<Label> owner;
    mesh.neighbour.clear();
    for (const LooseFace& f : loose) {
        if (f.source >= 0) {
            place[index(f.source)] = faces.size();
            isTurned[index(f.source)] = f.isTurned ? 1 : 0;
        }
        faces.add(f.loop);
        owner.push_back(f.owner);
        mesh.neighbour.push_back(f.neighbour);
    }
    for (Label face = oldInternal; face < mesh.faceCount(); ++face) {
        place[index(face)] = face + shift;
        faces.add(std::as_const(mesh.faces)[face]);
        owner.push_back(mesh.owner[index(face)]);
    }
    mesh.faces = std::move(faces);
    mesh.owner = std::move(owner);
    for (Patch& patch : mesh.patches)
        patch.start += shift;
    for (Zone& zone : mesh.faceZones) {
        std::vector<std::pair<Label, bool>> sorted;
        for (std::size_t i = 0; i < zone.labels.size(); ++i)
            if (place[index(zone.labels[i])] >= 0)
                sorted.emplace_back(place[index(zone.labels[i])],
                                    (i < zone.flip.size() && zone.flip[i]) !=
                                        (isTurned[index(zone.labels[i])] != 0));
        std::ranges::sort(sorted);
        zone.labels.resize(sorted.size());
        zone.flip.resize(sorted.size());
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            zone.labels[i] = sorted[i].first;
            zone.flip[i] = sorted[i].second;
        }
    }
}

} // namespace polymesh
