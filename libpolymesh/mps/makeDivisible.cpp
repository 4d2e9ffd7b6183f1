// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/makeDivisible.h"

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/joinCells.h"
#include "libpolymesh/mps/keepVolume.h"
#include "libpolymesh/mps/loopCuts.h"
#include "libpolymesh/mps/remedies.h"
#include "libpolymesh/mps/splitFaces.h"
#include "libpolymesh/mps/untangle.h"

#include <algorithm>
#include <utility>

namespace polymesh {

namespace {

/// Corners of faces below this are hardly convex (splitFaces.h).
constexpr double straight = 1e-3;

void planAgain(Divisible& work) {
    work.plan = planSubdivision(work.mesh, work.bends);
    work.movedPoints = untangle(work.mesh, work.plan);
}

/// Splits faces of cells that are stars, which others would only suffer from.
void splitFaces(Divisible& work, const FaceSplitRule& rule) {
    const auto cells = starCells(work.mesh, work.plan, work.plan.inverted);
    const auto pieces = piecesOfFaces(work.mesh, work.bends, work.plan, cells, rule);
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

/// Splits faces, at concave corners first, and cuts cells along the new edges.
void splitAndCut(Divisible& work) {
    constexpr double bent = 0;
    for (const auto& rule : {FaceSplitRule{bent, false}, {straight, false}, {straight, true}}) {
        splitFaces(work, rule);
        cutAlongLoops(work);
    }
}

/// Makes cones, and splits faces of cells of which it has not come to good cones yet.
void helpLocally(Divisible& work) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds && !work.plan.inverted.empty(); ++round) {
        splitFaces(work, {straight, round > 0});
        if (!makeCones(work) && round > 0) break;
    }
}

/// The bends of this kind in the edges of cells that are left.
template<class IsKind>
Bends bendsOf(const Divisible& work, const IsKind& isKind) {
    Bends bends;
    for (const Label cell : work.plan.inverted)
        for (const Label face : work.plan.cellFaces[cell]) {
            const auto loop = work.mesh.faces[face];
            for (std::size_t i = 0; i < loop.size(); ++i)
                if (const Bend* bend = findBend(work.bends, loop[i], loop[(i + 1) % loop.size()]);
                    bend != nullptr && isKind(cell, *bend))
                    bends.push_back(*bend);
        }
    std::ranges::sort(bends, {}, &Bend::ends);
    const auto isSame = [](const Bend& a, const Bend& b) { return a.ends == b.ends; };
    bends.erase(std::unique(bends.begin(), bends.end(), isSame), bends.end());
    return bends;
}

/// Makes points of the bends of cells that are left where faces can not be split as if the edge
/// were straight: of edges that bend much, and of all edges of cells that have triangles only.
bool straightenEdges(Divisible& work) {
    constexpr double slight = 0.02; // of the edge's length
    const auto hasTriangles = [&](Label cell) {
        return std::ranges::all_of(std::as_const(work.plan.cellFaces)[cell],
                                   [&](Label f) { return work.mesh.faces.rowSize(f) == 3; });
    };
    const Bends straightened = bendsOf(work, [&](Label cell, const Bend& bend) {
        const Vec3& a = work.mesh.points[index(bend.ends[0])];
        const Vec3 along = work.mesh.points[index(bend.ends[1])] - a;
        return norm(cross(along, bend.at - a)) > slight * squaredNorm(along) || hasTriangles(cell);
    });
    if (straightened.empty()) return false;
    work.mesh = withBendsAsPoints(std::move(work.mesh), straightened);
    std::erase_if(work.bends, [&](const Bend& bend) {
        return findBend(straightened, bend.ends[0], bend.ends[1]) != nullptr;
    });
    planAgain(work);
    return true;
}

/// Cuts cells along loops through their reflex edges.
void cutWhereConcave(Divisible& work) {
    constexpr int rounds = 3;
    splitByDiagonals(work);
    cutAlongLoops(work);
    for (int round = 0; round < rounds && straightenEdges(work); ++round) {
        splitByDiagonals(work);
        cutAlongLoops(work);
    }
}

/// Joins cells that no cut could help with neighbours, while these are still whole.
void joinHopeless(Divisible& work, const KeptZones& zones) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
        const Remedies remedies = remediesOf(work.mesh, work.plan, work.plan.inverted, zones);
        if (remedies.joined.empty()) return;
        work.joinedCells += toLabel(remedies.joined.size());
        work.mesh = withJoinedCells(std::move(work.mesh), remedies.joined);
        planAgain(work);
    }
}

/// Whatever it takes: cells that are left become tetrahedra, step by step, and neighbours that
/// suffer from it cones.
void useRemedies(Divisible& work, const KeptZones& zones) {
    constexpr int rounds = 16;
    for (int round = 0; round < rounds && !work.plan.inverted.empty(); ++round) {
        if (round > 0) helpLocally(work);
        straightenEdges(work);
        const Remedies remedies = remediesOf(work.mesh, work.plan, work.plan.inverted, zones);
        if (remedies.empty()) break;
        const Label before = work.mesh.cellCount;
        work.splitFaces += toLabel(remedies.faces.size());
        work.conedCells += toLabel(remedies.cells.size());
        work.joinedCells += toLabel(remedies.joined.size());
        work.mesh = withRemedies(std::move(work.mesh), remedies);
        work.newCells += work.mesh.cellCount - before + toLabel(remedies.joined.size());
        planAgain(work);
    }
}

} // namespace

Divisible makeDivisible(PolyMesh mesh, const KeptZones& zones) {
    const std::vector<FaceGeometry> boundary = boundaryGeometry(mesh);
    std::vector<Label> sizes;
    for (const Patch& patch : mesh.patches)
        sizes.push_back(patch.size);
    Divisible work;
    work.mesh = std::move(mesh);
    work.bends = takeBends(work.mesh);
    work.plan = planSubdivision(work.mesh, work.bends);
    work.firstInverted = toLabel(work.plan.inverted.size());
    work.movedPoints = untangle(work.mesh, work.plan);
    if (!work.plan.inverted.empty()) {
        cutWhereConcave(work);
        joinHopeless(work, zones);
        splitAndCut(work);
        makeCones(work);
        helpLocally(work);
        useRemedies(work, zones);
    }
    keepVolume(work.mesh, sizes, boundary, work.plan);
    return work;
}

} // namespace polymesh
