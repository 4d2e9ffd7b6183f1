// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/refinedOctants.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/kept.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/base/parallelSort.h"
#include "libpolymesh/refine/octantNeighbours.h"

#include <numeric>

namespace polymesh {
namespace {

using Keys = std::vector<OctantKey>;

constexpr Label blockSize = 1 << 12; // octants that a thread takes at a time

/// Each makes seven more cells, and a cell three faces or so, of which there can be 2^31.
constexpr std::size_t mostDivided = 100'000'000;

Keys childrenOf(const Keys& parents, int level) {
    Keys children(8 * parents.size());
    parallelFor(toLabel(parents.size()), [&](Label i) {
        const Octant parent{anchorOf(parents[index(i)]), level};
        for (std::size_t c = 0; c < 8; ++c)
            children[8 * index(i) + c] =
                octantKey(treeOf(parents[index(i)]), parent.child(c).anchor);
    });
    return children;
}

Keys chosen(const Keys& octants, const std::vector<char>& flags) {
    const Kept kept(toLabel(octants.size()), [&](Label i) { return flags[index(i)] != 0; });
    Keys result(index(kept.count()));
    kept.forEach([&](Label from, Label to) { result[index(to)] = octants[index(from)]; });
    return result;
}

void sortUnique(Keys& keys) {
    parallelSort(keys);
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

/// What add(octant, list) adds for each octant, sorted, each once.
template<class Add>
Keys collect(const Keys& octants, Add&& add) {
    std::vector<Keys> parts(octants.size() / index(blockSize) + 1);
    parallelBlocks(toLabel(octants.size()), blockSize, [&](Label block, Label first, Label last) {
        Keys& part = parts[index(block)];
        for (Label i = first; i < last; ++i)
            add(octants[index(i)], part);
        std::ranges::sort(part);
        part.erase(std::unique(part.begin(), part.end()), part.end());
    });
    Keys all;
    all.reserve(
        std::accumulate(parts.begin(), parts.end(), std::size_t{0}, [](auto n, const auto& p) {
            return n + p.size();
        }));
    for (const Keys& part : parts)
        all.insert(all.end(), part.begin(), part.end());
    sortUnique(all);
    return all;
}

/// With all octants of the same level round them.
Keys widened(const MacroMesh& mesh, const Keys& octants, int level) {
    return collect(octants, [&](OctantKey key, Keys& list) {
        list.push_back(key);
        for (int i = 0; i < 27; ++i) {
            const std::array<int, 3> step{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
            if (step == std::array<int, 3>{}) continue;
            forNeighbours(
                mesh, treeOf(key), {anchorOf(key), level}, step, [&](Label tree, const Octant& o) {
                    list.push_back(octantKey(tree, o.anchor));
                });
        }
    });
}

/// The octants one level coarser that touch these ones or contain them: they must be divided too.
Keys coarserRound(const MacroMesh& mesh, const Keys& octants, int level) {
    return collect(octants, [&](OctantKey key, Keys& list) {
        const LatticePoint anchor = anchorOf(key);
        Octant parent{anchor, level - 1};
        std::array<int, 3> outward{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int32_t within = anchor[axis] & (parent.size() - 1);
            parent.anchor[axis] -= within;
            outward[axis] = within != 0 ? 1 : -1;
        }
        const Label tree = treeOf(key);
        list.push_back(octantKey(tree, parent.anchor));
        for (unsigned way = 1; way < 8; ++way) {
            const std::array<int, 3> step{(way & 1U) != 0 ? outward[0] : 0,
                                          (way & 2U) != 0 ? outward[1] : 0,
                                          (way & 4U) != 0 ? outward[2] : 0};
            forNeighbours(mesh, tree, parent, step, [&](Label other, const Octant& o) {
                list.push_back(octantKey(other, o.anchor));
            });
        }
    });
}

} // namespace

RefinedOctants selectOctants(Label firstTree, Label lastTree, const Selection& isWanted) {
    RefinedOctants refined;
    Keys candidates(index(lastTree - firstTree));
    parallelFor(lastTree - firstTree,
                [&](Label i) { candidates[index(i)] = octantKey(firstTree + i, {}); });
    for (int level = 0; level < mostLevel && !candidates.empty(); ++level) {
        Keys& list = refined[static_cast<std::size_t>(level)];
        list = chosen(candidates, isWanted(level, candidates));
        require(list.size() <= mostDivided,
                "refinement: more than {} cells are to be divided at level {}, too many for labels "
                "of 32 bits; ask for less",
                mostDivided,
                level);
        candidates = childrenOf(list, level);
    }
    return refined;
}

void balance(const MacroMesh& mesh,
             int bufferLayers,
             RefinedOctants& refined,
             const CollapsedEdges& collapsed) {
    for (std::size_t level = mostLevel - 1; level > 0; --level) {
        if (refined[level].empty()) continue;
        const int l = static_cast<int>(level);
        collapsed.addTogether(l, refined[level]);
        Keys wide = refined[level];
        for (int layer = 1; layer < bufferLayers; ++layer)
            wide = widened(mesh, wide, l);
        const Keys more = coarserRound(mesh, wide, l);
        Keys& coarser = refined[level - 1];
        Keys both(coarser.size() + more.size());
        both.erase(std::ranges::set_union(coarser, more, both.begin()).out, both.end());
        coarser = std::move(both);
    }
    collapsed.addTogether(0, refined[0]);
}

TreeOctants octantsByTree(const MacroMesh& mesh, const RefinedOctants& refined) {
    TreeOctants result;
    result.rowOf.assign(index(mesh.cellCount()), -1);
    result.level.assign(index(mesh.cellCount()), 0);
    const Label rowCount = toLabel(refined[0].size());
    for (Label row = 0; row < rowCount; ++row)
        result.rowOf[index(treeOf(refined[0][index(row)]))] = row;
    std::vector<Label>& offsets = result.rows.offsets;
    offsets.assign(index(rowCount) + 1, 0);
    for (std::size_t level = 0; level < mostLevel; ++level)
        for (const OctantKey key : refined[level]) {
            ++offsets[index(result.rowOf[index(treeOf(key))]) + 1];
            result.level[index(treeOf(key))] = static_cast<std::int8_t>(level + 1);
        }
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    result.rows.values.resize(index(offsets.back()));
    std::vector<Label> next = offsets;
    for (std::size_t level = 0; level < mostLevel; ++level)
        for (const OctantKey key : refined[level])
            result.rows.values[index(next[index(result.rowOf[index(treeOf(key))])]++)] =
                octantCode({anchorOf(key), static_cast<int>(level)});
    std::vector<std::int8_t> atPoint(index(mesh.pointCount()), 0);
    parallelFor(mesh.pointCount(), [&](Label p) {
        for (const Label cell : mesh.cellsAt(p))
            atPoint[index(p)] = std::max(atPoint[index(p)], result.level[index(cell)]);
    });
    result.highest.assign(index(mesh.cellCount()), 0);
    parallelFor(mesh.cellCount(), [&](Label cell) {
        for (const Label p : mesh.corners(cell))
            result.highest[index(cell)] = std::max(result.highest[index(cell)], atPoint[index(p)]);
    });
    return result;
}

} // namespace polymesh
