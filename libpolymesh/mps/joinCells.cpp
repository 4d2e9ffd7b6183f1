// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/joinCells.h"

#include "libpolymesh/mps/looseFaces.h"

#include <algorithm>

namespace polymesh {

namespace {

/// New labels of all cells.
std::vector<Label> newLabels(Label cellCount, std::span<const std::pair<Label, Label>> pairs) {
    std::vector<Label> joinedTo(index(cellCount), -1);
    for (const auto& [a, b] : pairs)
        joinedTo[index(std::max(a, b))] = std::min(a, b);
    std::vector<Label> label(index(cellCount));
    Label next = 0;
    for (Label cell = 0; cell < cellCount; ++cell) {
        const Label other = joinedTo[index(cell)];
        label[index(cell)] = other < 0 ? next++ : label[index(other)];
    }
    return label;
}

} // namespace

PolyMesh withJoinedCells(PolyMesh mesh, std::span<const std::pair<Label, Label>> pairs) {
    if (pairs.empty()) return mesh;
    const std::vector<Label> label = newLabels(mesh.cellCount, pairs);
    std::vector<LooseFace> loose = internalFaces(mesh);
    for (LooseFace& f : loose) {
        f.owner = label[index(f.owner)];
        f.neighbour = label[index(f.neighbour)];
        if (f.owner < f.neighbour) continue;
        std::swap(f.owner, f.neighbour);
        std::ranges::reverse(f.loop);
        f.isTurned = true;
    }
    std::erase_if(loose, [](const LooseFace& f) { return f.owner == f.neighbour; });
    for (Label& owner : mesh.owner)
        owner = label[index(owner)];
    setInternalFaces(mesh, loose);
    mesh.cellCount -= toLabel(pairs.size());
    for (Zone& zone : mesh.cellZones) {
        for (Label& cell : zone.labels)
            cell = label[index(cell)];
        std::ranges::sort(zone.labels);
        zone.labels.erase(std::unique(zone.labels.begin(), zone.labels.end()), zone.labels.end());
    }
    return mesh;
}

} // namespace polymesh
