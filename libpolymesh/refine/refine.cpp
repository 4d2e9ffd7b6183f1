// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/refine.h"

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/refine/forest.h"
#include "libpolymesh/refine/refinedFaces.h"

#include <cmath>

namespace polymesh {
namespace {

Vec3 pointAt(const HexCells& cells, Label tree, const LatticePoint& p) {
    constexpr double scale = 1.0 / latticeSize;
    return cells.pointIn(tree, {scale * p[0], scale * p[1], scale * p[2]});
}

RefineCell cellOf(const HexCells& cells, Label tree, const Octant& octant) {
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

std::vector<FaceList> internalParts(Label trees, const RefinedFaces& faces) {
    constexpr Label blockSize = 256;
    std::vector<FaceList> parts(index((trees + blockSize - 1) / blockSize));
    parallelBlocks(trees, blockSize, [&](Label block, Label first, Label last) {
        for (Label tree = first; tree < last; ++tree)
            faces.addInternal(tree, parts[index(block)]);
    });
    return parts;
}

/// Appends the parts to the mesh, which gives each its place at once.
void append(std::vector<FaceList>& parts, PolyMesh& mesh) {
    std::vector<std::array<Label, 3>> starts; // faces, neighbours and points before each part
    std::array<Label, 3> at{
        mesh.faceCount(), mesh.internalFaceCount(), toLabel(mesh.faces.values.size())};
    for (const FaceList& part : parts) {
        starts.push_back(at);
        at[0] += toLabel(part.owner.size());
        at[1] += toLabel(part.neighbour.size());
        at[2] += toLabel(part.points.values.size());
    }
    mesh.owner.resize(index(at[0]));
    mesh.neighbour.resize(index(at[1]));
    mesh.faces.offsets.resize(index(at[0]) + 1);
    mesh.faces.values.resize(index(at[2]));
    parallelBlocks(toLabel(parts.size()), 1, [&](Label p, Label, Label) {
        FaceList part = std::move(parts[index(p)]);
        const auto [face, internal, value] = starts[index(p)];
        std::ranges::copy(part.owner, mesh.owner.begin() + face);
        std::ranges::copy(part.neighbour, mesh.neighbour.begin() + internal);
        std::ranges::copy(part.points.values, mesh.faces.values.begin() + value);
        for (std::size_t f = 1; f < part.points.offsets.size(); ++f)
            mesh.faces.offsets[index(face) + f] = value + part.points.offsets[f];
    });
}

void addPatches(const HexCells& cells, const RefinedFaces& faces, PolyMesh& mesh) {
    mesh.patches = cells.patches;
    std::size_t side = 0;
    for (Label p = 0; p < toLabel(mesh.patches.size()); ++p) {
        std::vector<FaceList> part(1);
        for (; side < cells.sides.size() && cells.sides[side].patch == p; ++side)
            faces.addBoundary({cells.sides[side].cell, index(cells.sides[side].side)}, part[0]);
        Patch& patch = mesh.patches[index(p)];
        patch.start = mesh.faceCount();
        patch.size = toLabel(part[0].owner.size());
        append(part, mesh);
    }
}

std::vector<Zone> refinedZones(const std::vector<Zone>& zones, const Leaves& leaves) {
    std::vector<Zone> result;
    for (const Zone& zone : zones) {
        result.push_back({zone.name, {}, {}});
        for (const Label tree : zone.labels)
            for (Label c = leaves.first[index(tree)]; c < leaves.first[index(tree) + 1]; ++c)
                result.back().labels.push_back(c);
    }
    return result;
}

void addPoints(const HexCells& cells, const PointTable& table, RefinedMesh& result) {
    std::vector<Vec3>& points = result.mesh.points;
    points = freshList<Vec3>(index(table.pointCount()));
    std::ranges::copy(cells.points, points.begin());
    result.pointLevel = freshList<Label>(index(table.pointCount()));
    table.forNewPoints([&](Label point, Label tree, const LatticePoint& p) {
        points[index(point)] = pointAt(cells, tree, p);
        result.pointLevel[index(point)] = levelOfPoint(p);
    });
}

} // namespace

RefinedMesh refine(const HexCells& cells, const RefineOptions& options) {
    const MacroMesh macro(cells.corners, toLabel(cells.points.size()));
    RefinedOctants refined =
        selectOctants(0, macro.cellCount(), selection(cells, options.criteria));
    balance(macro, options.bufferLayers, refined);
    const Leaves leaves = growForest(macro, refined);
    const TreeOctants octants = octantsByTree(macro, refined);
    const PointTable table(macro, octants);
    const RefinedFaces faces(macro, octants, leaves, table);
    RefinedMesh result;
    {
        std::vector<FaceList> parts = internalParts(macro.cellCount(), faces);
        append(parts, result.mesh);
    }
    addPatches(cells, faces, result.mesh);
    addPoints(cells, table, result);
    result.mesh.cellZones = refinedZones(cells.cellZones, leaves);
    result.mesh.cellCount = leaves.cellCount();
    result.cellLevel = freshList<Label>(index(leaves.cellCount()));
    parallelFor(leaves.cellCount(), [&](Label c) { result.cellLevel[index(c)] = leaves.level(c); });
    return result;
}

} // namespace polymesh
