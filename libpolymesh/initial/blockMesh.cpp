// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// blockMesh of blocks.h: checks the blocks, numbers their points and collects their faces.

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/initial/blockNumbering.h"
#include "libpolymesh/initial/mergePatches.h"
#include "libpolymesh/initial/stitchParts.h"
#include "libpolymesh/mesh/validate.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace polymesh {
namespace {

using Quad = std::array<Label, 4>;

/// Six times the volume of a block with straight edges, about; negative when it is inside out.
double signedVolume(const std::vector<Vec3>& vertices, const Block& block) {
    const auto corner = [&](std::size_t c) { return vertices[index(block.vertices[c])]; };
    double sum = 0;
    for (const auto& side : hexSides) {
        const Vec3 centre =
            0.25 * (corner(side[0]) + corner(side[1]) + corner(side[2]) + corner(side[3])) -
            corner(0);
        sum += dot(centre,
                   cross(corner(side[2]) - corner(side[0]), corner(side[3]) - corner(side[1])));
    }
    return sum;
}

/// Labels must be able to count the points and the corners of the faces.
void checkSize(const std::vector<Block>& blocks) {
    double points = 0;
    double faces = 0;
    for (const Block& block : blocks) {
        const auto n = [&](std::size_t d) { return static_cast<double>(block.cells[d]); };
        points += (n(0) + 1) * (n(1) + 1) * (n(2) + 1);
        faces += 3 * n(0) * n(1) * n(2) + n(0) * n(1) + n(1) * n(2) + n(2) * n(0);
        require(std::max(points, 4 * faces) <
                    static_cast<double>(std::numeric_limits<Label>::max()),
                "{}: up to this block there are {:.3g} points and {:.3g} faces, too many for "
                "labels of {} bits",
                block.where,
                points,
                faces,
                8 * sizeof(Label));
    }
}

void checkBlocks(const BlockMeshDescription& description) {
    checkSize(description.blocks);
    for (const Block& block : description.blocks)
        require(signedVolume(description.vertices, block) > 0,
                "{}: this block is inside out or flat; give first four vertices such that seen "
                "from the other four they run clockwise",
                block.where);
}

/// The cells across the sides of a block; block -1: none.
struct Across {
    Label block = -1;
    SideGrid grid;
};

/// A cell of a block and its place among the rows of cells along x.
struct Row {
    std::size_t block;
    Label j;
    Label k;
};

/// The face of a cell towards a neighbour with a higher label.
struct UpperFace {
    Label neighbour;
    std::size_t side;
};

struct UpperFaces {
    std::array<UpperFace, 6> faces;
    std::size_t count = 0;

    /// Keeps the faces in the order of the neighbours.
    void add(UpperFace face) {
        std::size_t at = count++;
        for (; at > 0 && faces[at - 1].neighbour > face.neighbour; --at)
            faces[at] = faces[at - 1];
        faces[at] = face;
    }
};

/// Makes the faces of the mesh, cell by cell.
class FaceCollector {
public:
    FaceCollector(const BlockMeshDescription& description,
                  const BlockTopology& topology,
                  const BlockNumbering& numbering);

    /// Adds the internal faces and keeps room for the boundary.
    void addInternal(std::size_t boundaryFaces, PolyMesh& mesh) const;
    void addBoundary(const std::vector<BoundarySide>& sides, PolyMesh& mesh) const;

private:
    void fillRow(const Row& at, std::size_t f, PolyMesh& mesh) const;
    Row row(Label r) const;
    Label cellAcross(const Row& row, Label i, std::size_t side) const;
    UpperFaces upperFaces(const Row& row, Label i) const;
    Quad quad(const Row& row, Label i, std::size_t side) const;

