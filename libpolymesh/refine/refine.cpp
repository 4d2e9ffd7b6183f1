// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/refine.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/refine/forest.h"
#include "libpolymesh/refine/openCollapsed.h"
#include "libpolymesh/refine/refinedFaces.h"
#include "libpolymesh/refine/uniteCollapsed.h"

#include <cmath>

namespace polymesh {
namespace {

Vec3 pointAt(const HexCells& cells, Label tree, const LatticePoint& p) {
    constexpr double scale = 1.0 / latticeSize;
    return cells.pointIn(tree, {scale * p[0], scale * p[1], scale * p[2]});
}

RefineCell boxOf(const HexCells& cells, Label tree, const Octant& octant) {
    const Vec3& low = cells.points[index(cells.corners[index(tree)][0])];
    const Vec3 size = cells.points[index(cells.corners[index(tree)][7])] - low;
    const double part = 1.0 / (1 << octant.level);
    RefineCell cell{low, 0.5 * part * norm(size), 0, octant.level, tree};
    for (int axis = 0; axis < 3; ++axis) {
        const std::int32_t middle =
            octant.anchor[static_cast<std::size_t>(axis)] + octant.size() / 2;
        cell.centre[axis] += size[axis] * (1.0 / latticeSize) * middle;
        cell.size = std::max(cell.size, part * size[axis]);
    }
    return cell;
}

RefineCell cellOf(const HexCells& cells, Label tree, const Octant& octant) {
    if (cells.areBoxes) return boxOf(cells, tree, octant);
    std::array<Vec3, 8> corners;
    for (std::size_t c = 0; c < 8; ++c)
        corners[c] = octant.level == 0 ? cells.points[index(cells.corners[index(tree)][c])]
                                       : pointAt(cells, tree, octant.corner(c));
    RefineCell cell{{}, 0, 0, octant.level, tree};
    for (const Vec3& corner : corners)
        cell.centre += 0.125 * corner;
    for (std::size_t c = 0; c < 8; ++c) {
        cell.radius = std::max(cell.radius, norm(corners[c] - cell.centre));
        for (std::size_t axis = 0; axis < 3; ++axis)
            cell.size = std::max(cell.size, norm(corners[c] - corners[c ^ std::size_t{1} << axis]));
    }
    return cell;
}

Selection selection(const HexCells& cells, const std::vector<Criterion>& criteria) {
    return [&](int level, std::span<const OctantKey> octants) {
        std::vector<char> flags(octants.size(), 0);
        parallelFor(toLabel(octants.size()), [&](Label i) {
            const OctantKey key = octants[index(i)];
            const RefineCell cell = cellOf(cells, treeOf(key), {anchorOf(key), level});
            flags[index(i)] =
                std::ranges::any_of(criteria, [&](const Criterion& c) { return c(cell); }) ? 1 : 0;
        });
        return flags;
    };
}

/// Of the trees of this process, in blocks.
std::vector<InternalFaces> internalFaces(const Partition& partition, const RefinedFaces& faces) {
    constexpr Label blockSize = 256;
    const Label trees = partition.end() - partition.first();
    std::vector<InternalFaces> blocks(index((trees + blockSize - 1) / blockSize));
    parallelBlocks(trees, blockSize, [&](Label block, Label first, Label last) {
        for (Label i = first; i < last; ++i)
            faces.addInternal(partition.first() + i, blocks[index(block)]);
    });
    return blocks;
}

/// Makes the faces of the mesh of the parts, in their order; gives their memory back.
void joinFaces(std::vector<FaceList> parts, PolyMesh& mesh) {
    std::vector<std::array<Label, 3>> starts; // faces, neighbours and points before each part
    std::array<Label, 3> at{};
    for (const FaceList& part : parts) {
        starts.push_back(at);
        at[0] += toLabel(part.owner.size());
        at[1] += toLabel(part.neighbour.size());
        at[2] += toLabel(part.points.values.size());
    }
    mesh.owner = freshList<Label>(index(at[0]));
    mesh.neighbour = freshList<Label>(index(at[1]));
    mesh.faces.offsets = freshList<Label>(index(at[0]) + 1);
    mesh.faces.values = freshList<Label>(index(at[2]));
    parallelBlocks(toLabel(parts.size()), 1, [&](Label p, Label, Label) {
        const FaceList part = std::move(parts[index(p)]);
        const auto [face, internal, value] = starts[index(p)];
        std::ranges::copy(part.owner, mesh.owner.begin() + face);
        std::ranges::copy(part.neighbour, mesh.neighbour.begin() + internal);
        std::ranges::copy(part.points.values, mesh.faces.values.begin() + value);
        for (std::size_t f = 1; f < part.points.offsets.size(); ++f)
            mesh.faces.offsets[index(face) + f] = value + part.points.offsets[f];
    });
}

/// The inner faces of the blocks; their places stay.
std::vector<FaceList> takeInner(std::vector<InternalFaces>& blocks) {
    std::vector<FaceList> parts;
    parts.reserve(blocks.size());
    for (InternalFaces& block : blocks) {
        std::vector<Label> places = std::move(block.inner.place);
        parts.push_back(std::move(block.inner));
        block.inner = {};
        block.inner.place = std::move(places);
    }
    return parts;
}

/// The faces of each patch of the initial mesh.
std::vector<FaceList>
patchFaces(const HexCells& cells, const Partition& partition, const RefinedFaces& faces) {
    std::vector<FaceList> parts(cells.patches.size());
    for (const HexBoundarySide& side : cells.sides)
        if (partition.isOwn(side.cell))
            faces.addBoundary({side.cell, index(side.side)}, parts[index(side.patch)]);
    return parts;
}

void addFaces(const HexCells& cells,
              const Partition& partition,
              const RefinedFaces& faces,
              std::vector<InternalFaces>& blocks,
              PolyMesh& mesh) {
    std::vector<FaceList> parts = takeInner(blocks);
    Label start = 0;
    for (const FaceList& part : parts)
        start += toLabel(part.owner.size());
    mesh.patches = cells.patches;
    std::vector<FaceList> ofPatches = patchFaces(cells, partition, faces);
    for (std::size_t p = 0; p < ofPatches.size(); ++p) {
        mesh.patches[p].start = start;
        mesh.patches[p].size = toLabel(ofPatches[p].owner.size());
        start += mesh.patches[p].size;
        parts.push_back(std::move(ofPatches[p]));
    }
    joinFaces(std::move(parts), mesh);
}

/// Cells by the labels that they have in this process.
std::vector<Zone>
refinedZones(const std::vector<Zone>& zones, const Partition& partition, const Leaves& leaves) {
    std::vector<Zone> result;
    const Label firstCell = leaves.first[index(partition.first())];
    for (const Zone& zone : zones) {
        result.push_back({zone.name, {}, {}});
        for (const Label tree : zone.labels)
            if (partition.isOwn(tree))
                for (Label c = leaves.first[index(tree)]; c < leaves.first[index(tree) + 1]; ++c)
                    result.back().labels.push_back(c - firstCell);
    }
    return result;
}

/// Coordinates and levels of points, of which some have labels of their own in this process.
class PointSetter {
public:
    PointSetter(const HexCells& cells, RefinedMesh& result, Label pointCount)
        : cells_(cells), result_(result), known_(result.addressing.points) {
        const std::size_t count = known_.empty() ? index(pointCount) : known_.size();
        result.mesh.points = freshList<Vec3>(count);
        result.pointLevel = freshList<Label>(count);
    }

