// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/blockHexCells.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/initial/blockInterpolation.h"
#include "libpolymesh/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace polymesh {
namespace {

/// Edges of blocks are tabulated with this many intervals at most, all blocks together.
constexpr Label mostIntervals = 1 << 20;

/// A power of two: how many parts of a cell the tables of the edges hold.
Label tableParts(const std::vector<Block>& blocks) {
    constexpr Label most = 1 << 11;
    constexpr Label least = 1 << 3;
    double intervals = 0;
    for (const Block& block : blocks)
        intervals += 4.0 * (block.cells[0] + block.cells[1] + block.cells[2]);
    Label parts = most;
    while (parts > least && intervals * parts > mostIntervals)
        parts /= 2;
    return parts;
}

/// A cell's place in its block.
struct CellPlace {
    std::size_t block = 0;
    std::array<Label, 3> ijk{};
};

/// Points of blocks at any place.
class BlockMap {
public:
    explicit BlockMap(const BlockMeshDescription& description);

    CellPlace placeOf(Label cell) const;

    /// By the edges of the block alone [m].
    Vec3 byEdges(const CellPlace& place, const Vec3& at) const;

    /// Onto the shape of a projected side, when the point is on one.
    Vec3 projected(const CellPlace& place, const Vec3& at, const Vec3& p) const;

    const BlockMeshDescription& description() const { return description_; }

private:
    Vec3 inTable(std::size_t block, const std::array<double, 3>& place) const;

    BlockMeshDescription description_;
    Label parts_;
    std::vector<BlockInterpolation> blocks_;
    std::vector<Label> firstCell_;
    std::vector<SideShapes> shapes_;
};

BlockMap::BlockMap(const BlockMeshDescription& description)
    : description_(description), parts_(tableParts(description.blocks)) {
    firstCell_.push_back(0);
    for (const Block& block : description_.blocks) {
        firstCell_.push_back(firstCell_.back() + BlockGrid{block.cells}.cellCount());
        blocks_.emplace_back(description_, block, parts_);
        shapes_.push_back(sideShapes(description_, block));
    }
}

CellPlace BlockMap::placeOf(Label cell) const {
    const auto after = std::ranges::upper_bound(firstCell_, cell);
    const auto block = static_cast<std::size_t>(after - firstCell_.begin()) - 1;
    const std::array<Label, 3>& n = description_.blocks[block].cells;
    const Label inBlock = cell - firstCell_[block];
    const Label row = inBlock / n[0];
    return {block, {inBlock % n[0], row % n[1], row / n[1]}};
}

/// Linear between the points that the tables hold.
Vec3 BlockMap::inTable(std::size_t block, const std::array<double, 3>& place) const {
    std::array<Label, 3> low{};
    std::array<double, 3> rest{};
    bool isInTable = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = static_cast<Label>(place[axis]);
        rest[axis] = place[axis] - static_cast<double>(low[axis]);
        isInTable = isInTable && rest[axis] == 0;
    }
    if (isInTable) return blocks_[block].point(low[0], low[1], low[2]);
    Vec3 sum;
    for (unsigned c = 0; c < 8; ++c) {
        double weight = 1;
        std::array<Label, 3> at = low;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool upper = (c >> axis & 1U) != 0;
            weight *= upper ? rest[axis] : 1 - rest[axis];
            if (upper) ++at[axis];
        }
        if (weight > 0) sum += weight * blocks_[block].point(at[0], at[1], at[2]);
    }
    return sum;
}

Vec3 BlockMap::byEdges(const CellPlace& place, const Vec3& at) const {
    std::array<double, 3> inBlock{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        inBlock[axis] = static_cast<double>(parts_) *
                        (static_cast<double>(place.ijk[axis]) + at[static_cast<int>(axis)]);
    return description_.scale * inTable(place.block, inBlock);
}

Vec3 BlockMap::projected(const CellPlace& place, const Vec3& at, const Vec3& p) const {
    const std::array<Label, 3>& n = description_.blocks[place.block].cells;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double inBlock = static_cast<double>(place.ijk[axis]) + at[static_cast<int>(axis)];
        const bool lower = inBlock == 0;
        if (!lower && inBlock != static_cast<double>(n[axis])) continue;
        const Shape* shape = shapes_[place.block][2 * axis + (lower ? 0 : 1)];
        if (shape != nullptr) return description_.scale * shape->nearest(p / description_.scale);
    }
    return p;
}

constexpr std::size_t cornerCount = 8;

