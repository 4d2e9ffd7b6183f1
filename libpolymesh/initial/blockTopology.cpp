// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/blockTopology.h"

#include "libpolymesh/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace polymesh {
namespace {

using Vertices = std::array<Label, 4>;

/// The different vertices of a side, ascending: sides with the same are one.
using SideKey = std::vector<Label>;

SideKey keyOf(const Vertices& vertices) {
    SideKey key(vertices.begin(), vertices.end());
    std::ranges::sort(key);
    key.erase(std::unique(key.begin(), key.end()), key.end());
    return key;
}

std::string shown(const Vertices& vertices) {
    return fmt::format("({})", fmt::join(vertices, " "));
}

/// The vertices at (u, v) = (0, 0), (1, 0), (1, 1), (0, 1).
Vertices cornerVertices(const Block& block, std::size_t side) {
    Vertices result{};
    const std::array<std::size_t, 4> corners = sideCorners(side);
    for (std::size_t c = 0; c < 4; ++c)
        result[c] = block.vertices[corners[c]];
    return result;
}

struct SideUse {
    std::array<BoundarySide, 2> blocks;
    int count = 0;
    Label patch = -1;
};

using SideUses = std::map<SideKey, SideUse>;

SideUses sideUses(const std::vector<Block>& blocks) {
    SideUses uses;
    for (Label b = 0; b < toLabel(blocks.size()); ++b) {
        const Block& block = blocks[index(b)];
        for (std::size_t side = 0; side < 6; ++side) {
            const Vertices vertices = cornerVertices(block, side);
            const SideKey key = keyOf(vertices);
            SideUse& use = uses[key];
            require(use.count < 2 || key.size() < 3,
                    "{}: side {} of this block is also a side of the blocks at {} and {}; only two "
                    "can meet, so leave one out or give it other vertices",
                    block.where,
                    shown(vertices),
                    blocks[index(use.blocks[0].block)].where,
                    blocks[index(use.blocks[1].block)].where);
            if (use.count < 2) use.blocks[static_cast<std::size_t>(use.count++)] = {b, side};
        }
    }
    return uses;
}

/// A side as two blocks walk over it, with its vertices in the order of the second.
struct Walks {
    std::array<SideGrid, 2> grids;
    Vertices vertices;

    void swap() {
        for (SideGrid& grid : grids)
            grid = grid.swapped();
        std::swap(vertices[1], vertices[3]);
    }

    /// u from the other end, then u and v exchanged.
    void turn() {
        for (SideGrid& grid : grids)
            grid = grid.flippedU().swapped();
        vertices = {vertices[1], vertices[2], vertices[3], vertices[0]};
    }
};

/// Turns and mirrors both walks until `isFound(walks)`. False when it never is.
template<class IsFound>
bool align(Walks& walks, IsFound&& isFound) {
    for (int turn = 0; turn < 4; ++turn) {
        for (int mirror = 0; mirror < 2; ++mirror) {
            if (isFound(walks)) return true;
            walks.swap();
        }
        walks.turn();
    }
    return false;
}

SharedSide sharedSide(const std::vector<Block>& blocks, const SideUse& use) {
    const auto [a, b] = use.blocks;
    const Block& first = blocks[index(a.block)];
    const Block& second = blocks[index(b.block)];
    const SideGrid grid = sideGrid({first.cells}, a.side);
    const SideGrid other = sideGrid({second.cells}, b.side);
    const Vertices vertices = cornerVertices(first, a.side);
    Walks walks{{other, other}, cornerVertices(second, b.side)};
    const bool found = align(walks, [&](const Walks& w) {
        return w.vertices == vertices && w.grids[1].counts == grid.counts;
    });
    require(found,
            "{}: side {} of this block has {} cells, but on the block at {} it has {}; give both "
            "the same",
            second.where,
            shown(vertices),
            fmt::join(other.counts, " x "),
            first.where,
            fmt::join(grid.counts, " x "));
    SharedSide shared{{a.block, b.block}, {a.side, b.side}, {grid, walks.grids[1]}, {}};
    walks.grids[0] = grid;
    align(walks, [&](const Walks& w) { return w.grids[1] == other; });
    shared.firstSeenFromSecond = walks.grids[0];
    return shared;
}

/// Enters that a side belongs to a patch.
void assign(const BlockMeshDescription& description,
            Label patch,
            const BlockSide& side,
            SideUses& uses) {
    const SideKey key = keyOf(side.vertices);
    const std::string& name = description.patches[index(patch)].patch.name;
    const auto found = uses.find(key);
    if (key.size() < 3) { // such as the axis of a wedge: without faces
        if (found != uses.end()) found->second.patch = patch;
        return;
    }
    require(found != uses.end(),
            "{}: patch {}: {} is no side of a block; give the four vertices of a side",
            side.where,
            name,
            shown(side.vertices));
    require(found->second.count != 2,
            "{}: patch {}: side {} lies between two blocks, so it can not be on the boundary; "
            "leave it out",
            side.where,
            name,
            shown(side.vertices));
    require(found->second.patch < 0 || found->second.patch == patch,
            "{}: patch {}: side {} belongs to patch {} already; leave it out of one of them",
            side.where,
            name,
            shown(side.vertices),
            description.patches[index(std::max(found->second.patch, Label{0}))].patch.name);
    found->second.patch = patch;
}

/// Enters the sides of the patches; those that are in, count 0.
void addPatchSides(const BlockMeshDescription& description,
                   SideUses& uses,
                   BlockTopology& topology) {
    for (Label p = 0; p < toLabel(description.patches.size()); ++p)
        for (const BlockSide& side : description.patches[index(p)].sides) {
            assign(description, p, side, uses);
            const SideKey key = keyOf(side.vertices);
            const auto found = uses.find(key);
            if (key.size() < 3 || found->second.count == 0) continue;
            topology.patches[index(p)].push_back(found->second.blocks[0]);
            found->second.count = 0; // named twice, it still counts once
        }
}

} // namespace

BlockTopology blockTopology(const BlockMeshDescription& description) {
    const std::vector<Block>& blocks = description.blocks;
    SideUses uses = sideUses(blocks);
    BlockTopology topology;
    topology.patches.resize(description.patches.size() + 1);
    addPatchSides(description, uses, topology);
    // In the order of the blocks, which the map does not have.
    for (Label b = 0; b < toLabel(blocks.size()); ++b)
        for (std::size_t side = 0; side < 6; ++side) {
            const SideKey key = keyOf(cornerVertices(blocks[index(b)], side));
            SideUse& use = uses.at(key);
            if (use.count == 1 && use.patch < 0) topology.hasDefaultPatch = true;
            if (key.size() < 3) continue;
            if (use.count == 2) topology.shared.push_back(sharedSide(blocks, use));
            if (use.count == 1) topology.patches.back().push_back(use.blocks[0]);
            use.count = 0;
        }
    const auto sameName = std::ranges::find(
        description.patches, description.defaultPatch.name, [](const BlockPatch& p) -> const auto& {
            return p.patch.name;
        });
    if (sameName == description.patches.end()) return topology;
    auto& named = topology.patches[index(
        toLabel(static_cast<std::size_t>(sameName - description.patches.begin())))];
    named.insert(named.end(), topology.patches.back().begin(), topology.patches.back().end());
    topology.patches.back().clear();
    topology.hasDefaultPatch = false;
    return topology;
}

} // namespace polymesh
