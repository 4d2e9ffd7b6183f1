// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/blockParts.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace polymesh {
namespace {

const std::string& nameOf(const BlockPatch& patch) {
    return patch.patch.name;
}

void addPatch(std::vector<BlockPatch>& patches, BlockPatch patch) {
    const auto same = std::ranges::find(patches, patch.patch.name, nameOf);
    if (same == patches.end())
        patches.push_back(std::move(patch));
    else
        std::ranges::copy(patch.sides, std::back_inserter(same->sides));
}

/// Labels of vertices begin with `first`.
void shift(BlockMeshDescription& part, Label first) {
    const auto shiftAll = [first](auto& vertices) {
        for (Label& v : vertices)
            v += first;
    };
    for (Block& block : part.blocks)
        shiftAll(block.vertices);
    for (BlockEdge& edge : part.edges)
        shiftAll(edge.vertices);
    for (ProjectedSide& projected : part.projectedSides)
        shiftAll(projected.side.vertices);
    for (BlockPatch& patch : part.patches)
        for (BlockSide& side : patch.sides)
            shiftAll(side.vertices);
}

template<class T>
void append(std::vector<T>& all, std::vector<T> more) {
    std::ranges::move(more, std::back_inserter(all));
}

} // namespace

void renamePatch(BlockMeshDescription& description,
                 const std::string& name,
                 const std::string& newName) {
    if (description.defaultPatch.name == name) description.defaultPatch.name = newName;
    const auto found = std::ranges::find(description.patches, name, nameOf);
    if (found == description.patches.end() || name == newName) return;
    BlockPatch patch = std::move(*found);
    const auto place = description.patches.erase(found);
    patch.patch.name = newName;
    if (std::ranges::find(description.patches, newName, nameOf) == description.patches.end())
        description.patches.insert(place, std::move(patch));
    else
        addPatch(description.patches, std::move(patch));
}

void addPart(BlockMeshDescription& description, BlockMeshDescription part, std::string where) {
    description.parts.push_back({toLabel(description.blocks.size()), std::move(where)});
    shift(part, toLabel(description.vertices.size()));
    // Collapsed sides without faces belong to no patch otherwise: they must not make one.
    if (std::ranges::find(part.patches, part.defaultPatch.name, nameOf) != part.patches.end())
        description.defaultPatch = std::move(part.defaultPatch);
    append(description.vertices, std::move(part.vertices));
    append(description.edges, std::move(part.edges));
    append(description.projectedSides, std::move(part.projectedSides));
    append(description.blocks, std::move(part.blocks));
    for (BlockPatch& patch : part.patches)
        addPatch(description.patches, std::move(patch));
}

} // namespace polymesh
