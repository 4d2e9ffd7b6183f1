// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/makeDivisible.h"

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/joinCells.h"
#include "libpolymesh/mps/keepVolume.h"
#include "libpolymesh/mps/loopCuts.h"
#include "libpolymesh/mps/meshRegion.h"
#include "libpolymesh/mps/remedies.h"
#include "libpolymesh/mps/splitFaces.h"
#include "libpolymesh/mps/untangle.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

namespace polymesh {

namespace {

/// Corners of faces below this are hardly convex (splitFaces.h).
constexpr double straight = 1e-3;

/// What is worked on: a mesh, or a region of one.
struct Work {
    EditedMesh edited;
    SubdivisionPlan plan;
    DivisibleCounts counts;

    const PolyMesh& mesh() const { return edited.mesh; }

    Label firstRimFace() const { return mesh().faceCount() - edited.rimFaces; }
};

/// The cells with inverted parts, ascending, but for those at the rim of the region: splitting
/// their faces could give cells outside two edges between the same points.
std::vector<Label> cellsToHelp(const Work& work) {
    std::vector<Label> atRim;
    for (Label face = work.firstRimFace(); face < work.mesh().faceCount(); ++face)
        atRim.push_back(work.mesh().owner[index(face)]);
    std::ranges::sort(atRim);
    std::vector<Label> cells;
    std::ranges::set_difference(work.plan.inverted, atRim, std::back_inserter(cells));
    return cells;
}

void planAgain(Work& work) {
    work.plan = planSubdivision(work.mesh(), work.edited.bends);
    work.counts.movedPoints = untangle(work.mesh(), work.plan);
}

/// Replaces faces by their pieces.
void split(Work& work, std::span<const FacePieces> pieces) {
    const Label internal = work.mesh().internalFaceCount();
    std::vector<Label>& from = work.edited.boundaryFrom;
    std::vector<Label> newFrom;
    auto next = pieces.begin();
    while (next != pieces.end() && next->face < internal)
        ++next;
    for (Label i = 0; i < toLabel(from.size()); ++i) {
        std::size_t count = 1;
        if (next != pieces.end() && next->face == internal + i) count = (next++)->pieces.size();
        newFrom.insert(newFrom.end(), count, from[index(i)]);
    }
    from = std::move(newFrom);
    work.counts.splitFaces += toLabel(pieces.size());
    work.edited.mesh = withPieces(std::move(work.edited.mesh), pieces);
}

/// Replaces cells by their parts. Returns how many more there are.
Label cut(Work& work, const Rows<Label>& cellFaces, std::span<const CellCones> parts) {
    const Label before = work.mesh().cellCount;
    work.edited.mesh = withCones(std::move(work.edited.mesh), cellFaces, parts);
    work.edited.cellFrom.resize(index(work.mesh().cellCount), -1);
    work.counts.newCells += work.mesh().cellCount - before;
    return work.mesh().cellCount - before;
}

/// Joins cells; the second of each pair in order goes.
void join(Work& work, std::span<const std::pair<Label, Label>> pairs) {
    std::vector<Label> gone;
    for (const auto& [a, b] : pairs)
        gone.push_back(std::max(a, b));
    std::ranges::sort(gone, std::greater{});
    for (const Label cell : gone)
        work.edited.cellFrom.erase(work.edited.cellFrom.begin() + cell);
    work.counts.joinedCells += toLabel(pairs.size());
    work.edited.mesh = withJoinedCells(std::move(work.edited.mesh), pairs);
}

void addCounts(const DivisibleCounts& part, DivisibleCounts& counts) {
    counts.splitFaces += part.splitFaces;
    counts.conedCells += part.conedCells;
    counts.cutCells += part.cutCells;
    counts.joinedCells += part.joinedCells;
    counts.newCells += part.newCells;
}

/// Takes a step on the mesh round the cells that are left, and plans the whole again.
template<class Step>
void inRegion(Work& work, Step&& step) {
    if (cellsToHelp(work).empty()) return;
    const MeshRegion region = regionRound(work.edited, work.plan.inverted);
    Work part{region.part, {}, {}};
    planAgain(part);
    step(part);
    addCounts(part.counts, work.counts);
    work.edited = withRegion(work.edited, region, part.edited);
    planAgain(work);
}

/// Splits faces of cells that are stars, which others would only suffer from.
void splitFaces(Work& work, const FaceSplitRule& rule) {
    const auto cells = starCells(work.mesh(), work.plan, cellsToHelp(work));
    const auto pieces = piecesOfFaces(work.mesh(), work.edited.bends, work.plan, cells, rule);
    if (pieces.empty()) return;
    split(work, pieces);
    work.plan = planSubdivision(work.mesh(), work.edited.bends);
}

/// Splits concave faces so that cells can be cut along the diagonals: until they are, no moving of
/// points can help.
void splitByDiagonals(Work& work) {
    const auto pieces = diagonalsOf(work.mesh(), work.edited.bends, work.plan, cellsToHelp(work));
    if (pieces.empty()) return;
    split(work, pieces);
    work.plan = planSubdivision(work.mesh(), work.edited.bends);
}

/// Cuts cells along loops of their own edges.
void cutAlongLoops(Work& work) {
    const auto cuts = loopCutsOf(work.mesh(), work.edited.bends, work.plan, cellsToHelp(work));
    if (cuts.empty()) return;
    work.counts.cutCells += cut(work, work.plan.cellFaces, cuts);
    planAgain(work);
}

/// Returns whether there were any.
bool makeCones(Work& work) {
    const auto cones = conesOf(work.mesh(), work.edited.bends, work.plan, cellsToHelp(work));
    if (cones.empty()) return false;
    work.counts.conedCells += toLabel(cones.size());
    cut(work, work.plan.cellFaces, cones);
    planAgain(work);
    return true;
}

/// The edges at which there are cells outside the region, ascending.
std::vector<Edge> rimEdges(const Work& work) {
    std::vector<Edge> edges;
    const PolyMesh& mesh = work.mesh();
    for (Label face = work.firstRimFace(); face < mesh.faceCount(); ++face) {
        const auto loop = mesh.faces[face];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const auto [low, high] = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
            edges.push_back({low, high});
        }
    }
    std::ranges::sort(edges);
    return edges;
}

/// The bends of this kind in the edges of cells that are left.
template<class IsKind>
Bends bendsOf(const Work& work, const IsKind& isKind) {
    Bends bends;
    for (const Label cell : cellsToHelp(work))
        for (const Label face : work.plan.cellFaces[cell]) {
            const auto loop = work.mesh().faces[face];
            for (std::size_t i = 0; i < loop.size(); ++i)
                if (const Bend* bend =
                        findBend(work.edited.bends, loop[i], loop[(i + 1) % loop.size()]);
                    bend != nullptr && isKind(cell, *bend))
                    bends.push_back(*bend);
        }
    std::ranges::sort(bends, {}, &Bend::ends);
    const auto isSame = [](const Bend& a, const Bend& b) { return a.ends == b.ends; };
    bends.erase(std::unique(bends.begin(), bends.end(), isSame), bends.end());
    const std::vector<Edge> rim = rimEdges(work);
    std::erase_if(bends,
                  [&](const Bend& bend) { return std::ranges::binary_search(rim, bend.ends); });
    return bends;
}

/// Makes points of the bends of cells that are left where faces can not be split as if the edge
/// were straight: of edges that bend much, and of all edges of cells that have triangles only.
bool straightenEdges(Work& work) {
    constexpr double slight = 0.02; // of the edge's length
    const PolyMesh& mesh = work.mesh();
    const auto hasTriangles = [&](Label cell) {
        return std::ranges::all_of(std::as_const(work.plan.cellFaces)[cell],
                                   [&](Label f) { return mesh.faces.rowSize(f) == 3; });
    };
    const Bends straightened = bendsOf(work, [&](Label cell, const Bend& bend) {
        const Vec3& a = mesh.points[index(bend.ends[0])];
        const Vec3 along = mesh.points[index(bend.ends[1])] - a;
        return norm(cross(along, bend.at - a)) > slight * squaredNorm(along) || hasTriangles(cell);
    });
    if (straightened.empty()) return false;
    work.edited.mesh = withBendsAsPoints(std::move(work.edited.mesh), straightened);
    std::erase_if(work.edited.bends, [&](const Bend& bend) {
        return findBend(straightened, bend.ends[0], bend.ends[1]) != nullptr;
    });
    planAgain(work);
    return true;
}

/// Splits faces, at concave corners first, and cuts cells along the new edges.
void splitAndCut(Work& work) {
    constexpr double bent = 0;
    for (const auto& rule : {FaceSplitRule{bent, false}, {straight, false}, {straight, true}}) {
        splitFaces(work, rule);
        cutAlongLoops(work);
    }
}

/// Makes cones, and splits faces of cells of which it has not come to good cones yet.
void helpLocally(Work& work) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
        splitFaces(work, {straight, round > 0});
        if (!makeCones(work) && round > 0) break;
    }
}