Vec3 fractionsOf(std::size_t corner) {
    return {static_cast<double>(corner & 1U),
            static_cast<double>(corner >> 1U & 1U),
            static_cast<double>(corner >> 2U & 1U)};
}

/// The points of the blocks that have projected sides, which their edges do not tell; others empty.
std::vector<std::vector<Vec3>> projectedPoints(const BlockMeshDescription& description) {
    std::vector<std::vector<Vec3>> points;
    for (const Block& block : description.blocks) {
        const SideShapes shapes = sideShapes(description, block);
        const bool isProjected =
            std::ranges::any_of(shapes, [](const Shape* shape) { return shape != nullptr; });
        points.push_back(isProjected ? blockPoints(description, block) : std::vector<Vec3>());
    }
    return points;
}

/// Finds the points of the mesh that are the corners of cells.
class CornerFinder {
public:
    CornerFinder(const BlockMap& map, const PolyMesh& mesh)
        : map_(map), mesh_(mesh), projected_(projectedPoints(map.description())) {}

    /// Corner by corner the one of the cell's points that is nearest to the block's.
    std::array<Label, 8> find(Label cell, std::span<const Label> points) const {
        const CellPlace place = map_.placeOf(cell);
        std::array<Label, 8> corners{};
        for (std::size_t c = 0; c < cornerCount; ++c) {
            const Vec3 p = blockPoint(place, c);
            corners[c] = *std::ranges::min_element(
                points, {}, [&](Label q) { return squaredNorm(mesh_.points[index(q)] - p); });
        }
        return corners;
    }

private:
    Vec3 blockPoint(const CellPlace& place, std::size_t corner) const {
        const std::vector<Vec3>& known = projected_[place.block];
        if (known.empty()) return map_.byEdges(place, fractionsOf(corner));
        const BlockGrid grid{map_.description().blocks[place.block].cells};
        const auto [i, j, k] = place.ijk;
        return map_.description().scale *
               known[index(grid.point(i + static_cast<Label>(corner & 1U),
                                      j + static_cast<Label>(corner >> 1U & 1U),
                                      k + static_cast<Label>(corner >> 2U & 1U)))];
    }

    const BlockMap& map_;
    const PolyMesh& mesh_;
    std::vector<std::vector<Vec3>> projected_; // of each block, not scaled
};

bool isOnSide(std::size_t corner, std::size_t side) {
    return (corner >> side / 2 & 1U) == side % 2;
}

/// Whether a face has the corners of a side, and no other points.
bool isSide(const std::array<Label, 8>& corners, std::size_t side, std::span<const Label> face) {
    std::size_t found = 0;
    for (std::size_t c = 0; c < cornerCount; ++c)
        if (isOnSide(c, side) && std::ranges::find(face, corners[c]) != face.end()) ++found;
    if (found < 4) return false;
    return std::ranges::all_of(face, [&](Label p) {
        for (std::size_t c = 0; c < cornerCount; ++c)
            if (isOnSide(c, side) && corners[c] == p) return true;
        return false;
    });
}

/// The side of a cell that a face is.
Label sideOf(const std::array<Label, 8>& corners, std::span<const Label> face) {
    for (std::size_t side = 0; side < 6; ++side)
        if (isSide(corners, side, face)) return toLabel(side);
    return -1;
}

[[noreturn]] void refuse(const BlockMap& map, Label cell) {
    const CellPlace place = map.placeOf(cell);
    throw InputError(fmt::format(
        "{}: cell ({} {} {}) of this block is no hexahedron, because blocks that meet there have "
        "different faces; such meshes can not be refined",
        map.description().blocks[place.block].where,
        place.ijk[0],
        place.ijk[1],
        place.ijk[2]));
}

std::size_t differentCorners(std::array<Label, 8> corners) {
    std::ranges::sort(corners);
    return static_cast<std::size_t>(std::unique(corners.begin(), corners.end()) - corners.begin());
}

/// Whether six quadrilaterals can only be the sides of a cell with eight different corners.
bool isWhole(const PolyMesh& mesh, std::span<const Label> faces, std::size_t cornersFound) {
    return cornersFound == cornerCount && faces.size() == 6 &&
           std::ranges::all_of(faces, [&](Label f) { return mesh.faces.rowSize(f) == 4; });
}

/// Whether each face of a cell is one of its sides.
bool hasOnlySides(const PolyMesh& mesh,
                  std::span<const Label> faces,
                  const std::array<Label, 8>& corners) {
    std::array<bool, 6> isTaken{};
    return std::ranges::all_of(faces, [&](Label f) {
        const Label side = sideOf(corners, mesh.faces[f]);
        return side >= 0 && !std::exchange(isTaken[index(side)], true);
    });
}

