// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mps/midPointSubdivision.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace polymesh {

namespace {

constexpr Label cellsPerBlock = 1024;

/// What a block of cells contributes, to be joined in the order of the blocks.
struct BlockResult {
    std::vector<Vec3> apices;
    std::vector<Label> inverted;
    std::int64_t hexahedra = 0;
    std::int64_t pyramids = 0;
};

/// Puts the middles of edges that bend there, and the centres of their faces where they are then.
void placeBends(const PolyMesh& mesh, const Bends& bends, SubdivisionPlan& plan) {
    if (bends.empty()) return;
    std::vector<char> isBent(index(plan.edges.size()), 0);
    for (const Bend& bend : bends) {
        const auto edge = std::ranges::lower_bound(plan.edges.points, bend.ends);
        if (edge == plan.edges.points.end() || *edge != bend.ends) continue;
        const auto number = static_cast<std::size_t>(edge - plan.edges.points.begin());
        isBent[number] = 1;
        plan.points[index(plan.layout.firstEdge) + number] = bend.at;
    }
    parallelFor(mesh.faceCount(), [&](Label face) {
        std::vector<Label> loop;
        bool hasBend = false;
        for (Label i = mesh.faces.offsets[index(face)]; i < mesh.faces.offsets[index(face) + 1];
             ++i)
            hasBend = hasBend || isBent[index(plan.edges.ofCorner[index(i)])] != 0;
        if (!hasBend) return;
        for (Label i = mesh.faces.offsets[index(face)]; i < mesh.faces.offsets[index(face) + 1];
             ++i) {
            const Label edge = plan.edges.ofCorner[index(i)];
            loop.push_back(mesh.faces.values[index(i)]);
            if (isBent[index(edge)] != 0) loop.push_back(plan.layout.firstEdge + edge);
        }
        plan.points[index(plan.layout.firstFace + face)] = faceGeometry(plan.points, loop).centre;
    });
}

void placeSharedPoints(const PolyMesh& mesh, SubdivisionPlan& plan) {
    const MeshGeometry geometry = computeGeometry(mesh, plan.cellFaces);
    plan.layout.firstEdge = mesh.pointCount();
    plan.layout.firstFace = plan.layout.firstEdge + plan.edges.size();
    plan.layout.firstCell = plan.layout.firstFace + mesh.faceCount();
    plan.layout.firstApex = plan.layout.firstCell + mesh.cellCount;
    plan.points.resize(index(plan.layout.firstApex));
    std::ranges::copy(mesh.points, plan.points.begin());
    parallelFor(plan.edges.size(), [&](Label edge) {
        const auto [a, b] = plan.edges.points[index(edge)];
        plan.points[index(plan.layout.firstEdge + edge)] =
            0.5 * (mesh.points[index(a)] + mesh.points[index(b)]);
    });
    std::ranges::copy(geometry.faceCentres, plan.points.begin() + plan.layout.firstFace);
    std::ranges::copy(geometry.cellCentres, plan.points.begin() + plan.layout.firstCell);
}

/// Writes what belongs to the cell into the plan: where its parts are across faces, its counts and
/// its centre.
void planCell(const PolyMesh& mesh,
              const CellCorners& corners,
              Label cell,
              SubdivisionPlan& plan,
              BlockResult& result) {
    plan.firstPart[index(cell) + 1] = corners.partCount();
    plan.firstApex[index(cell) + 1] = corners.apexCount();
    for (const CellCorners::Corner& c : corners.corners())
        if (mesh.owner[index(c.face)] != cell || !mesh.isInternal(c.face))
            plan.partAcross[index(c.position)] = c.facePart;
    const Label hexahedra = toLabel(corners.nodes().size()) - corners.apexCount();
    result.hexahedra += hexahedra;
    result.pyramids += corners.partCount() - hexahedra;
    const std::size_t first = result.apices.size();
    PartPoints parts{corners, plan.layout, plan.points, {}, plan.layout.firstApex, cell};
    if (isNeverRight(parts)) {
        addApices(parts, Apices::means, result.apices);
        result.inverted.push_back(cell);
        return;
    }
    const auto place = [&] {
        result.apices.resize(first);
        addApices(parts, Apices::best, result.apices);
        parts.apices = std::span<const Vec3>(result.apices).subspan(first);
        return !hasInvertedInside(parts);
    };
    if (place()) return;
    Vec3& centre = plan.points[index(plan.layout.firstCell + cell)];
    const Vec3 start = centre;
    centre = cellPoint(parts, start);
    if (centre != start && place()) return;
    result.inverted.push_back(cell);
}

void requireFits(std::int64_t count, const char* what) {
    require(count <= std::numeric_limits<Label>::max(),
            "the divided mesh would have {} {}, more than labels of {} bits can number; configure "
            "with POLYMESH_LABEL64",
            count,
            what,
            8 * sizeof(Label));
}

/// Turns counts, kept one place later, into first places.
void finishCounting(std::vector<Label>& first, const char* what) {
    std::int64_t sum = 0;
    for (Label& count : first) {
        sum += count;
        requireFits(sum, what);
        count = static_cast<Label>(sum);
    }
}

void joinBlocks(const std::vector<BlockResult>& blocks, SubdivisionPlan& plan) {
    finishCounting(plan.firstPart, "cells");
    finishCounting(plan.firstApex, "points");
    requireFits(static_cast<std::int64_t>(plan.points.size()) + plan.firstApex.back(), "points");
    plan.points.reserve(plan.points.size() + index(plan.firstApex.back()));
    for (const BlockResult& block : blocks) {
        plan.hexahedra += block.hexahedra;
        plan.pyramids += block.pyramids;
        plan.points.insert(plan.points.end(), block.apices.begin(), block.apices.end());
        plan.inverted.insert(plan.inverted.end(), block.inverted.begin(), block.inverted.end());
    }
}

} // namespace