/// Cuts cells along loops through their reflex edges.
void cutWhereConcave(Work& work) {
    splitByDiagonals(work);
    cutAlongLoops(work);
}

/// Again, where bends were in the way.
void straightenAndCut(Work& work) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds && straightenEdges(work); ++round)
        cutWhereConcave(work);
}

/// Joins cells that no cut could help with neighbours, while these are still whole.
void joinHopeless(Work& work, const KeptZones& zones) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
        const Remedies remedies = remediesOf(work.mesh(), work.plan, cellsToHelp(work), zones);
        if (remedies.joined.empty()) return;
        join(work, remedies.joined);
        planAgain(work);
    }
}

/// Takes the next step of the last resort; false when there is none.
bool useRemedies(Work& work, const KeptZones& zones) {
    const Remedies remedies = remediesOf(work.mesh(), work.plan, cellsToHelp(work), zones);
    if (remedies.empty()) return false;
    std::vector<Vec3>& points = work.edited.mesh.points;
    points.insert(points.end(), remedies.points.begin(), remedies.points.end());
    split(work, remedies.faces);
    work.counts.conedCells += toLabel(remedies.cells.size());
    cut(work, cellFaces(work.mesh()), remedies.cells);
    join(work, remedies.joined);
    planAgain(work);
    return true;
}