/// Finds the corners of each cell. Throws InputError for a cell that is no hexahedron, not even one
/// with collapsed edges.
void findCorners(const BlockMap& map, const PolyMesh& mesh, HexCells& cells) {
    cells.corners = freshList<std::array<Label, 8>>(index(mesh.cellCount));

    enum Found : char { nothing, collapsed, whole };

    std::vector<Found> found(index(mesh.cellCount), nothing);
    const Rows<Label> faces = cellFaces(mesh);
    const Rows<Label> points = cellPoints(mesh, faces);
    const CornerFinder finder(map, mesh);
    parallelFor(mesh.cellCount, [&](Label cell) {
        std::array<Label, 8>& corners = cells.corners[index(cell)];
        corners = finder.find(cell, points[cell]);
        const std::size_t different = differentCorners(corners);
        const bool fits =
            different == points[cell].size() &&
            (isWhole(mesh, faces[cell], different) || hasOnlySides(mesh, faces[cell], corners));
        if (fits) found[index(cell)] = different == cornerCount ? whole : collapsed;
    });
    const auto missing = std::ranges::find(found, nothing);
    if (missing != found.end()) refuse(map, static_cast<Label>(missing - found.begin()));
    cells.hasCollapsed = std::ranges::find(found, collapsed) != found.end();
}

std::vector<HexBoundarySide> boundarySides(const PolyMesh& mesh, const HexCells& cells) {
    std::vector<HexBoundarySide> sides(index(mesh.faceCount() - mesh.internalFaceCount()));
    for (Label p = 0; p < toLabel(mesh.patches.size()); ++p) {
        const Patch& patch = mesh.patches[index(p)];
        parallelFor(patch.size, [&](Label i) {
            const Label f = patch.start + i;
            const Label cell = mesh.owner[index(f)];
            sides[index(f - mesh.internalFaceCount())] = {
                cell, sideOf(cells.corners[index(cell)], mesh.faces[f]), p};
        });
    }
    std::ranges::sort(sides, {}, [](const HexBoundarySide& s) {
        return std::array<Label, 3>{s.patch, s.cell, s.side};
    });
    return sides;
}

/// What the points of the mesh differ from those by the edges, linear in each direction.
Vec3 spread(const BlockMap& map, const HexCells& cells, Label cell, const Vec3& at) {
    const CellPlace place = map.placeOf(cell);
    Vec3 sum;
    for (std::size_t c = 0; c < cornerCount; ++c) {
        const Vec3 end = fractionsOf(c);
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis)
            weight *= end[axis] > 0 ? at[axis] : 1 - at[axis];
        const Vec3& corner = cells.points[index(cells.corners[index(cell)][c])];
        if (weight > 0) sum += weight * (corner - map.byEdges(place, end));
    }
    return sum;
}

/// Whether the corners of a cell are not where the edges of its block put them.
bool differs(const BlockMap& map, const HexCells& cells, Label cell) {
    constexpr double tolerance = 1e-10; // of the cell's size: rounding is less
    const std::array<Label, 8>& corners = cells.corners[index(cell)];
    const auto corner = [&](std::size_t c) { return cells.points[index(corners[c])]; };
    const double size2 = squaredNorm(corner(7) - corner(0));
    for (std::size_t c = 0; c < cornerCount; ++c)
        if (squaredNorm(corner(c) - map.byEdges(map.placeOf(cell), fractionsOf(c))) >
            tolerance * tolerance * size2)
            return true;
    return false;
}

} // namespace

HexCells hexCells(const BlockMeshDescription& description, const PolyMesh& mesh) {
    const auto map = std::make_shared<const BlockMap>(description);
    HexCells cells;
    cells.points = mesh.points;
    cells.patches = mesh.patches;
    cells.cellZones = mesh.cellZones;
    findCorners(*map, mesh, cells);
    std::vector<char> isMoved(index(mesh.cellCount), 0);
    parallelFor(mesh.cellCount,
                [&](Label cell) { isMoved[index(cell)] = differs(*map, cells, cell) ? 1 : 0; });
    cells.sides = boundarySides(mesh, cells);
    cells.map = [map,
                 isMoved = std::move(isMoved)](const HexCells& of, Label cell, const Vec3& at) {
        const CellPlace place = map->placeOf(cell);
        const Vec3 p = map->byEdges(place, at);
        return map->projected(
            place, at, isMoved[index(cell)] != 0 ? p + spread(*map, of, cell, at) : p);
    };
    return cells;
}

} // namespace polymesh