PartPoints SubdivisionPlan::parts(const CellCorners& corners, Label cell) const {
    const std::span<const Vec3> all = points;
    const Label first = layout.firstApex + firstApex[index(cell)];
    return {corners, layout, all, all.subspan(index(first)), first, cell};
}

SubdivisionPlan planSubdivision(const PolyMesh& mesh, const Bends& bends) {
    SubdivisionPlan plan;
    requireFits(8 * static_cast<std::int64_t>(mesh.faces.values.size()), "corners of faces");
    plan.edges = numberEdges(mesh);
    plan.cellFaces = cellFaces(mesh);
    placeSharedPoints(mesh, plan);
    placeBends(mesh, bends, plan);
    plan.firstPart.assign(index(mesh.cellCount) + 1, 0);
    plan.firstApex.assign(index(mesh.cellCount) + 1, 0);
    plan.partAcross.assign(mesh.faces.values.size(), -1);
    const DividedMesh divided{mesh, plan.edges, plan.cellFaces};
    std::vector<BlockResult> blocks(index((mesh.cellCount + cellsPerBlock - 1) / cellsPerBlock));
    parallelBlocks(mesh.cellCount, cellsPerBlock, [&](Label block, Label first, Label last) {
        CellCorners corners;
        for (Label cell = first; cell < last; ++cell) {
            if (!corners.load(divided, cell))
                throw InputError(fmt::format("cell {} is not closed", cell));
            planCell(mesh, corners, cell, plan, blocks[index(block)]);
        }
    });
    joinBlocks(blocks, plan);
    return plan;
}

std::vector<Label>
invertedCells(const PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> cells) {
    std::vector<char> isBad(cells.size(), 0);
    const DividedMesh divided{mesh, plan.edges, plan.cellFaces};
    parallelBlocks(toLabel(cells.size()), cellsPerBlock, [&](Label, Label first, Label last) {
        CellCorners corners;
        for (Label i = first; i < last; ++i) {
            corners.load(divided, cells[index(i)]);
            isBad[index(i)] = hasInvertedPart(plan.parts(corners, cells[index(i)])) ? 1 : 0;
        }
    });
    std::vector<Label> bad;
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (isBad[i] != 0) bad.push_back(cells[i]);
    return bad;
}

SubdivisionCounts demandedCounts(const PolyMesh& mesh) {
    return demandedCounts(mesh, [](Label) { return true; });
}

SubdivisionCounts demandedCounts(const PolyMesh& mesh,
                                 const std::function<bool(Label)>& isDivided) {
    const Rows<Label> faces = cellFaces(mesh);
    const auto countOf = [&](Label cell) {
        SubdivisionCounts counts;
        if (!isDivided(cell)) return counts;
        std::vector<Label> points;
        for (const Label face : faces[cell])
            points.insert(points.end(), mesh.faces[face].begin(), mesh.faces[face].end());
        std::ranges::sort(points);
        for (std::size_t i = 0; i < points.size();) {
            std::size_t end = i;
            while (end < points.size() && points[end] == points[i])
                ++end;
            if (end - i == 3)
                ++counts.hexahedra;
            else
                counts.pyramids += 2 * static_cast<std::int64_t>(end - i);
            i = end;
        }
        return counts;
    };
    return parallelReduce(
        mesh.cellCount,
        SubdivisionCounts{},
        countOf,
        [](const SubdivisionCounts& a, const SubdivisionCounts& b) {
            return SubdivisionCounts{a.hexahedra + b.hexahedra, a.pyramids + b.pyramids};
        });
}

} // namespace polymesh