/// Whatever it takes: cells that are left become tetrahedra, step by step, and neighbours that
/// suffer from it cones.
void becomeTetrahedra(Work& work, const KeptZones& zones) {
    constexpr int rounds = 16;
    for (int round = 0; round < rounds && !work.plan.inverted.empty(); ++round) {
        if (round > 0) helpLocally(work);
        straightenEdges(work);
        if (!useRemedies(work, zones)) break;
    }
}

/// Takes a step on the mesh round the cells that are left, and again as long as there are fewer.
template<class Step>
void inRegions(Work& work, Step&& step) {
    constexpr int rounds = 4;
    for (int round = 0; round < rounds && !work.plan.inverted.empty(); ++round) {
        const std::size_t before = work.plan.inverted.size();
        inRegion(work, step);
        if (work.plan.inverted.size() >= before) break;
    }
}

/// All that helps, the gentlest first; the regions shrink with the number of cells left.
void help(Work& work, const KeptZones& zones) {
    cutWhereConcave(work);
    inRegions(work, [&](Work& rest) {
        straightenAndCut(rest);
        joinHopeless(rest, zones);
        splitAndCut(rest);
        makeCones(rest);
        inRegions(rest, [&](Work& last) {
            helpLocally(last);
            becomeTetrahedra(last, zones);
        });
    });
}

} // namespace

Divisible makeDivisible(PolyMesh mesh, const KeptZones& zones) {
    const std::vector<FaceGeometry> boundary = boundaryGeometry(mesh);
    Work work;
    work.edited.mesh = std::move(mesh);
    work.edited.bends = takeBends(work.edited.mesh);
    work.edited.cellFrom.resize(index(work.mesh().cellCount));
    std::iota(work.edited.cellFrom.begin(), work.edited.cellFrom.end(), 0);
    work.edited.boundaryFrom.resize(boundary.size());
    std::iota(work.edited.boundaryFrom.begin(), work.edited.boundaryFrom.end(), 0);
    work.plan = planSubdivision(work.mesh(), work.edited.bends);
    work.counts.firstInverted = toLabel(work.plan.inverted.size());
    work.counts.movedPoints = untangle(work.mesh(), work.plan);
    inRegions(work, [&](Work& part) { help(part, zones); });
    keepVolume(work.mesh(), work.edited.boundaryFrom, boundary, work.plan);
    return {std::move(work.edited.mesh),
            std::move(work.plan),
            std::move(work.edited.bends),
            work.counts};
}

} // namespace polymesh
