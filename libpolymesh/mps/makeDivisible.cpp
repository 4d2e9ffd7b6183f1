// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/makeDivisible.h"

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/keepVolume.h"
#include "libpolymesh/mps/loopCuts.h"
#include "libpolymesh/mps/splitFaces.h"
#include "libpolymesh/mps/untangle.h"
#include "libpolymesh/quality/convexDecomposition.h"

#include <algorithm>
#include <array>
#include <utility>

namespace polymesh {

namespace {

void planAgain(Divisible& work) {
    work.plan = planSubdivision(work.mesh, work.bends);
    work.movedPoints = untangle(work.mesh, work.plan);
}

void splitFaces(Divisible& work, const FaceSplitRule& rule) {
    const auto pieces = piecesOfFaces(work.mesh, work.plan, work.plan.inverted, rule);
    if (pieces.empty()) return;
    work.splitFaces += toLabel(pieces.size());
    work.mesh = withPieces(std::move(work.mesh), pieces);
    planAgain(work);
}

/// Splits concave faces so that cells can be cut along the diagonals.
void splitByDiagonals(Divisible& work) {
    const auto pieces = diagonalsOf(work.mesh, work.bends, work.plan, work.plan.inverted);
    if (pieces.empty()) return;
    work.splitFaces += toLabel(pieces.size());
    work.mesh = withPieces(std::move(work.mesh), pieces);
    planAgain(work);
}

/// Cuts cells along loops of their own edges.
void cutAlongLoops(Divisible& work) {
    const auto cuts = loopCutsOf(work.mesh, work.bends, work.plan, work.plan.inverted);
    if (cuts.empty()) return;
    const Label before = work.mesh.cellCount;
    work.mesh = withCones(std::move(work.mesh), work.plan.cellFaces, cuts);
    work.newCells += work.mesh.cellCount - before;
    work.cutCells += work.mesh.cellCount - before;
    planAgain(work);
}

/// Returns whether there were any.
bool makeCones(Divisible& work) {
    const auto cones = conesOf(work.mesh, work.bends, work.plan, work.plan.inverted);
    if (cones.empty()) return false;
    const Label before = work.mesh.cellCount;
    work.conedCells += toLabel(cones.size());
    work.mesh = withCones(std::move(work.mesh), work.plan.cellFaces, cones);
    work.newCells += work.mesh.cellCount - before;
    planAgain(work);
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

/// Makes points of the bends in the edges of the cells that are left.
void straightenEdges(Divisible& work) {
    std::vector<Bend> straightened;
    for (const Label cell : work.plan.inverted)
        for (const Label face : work.plan.cellFaces[cell]) {
            const auto loop = std::as_const(work.mesh.faces)[face];
            for (std::size_t i = 0; i < loop.size(); ++i)
                if (const Bend* bend = findBend(work.bends, loop[i], loop[(i + 1) % loop.size()]))
                    straightened.push_back(*bend);
        }
    std::ranges::sort(straightened, {}, &Bend::ends);
    const auto isSame = [](const Bend& a, const Bend& b) { return a.ends == b.ends; };
    straightened.erase(std::unique(straightened.begin(), straightened.end(), isSame),
                       straightened.end());
    work.mesh = withBendsAsPoints(std::move(work.mesh), straightened);
    std::erase_if(work.bends, [&](const Bend& bend) {
        return findBend(straightened, bend.ends[0], bend.ends[1]) != nullptr;
    });
}

/// Splits the faces of the cells that are left from their middles, and makes cones over those.
void makeTetrahedra(Divisible& work) {
    straightenEdges(work);
    const auto fans = fansOfFaces(work.mesh, work.plan, work.plan.inverted);
    if (fans.empty()) return;
    work.splitFaces += toLabel(fans.size());
    work.mesh = withPieces(std::move(work.mesh), fans);
    planAgain(work);
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
    const PolyMesh uncut = withBendsAsPoints(work.mesh, work.bends);
    PolyMesh cut = uncut;
    DecompositionCounts counts = decomposeCells(cut, cells, {}, &origins);
    const std::vector<Label> flat = cellsWithFlatParts(uncut, cut, origins);
    if (!flat.empty()) {
        std::erase_if(cells, [&](Label c) { return std::ranges::binary_search(flat, c); });
        cut = uncut;
        counts = decomposeCells(cut, cells);
    }
    if (counts.cuts + counts.cellPoints + counts.splitFaces == 0 || !validate(cut).empty())
        return false;
    work.cutCells += counts.cuts;
    work.newCells += cut.cellCount - work.mesh.cellCount;
    work.mesh = std::move(cut);
    work.bends = takeBends(work.mesh);
    planAgain(work);
    return true;
}

/// Which of the ways to help are taken.
struct Way {
    bool takesBends;
    bool cutsAlongLoops;
};

Divisible goThatWay(const PolyMesh& mesh, const Way& way) {
    constexpr double bent = 0;        // corners that are concave
    constexpr double straight = 1e-3; // and those that are hardly convex
    constexpr int attempts = 2;
    Divisible work;
    work.mesh = mesh;
    if (way.takesBends) work.bends = takeBends(work.mesh);
    work.plan = planSubdivision(work.mesh, work.bends);
    work.firstInverted = toLabel(work.plan.inverted.size());
    work.movedPoints = untangle(work.mesh, work.plan);
    if (way.cutsAlongLoops) {
        splitByDiagonals(work);
        cutAlongLoops(work);
        for (const auto& rule : {FaceSplitRule{bent, false}, {straight, false}, {straight, true}}) {
            splitFaces(work, rule);
            cutAlongLoops(work);
        }
    } else {
        splitFaces(work, {bent, false});
    }
    makeCones(work);
    helpLocally(work);
    for (int i = 0; i < attempts && !work.plan.inverted.empty(); ++i) {
        if (cutConcave(work)) helpLocally(work);
        makeTetrahedra(work);
    }
    return work;
}

} // namespace

Divisible makeDivisible(PolyMesh mesh) {
    constexpr Way best{true, true};
    constexpr std::array<Way, 2> others{{{false, true}, {false, false}}};
    Divisible work = goThatWay(mesh, best);
    for (const Way& way : others) {
        if (work.plan.inverted.empty()) break;
        Divisible other = goThatWay(mesh, way);
        if (other.plan.inverted.size() < work.plan.inverted.size()) work = std::move(other);
    }
    std::vector<Label> sizes;
    for (const Patch& patch : mesh.patches)
        sizes.push_back(patch.size);
    keepVolume(work.mesh, sizes, boundaryGeometry(mesh), work.plan);
    return work;
}

} // namespace polymesh