    const BlockMeshDescription& description_;
    const BlockNumbering& numbering_;
    std::vector<std::array<Across, 6>> across_; // of each block
    std::vector<Label> firstRow_;               // of each block, and the number of rows
};

FaceCollector::FaceCollector(const BlockMeshDescription& description,
                             const BlockTopology& topology,
                             const BlockNumbering& numbering)
    : description_(description), numbering_(numbering), across_(description.blocks.size()) {
    firstRow_.push_back(0);
    for (const Block& block : description.blocks)
        firstRow_.push_back(firstRow_.back() + block.cells[1] * block.cells[2]);
    for (const SharedSide& shared : topology.shared) {
        const auto [a, b] = shared.blocks;
        across_[index(a)][shared.sides[0]] = {b, shared.grids[1]};
        across_[index(b)][shared.sides[1]] = {a, shared.firstSeenFromSecond};
    }
}

Row FaceCollector::row(Label r) const {
    const auto after = std::ranges::upper_bound(firstRow_, r);
    const auto block = static_cast<std::size_t>(after - firstRow_.begin()) - 1;
    const Label inBlock = r - firstRow_[block];
    const Label rows = description_.blocks[block].cells[1];
    return {block, inBlock % rows, inBlock / rows};
}

/// The cell on the other side, or -1 on the boundary.
Label FaceCollector::cellAcross(const Row& row, Label i, std::size_t side) const {
    const BlockGrid grid{description_.blocks[row.block].cells};
    const std::array<Label, 3> ijk{i, row.j, row.k};
    const std::size_t direction = side / 2;
    const bool upper = side % 2 == 1;
    const Label last = upper ? grid.cells[direction] - 1 : 0;
    if (ijk[direction] != last) {
        const Label step = grid.cellSteps()[direction];
        const Label cell = numbering_.firstCell[row.block] + grid.cell(i, row.j, row.k);
        return upper ? cell + step : cell - step;
    }
    const Across& across = across_[row.block][side];
    if (across.block < 0) return -1;
    const Label u = ijk[direction == 0 ? 1 : 0];
    const Label v = ijk[direction == 2 ? 1 : 2];
    return numbering_.firstCell[index(across.block)] + across.grid.cell(u, v);
}

UpperFaces FaceCollector::upperFaces(const Row& row, Label i) const {
    const BlockGrid grid{description_.blocks[row.block].cells};
    const Label cell = numbering_.firstCell[row.block] + grid.cell(i, row.j, row.k);
    UpperFaces upper;
    for (std::size_t side = 0; side < 6; ++side) {
        const Label neighbour = cellAcross(row, i, side);
        if (neighbour > cell) upper.add({neighbour, side});
    }
    return upper;
}

Quad FaceCollector::quad(const Row& row, Label i, std::size_t side) const {
    const BlockGrid grid{description_.blocks[row.block].cells};
    const std::array<Label, 3> steps = grid.pointSteps();
    const Label first = numbering_.firstPoint[row.block] + grid.point(i, row.j, row.k);
    Quad result{};
    for (std::size_t n = 0; n < 4; ++n) {
        const std::size_t c = hexSides[side][n];
        const Label x = c % 4 == 1 || c % 4 == 2 ? steps[0] : 0;
        const Label y = c % 4 >= 2 ? steps[1] : 0;
        const Label z = c >= 4 ? steps[2] : 0;
        result[n] = numbering_.meshPoint[index(first + x + y + z)];
    }
    return result;
}

void FaceCollector::addInternal(std::size_t boundaryFaces, PolyMesh& mesh) const {
    const Label rowCount = firstRow_.back();
    std::vector<Label> firstFace(index(rowCount) + 1, 0);
    parallelBlocks(rowCount, 16, [&](Label, Label first, Label last) {
        for (Label r = first; r < last; ++r) {
            const Row at = row(r);
            const Label n = description_.blocks[at.block].cells[0];
            for (Label i = 0; i < n; ++i)
                firstFace[index(r) + 1] += toLabel(upperFaces(at, i).count);
        }
    });
    for (std::size_t r = 0; r < index(rowCount); ++r)
        firstFace[r + 1] += firstFace[r];
    const std::size_t faceCount = index(firstFace.back());
    mesh.neighbour = freshList<Label>(faceCount);
    mesh.owner = freshList<Label>(faceCount + boundaryFaces);
    mesh.owner.resize(faceCount);
    mesh.faces.values = freshList<Label>(4 * (faceCount + boundaryFaces));
    mesh.faces.values.resize(4 * faceCount);
    parallelBlocks(rowCount, 16, [&](Label, Label first, Label last) {
        for (Label r = first; r < last; ++r)
            fillRow(row(r), index(firstFace[index(r)]), mesh);
    });
}

/// Enters the internal faces of a row of cells, from face f on.
void FaceCollector::fillRow(const Row& at, std::size_t f, PolyMesh& mesh) const {
    const BlockGrid grid{description_.blocks[at.block].cells};
    for (Label i = 0; i < grid.cells[0]; ++i) {
        const UpperFaces upper = upperFaces(at, i);
        for (std::size_t n = 0; n < upper.count; ++n, ++f) {
            mesh.owner[f] = numbering_.firstCell[at.block] + grid.cell(i, at.j, at.k);
            mesh.neighbour[f] = upper.faces[n].neighbour;
            std::ranges::copy(quad(at, i, upper.faces[n].side), &mesh.faces.values[4 * f]);
        }
    }
}

/// How many different labels there are.
std::ptrdiff_t cornerCount(Quad quad) {
    std::ranges::sort(quad);
    return std::unique(quad.begin(), quad.end()) - quad.begin();
}

void FaceCollector::addBoundary(const std::vector<BoundarySide>& sides, PolyMesh& mesh) const {
    for (const BoundarySide& boundary : sides) {
        const auto block = index(boundary.block);
        const BlockGrid blockGrid{description_.blocks[block].cells};
        const SideGrid grid = sideGrid(blockGrid, boundary.side);
        for (Label v = 0; v < grid.counts[1]; ++v)
            for (Label u = 0; u < grid.counts[0]; ++u) {
                const Label cell = grid.cell(u, v);
                const Label i = cell % blockGrid.cells[0];
                const Label jk = cell / blockGrid.cells[0];
                const Row at{block, jk % blockGrid.cells[1], jk / blockGrid.cells[1]};
                const Quad points = quad(at, i, boundary.side);
                if (numbering_.collapsed[block] && cornerCount(points) < 3) continue;
                mesh.owner.push_back(numbering_.firstCell[block] + cell);
                mesh.faces.values.insert(mesh.faces.values.end(), points.begin(), points.end());
            }
    }
}

void addPatches(const BlockMeshDescription& description,
                const BlockTopology& topology,
                const FaceCollector& collector,
                PolyMesh& mesh) {
    for (std::size_t p = 0; p < topology.patches.size(); ++p) {
        const bool given = p < description.patches.size();
        if (!given && !topology.hasDefaultPatch) continue;
        Patch patch = given ? description.patches[p].patch : description.defaultPatch;
        patch.start = toLabel(mesh.owner.size());
        collector.addBoundary(topology.patches[p], mesh);
        patch.size = toLabel(mesh.owner.size()) - patch.start;
        mesh.patches.push_back(std::move(patch));
    }
}

/// The number of faces on the boundary, those without area included.
std::size_t countBoundary(const BlockMeshDescription& description, const BlockTopology& topology) {
    std::size_t count = 0;
    for (const std::vector<BoundarySide>& patch : topology.patches)
        for (const BoundarySide& side : patch) {
            const Block& block = description.blocks[index(side.block)];
            const SideGrid grid = sideGrid({block.cells}, side.side);
            count += index(grid.counts[0]) * index(grid.counts[1]);
        }
    return count;
}

void addZones(const std::vector<Block>& blocks, const BlockNumbering& numbering, PolyMesh& mesh) {
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        if (blocks[b].zone.empty()) continue;
        auto zone = std::ranges::find(mesh.cellZones, blocks[b].zone, &Zone::name);
        if (zone == mesh.cellZones.end())
            zone = mesh.cellZones.insert(zone, Zone{blocks[b].zone, {}, {}});
        for (Label c = numbering.firstCell[b]; c < numbering.firstCell[b + 1]; ++c)
            zone->labels.push_back(c);
    }
}

