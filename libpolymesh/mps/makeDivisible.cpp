// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/makeDivisible.h"

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/splitFaces.h"
#include "libpolymesh/mps/untangle.h"
#include "libpolymesh/quality/convexDecomposition.h"

#include <algorithm>
#include <utility>

namespace polymesh {

namespace {

void splitFaces(Divisible& work, const FaceSplitRule& rule) {
    const auto pieces = piecesOfFaces(work.mesh, work.plan, work.plan.inverted, rule);
    if (pieces.empty()) return;
    work.splitFaces += toLabel(pieces.size());
    work.mesh = withPieces(std::move(work.mesh), pieces);
    work.plan = planSubdivision(work.mesh);
    work.movedPoints = untangle(work.mesh, work.plan);
}

/// Returns whether there were any.
bool makeCones(Divisible& work) {
    const auto cones = conesOf(work.mesh, work.plan, work.plan.inverted);
    if (cones.empty()) return false;
    const Label before = work.mesh.cellCount;
    work.conedCells += toLabel(cones.size());
    work.mesh = withCones(std::move(work.mesh), work.plan.cellFaces, cones);
    work.newCells += work.mesh.cellCount - before;
    work.plan = planSubdivision(work.mesh);
    work.movedPoints = untangle(work.mesh, work.plan);
    return true;
}

void helpLocally(Divisible& work) {
    constexpr double straight = 1e-3; // corners that are hardly convex, beside concave ones
    constexpr int rounds = 3;
    for (int round = 0; round < rounds && !work.plan.inverted.empty(); ++round) {
        splitFaces(work, {straight, round > 0});
        if (!makeCones(work) && round > 0) break;
    }
}

/// Splits the faces of the cells that are left from their middles, and makes cones over those.
void makeTetrahedra(Divisible& work) {
    const auto fans = fansOfFaces(work.mesh, work.plan, work.plan.inverted);
    if (fans.empty()) return;
    work.splitFaces += toLabel(fans.size());
    work.mesh = withPieces(std::move(work.mesh), fans);
    work.plan = planSubdivision(work.mesh);
    work.movedPoints = untangle(work.mesh, work.plan);
    makeCones(work);
    helpLocally(work);
}

/// The cells of which a part has next to no volume; origins: the cell that each cell is a part of.
std::vector<Label>
cellsWithFlatParts(const PolyMesh& old, const PolyMesh& cut, std::span<const Label> origins) {
    constexpr double flat = 1e-9; // of the whole's volume
    const std::vector<double> whole = computeGeometry(old).cellVolumes;
    const std::vector<double> parts = computeGeometry(cut).cellVolumes;
    std::vector<Label> cells;
    for (std::size_t part = 0; part < parts.size(); ++part)
        if (parts[part] < flat * whole[index(origins[part])]) cells.push_back(origins[part]);
    std::ranges::sort(cells);
    return cells;
}

/// Cuts the cells that are left into convex ones where they are concave (holes through a cell, no
/// point that sees all faces). Returns false when that changes nothing, or spoils the mesh.
bool cutConcave(Divisible& work) {
    std::vector<Label> cells = work.plan.inverted;
    std::vector<Label> origins;
    PolyMesh cut = work.mesh;
    DecompositionCounts counts = decomposeCells(cut, cells, {}, &origins);
    const std::vector<Label> flat = cellsWithFlatParts(work.mesh, cut, origins);
    if (!flat.empty()) {
        std::erase_if(cells, [&](Label c) { return std::ranges::binary_search(flat, c); });
        cut = work.mesh;
        counts = decomposeCells(cut, cells);
    }
    if (counts.cuts + counts.cellPoints + counts.splitFaces == 0 || !validate(cut).empty())
        return false;
    work.cutCells += counts.cuts;
    work.newCells += cut.cellCount - work.mesh.cellCount;
    work.mesh = std::move(cut);
    work.plan = planSubdivision(work.mesh);
    work.movedPoints = untangle(work.mesh, work.plan);
    return true;
}

} // namespace

Divisible makeDivisible(PolyMesh mesh) {
    constexpr double bent = 0; // corners that are concave
    constexpr int attempts = 2;
    Divisible work;
    work.mesh = std::move(mesh);
    work.plan = planSubdivision(work.mesh);
    work.firstInverted = toLabel(work.plan.inverted.size());
    work.movedPoints = untangle(work.mesh, work.plan);
    splitFaces(work, {bent});
    makeCones(work);
    helpLocally(work);
    for (int i = 0; i < attempts && !work.plan.inverted.empty(); ++i) {
        if (cutConcave(work)) helpLocally(work);
        makeTetrahedra(work);
    }
    return work;
}

} // namespace polymesh
