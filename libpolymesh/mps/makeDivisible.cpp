// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/makeDivisible.h"

#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/splitFaces.h"
#include "libpolymesh/mps/untangle.h"
#include "libpolymesh/quality/convexDecomposition.h"

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

/// Cuts the cells that are left into convex ones where they are concave (holes through a cell, no
/// point that sees all faces). Returns false when that changes nothing, or spoils the mesh.
bool cutConcave(Divisible& work) {
    PolyMesh cut = work.mesh;
    const DecompositionCounts counts = decomposeCells(cut, work.plan.inverted);
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