/// Four labels a face so far; in collapsed blocks some of them repeat.
void finishFaces(bool anyCollapsed, Rows<Label>& faces) {
    const std::size_t count = faces.values.size() / 4;
    faces.offsets = freshList<Label>(count + 1);
    parallelFor(toLabel(count) + 1, [&](Label f) { faces.offsets[index(f)] = 4 * f; });
    if (!anyCollapsed) return;
    Rows<Label> clean;
    clean.values.reserve(faces.values.size());
    clean.offsets.reserve(count + 1);
    for (Label f = 0; f < toLabel(count); ++f) {
        const std::size_t first = clean.values.size();
        for (const Label p : std::as_const(faces)[f])
            if (std::find(clean.values.begin() + static_cast<std::ptrdiff_t>(first),
                          clean.values.end(),
                          p) == clean.values.end())
                clean.values.push_back(p);
        clean.offsets.push_back(toLabel(clean.values.size()));
    }
    faces = std::move(clean);
}

} // namespace

PolyMesh blockMesh(const BlockMeshDescription& description) {
    checkBlocks(description);
    const BlockTopology topology = blockTopology(description);
    PolyMesh mesh;
    std::vector<MeshPart> parts;
    {
        BlockNumbering numbering = numberPoints(description, topology);
        for (const BlockPart& part : description.parts)
            parts.push_back({numbering.firstCell[index(part.firstBlock)], part.where});
        const FaceCollector collector(description, topology, numbering);
        collector.addInternal(countBoundary(description, topology), mesh);
        addPatches(description, topology, collector, mesh);
        const bool anyCollapsed =
            std::ranges::find(numbering.collapsed, true) != numbering.collapsed.end();
        finishFaces(anyCollapsed, mesh.faces);
        mesh.points = meshPoints(std::move(numbering.points), numbering, description.scale);
        mesh.cellCount = numbering.firstCell.back();
        addZones(description.blocks, numbering, mesh);
        if (anyCollapsed) requireValid(mesh, "the mesh of the blocks");
    }
    for (const PatchPair& pair : description.mergePairs)
        mergePatches(mesh, pair);
    if (parts.size() > 1) stitchParts(mesh, parts);
    return mesh;
}

} // namespace polymesh