    void set(const PointTable& table) {
        const Label corners = toLabel(cells_.points.size());
        if (known_.empty()) std::ranges::copy(cells_.points, result_.mesh.points.begin());
        for (std::size_t p = 0; p < known_.size() && known_[p] < corners; ++p)
            result_.mesh.points[p] = cells_.points[index(known_[p])];
        const auto setHome = [&](const PointTable::Home& home) { setPoint(home); };
        table.forOwnedPoints(setHome);
        if (!known_.empty()) table.forForeignPoints(setHome);
    }

private:
    void setPoint(const PointTable::Home& home) {
        const std::size_t p =
            known_.empty() ? index(home.label)
                           : static_cast<std::size_t>(std::ranges::lower_bound(known_, home.label) -
                                                      known_.begin());
        result_.mesh.points[p] = pointAt(cells_, home.tree, home.point);
        result_.pointLevel[p] = levelOfPoint(home.point);
    }

    const HexCells& cells_;
    RefinedMesh& result_;
    const std::vector<Label>& known_; // labels in the mesh of all; empty: they are the same
};

void setCellLevels(const Partition& partition, const Leaves& leaves, RefinedMesh& result) {
    const Label firstCell = leaves.first[index(partition.first())];
    result.mesh.cellCount = leaves.first[index(partition.end())] - firstCell;
    result.cellLevel = freshList<Label>(index(result.mesh.cellCount));
    parallelFor(partition.end() - partition.first(), [&](Label i) {
        Label cell = leaves.first[index(partition.first() + i)] - firstCell;
        for (const OctantCode code : leaves.of(partition.first() + i))
            result.cellLevel[index(cell++)] = levelOf(code);
    });
}

/// The octants that any process wants to be divided: each asks for its share of the trees.
RefinedOctants selectTogether(const HexCells& cells,
                              const std::vector<Criterion>& criteria,
                              const Processes& processes) {
    const Partition even = evenPartition(cells.cellCount(), processes);
    RefinedOctants refined = selectOctants(even.first(), even.end(), selection(cells, criteria));
    for (std::vector<OctantKey>& level : refined)
        level = processes.gather(level);
    return refined;
}

std::vector<Label> firstCellsOf(const Partition& partition, const Leaves& leaves) {
    std::vector<Label> cells;
    for (const Label tree : partition.firstTree)
        cells.push_back(leaves.first[index(tree)]);
    return cells;
}

/// Requires: eight different corners in each cell. `original`: of points that are copies, see
/// OpenedCells; empty: there are none.
RefinedMesh refineTrees(const HexCells& cells,
                        std::span<const Label> original,
                        const RefineOptions& options,
                        const Processes& processes) {
    const MacroMesh macro(cells.corners, toLabel(cells.points.size()));
    const CollapsedEdges collapsed =
        original.empty() ? CollapsedEdges() : CollapsedEdges(macro, original);
    RefinedOctants refined = selectTogether(cells, options.criteria, processes);
    balance(macro, options.bufferLayers, refined, collapsed);
    const TreeOctants octants = octantsByTree(macro, refined);
    const Partition partition = partitionByLeaves(octants, processes);
    const Leaves leaves = growForest(macro, refined, octants, partition);
    const PointTable table(macro, octants, partition, processes);
    RefinedFaces faces(macro, octants, leaves, table);
    const std::vector<Label> firstCells = firstCellsOf(partition, leaves);
    RefinedMesh result;
    setCellLevels(partition, leaves, result);
    const auto rank = static_cast<std::size_t>(partition.rank);
    if (!partition.isWhole()) faces.setOwnCells(firstCells[rank], firstCells[rank + 1]);
    {
        std::vector<InternalFaces> blocks = internalFaces(partition, faces);
        addFaces(cells, partition, faces, blocks, result.mesh);
        if (!partition.isWhole()) {
            addProcessPatches(blocks, firstCells, processes, result.mesh, result.addressing);
            useOwnLabels(firstCells[rank], result.mesh, result.addressing);
        }
    }
    PointSetter(cells, result, table.pointCount()).set(table);
    if (!original.empty()) uniteCollapsed(collapsed, table, result);
    result.mesh.cellZones = refinedZones(cells.cellZones, partition, leaves);
    return result;
}

} // namespace

RefinedMesh
refine(const HexCells& cells, const RefineOptions& options, const Processes& processes) {
    if (!cells.hasCollapsed) return refineTrees(cells, {}, options, processes);
    require(processes.count() == 1,
            "cells with collapsed edges can only be refined by one process");
    OpenedCells opened = openCollapsed(cells.corners, toLabel(cells.points.size()));
    HexCells trees = cells;
    trees.corners = std::move(opened.corners);
    for (std::size_t p = cells.points.size(); p < opened.original.size(); ++p)
        trees.points.push_back(cells.points[index(opened.original[p])]);
    return refineTrees(trees, opened.original, options, processes);
}

} // namespace polymesh
