// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/components.h"

#include <array>

namespace polymesh {

namespace {

struct Neighbour {
    Label triangle = -1; // -1: none, or not exactly one
    bool isAgainst = false;
};

using Neighbours = std::vector<std::array<Neighbour, 3>>; // across each side of each triangle

Neighbours findNeighbours(const TriSurface& surface, const Rows<SurfaceEdgeUse>& uses) {
    Neighbours neighbours(surface.triangles.size());
    const auto set = [&](const SurfaceEdgeUse& use, const SurfaceEdgeUse& other) {
        neighbours[index(use.triangle)][static_cast<std::size_t>(use.corner)] = {
            other.triangle, use.ascending == other.ascending};
    };
    for (Label lower = 0; lower < uses.size(); ++lower) {
        forEachEdge(uses[lower], [&](std::span<const SurfaceEdgeUse> edge) {
            if (edge.size() != 2) return;
            set(edge[0], edge[1]);
            set(edge[1], edge[0]);
        });
    }
    return neighbours;
}

/// Adds the component of `seed`, which belongs to none yet.
void addComponent(const Neighbours& neighbours, Label seed, Components& components) {
    const Label component = components.count++;
    components.isOrientable.push_back(1);
    components.ofTriangle[index(seed)] = component;
    std::vector<Label> front{seed};
    while (!front.empty()) {
        const Label t = front.back();
        front.pop_back();
        for (const Neighbour& side : neighbours[index(t)]) {
            if (side.triangle < 0) continue;
            const bool against = (components.isAgainst[index(t)] != 0) != side.isAgainst;
            char& isAgainst = components.isAgainst[index(side.triangle)];
            if (components.ofTriangle[index(side.triangle)] < 0) {
                components.ofTriangle[index(side.triangle)] = component;
                isAgainst = against ? 1 : 0;
                front.push_back(side.triangle);
            } else if ((isAgainst != 0) != against) {
                components.isOrientable[index(component)] = 0;
            }
        }
    }
}

} // namespace

Components findComponents(const TriSurface& surface, const Rows<SurfaceEdgeUse>& uses) {
    const Neighbours neighbours = findNeighbours(surface, uses);
    Components components;
    components.ofTriangle.assign(surface.triangles.size(), -1);
    components.isAgainst.assign(surface.triangles.size(), 0);
    for (Label t = 0; t < surface.triangleCount(); ++t)
        if (components.ofTriangle[index(t)] < 0) addComponent(neighbours, t, components);
    return components;
}

} // namespace polymesh
