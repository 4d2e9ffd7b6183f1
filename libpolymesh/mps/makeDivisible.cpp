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
    std::vector<Label>& from = work.edited.cellFrom;
    for (const CellCones& c : parts) {
        const Label origin = from[index(c.cell)];
        from.insert(from.end(), index(c.groupCount - 1), origin);
    }
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

/// Takes a step on the mesh round the cells that are left. Nothing outside changes, so that the
/// cells that are left then are those left there; the rest of the plan is void.
template<class Step>
void inRegion(Work& work, Step&& step) {
    const MeshRegion region = regionRound(work.edited, work.plan.inverted);
    Work part{region.part, {}, {}};
    planAgain(part);
    step(part);
    addCounts(part.counts, work.counts);
    JoinedRegion joined = withRegion(work.edited, region, part.edited);
    work.edited = std::move(joined.whole);
    work.plan = {};
    for (const Label cell : part.plan.inverted)
        work.plan.inverted.push_back(joined.cells[index(cell)]);
    std::ranges::sort(work.plan.inverted);
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

/// Takes a step on the mesh round the cells that are left, and again while that helps: what is good
/// for one cell may be bad for its neighbours, which have their turn then.
template<class Step>
void inRegions(Work& work, Step&& step) {
    constexpr int rounds = 20;
    constexpr int patience = 3; // rounds without fewer cells left
    std::size_t fewest = work.plan.inverted.size();
    for (int round = 0, idle = 0; round < rounds && idle < patience; ++round, ++idle) {
        if (cellsToHelp(work).empty()) break;
        const std::vector<Label> before = work.plan.inverted;
        inRegion(work, step);
        if (std::ranges::includes(work.plan.inverted, before)) break;
        if (work.plan.inverted.size() < fewest) idle = 0;
        fewest = std::min(fewest, work.plan.inverted.size());
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

/// Does all that helps. `mesh` has the boundary faces of the undivided mesh.
Work prepared(PolyMesh mesh, const KeptZones& zones) {
    constexpr int rounds = 2;
    Work work;
    work.edited.boundaryFrom.resize(index(mesh.faceCount() - mesh.internalFaceCount()));
    std::iota(work.edited.boundaryFrom.begin(), work.edited.boundaryFrom.end(), 0);
    work.edited.cellFrom.resize(index(mesh.cellCount));
    std::iota(work.edited.cellFrom.begin(), work.edited.cellFrom.end(), 0);
    work.edited.mesh = std::move(mesh);
    work.edited.bends = takeBends(work.edited.mesh);
    work.plan = planSubdivision(work.mesh(), work.edited.bends);
    work.counts.firstInverted = toLabel(work.plan.inverted.size());
    work.counts.movedPoints = untangle(work.mesh(), work.plan);
    for (int round = 0; round < rounds && !work.plan.inverted.empty(); ++round) {
        inRegions(work, [&](Work& part) { help(part, zones); });
        planAgain(work);
    }
    return work;
}

/// Joins cells of the undivided mesh that nothing could help with neighbours that are still whole.
/// Returns how many.
Label joinOrigins(const Work& work, PolyMesh& mesh, const KeptZones& zones) {
    std::vector<Label> origins;
    for (const Label cell : work.plan.inverted)
        origins.push_back(work.edited.cellFrom[index(cell)]);
    std::ranges::sort(origins);
    origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
    const auto pairs = partnersOf(mesh, planSubdivision(mesh), origins, zones);
    mesh = withJoinedCells(std::move(mesh), pairs);
    return toLabel(pairs.size());
}

} // namespace

Divisible makeDivisible(PolyMesh mesh, const KeptZones& zones) {
    constexpr int rounds = 3;
    const std::vector<FaceGeometry> boundary = boundaryGeometry(mesh);
    Work work = prepared(mesh, zones);
    const Label firstInverted = work.counts.firstInverted;
    Label joined = 0;
    for (int round = 0; round < rounds && !work.plan.inverted.empty(); ++round) {
        const Label more = joinOrigins(work, mesh, zones);
        if (more == 0) break;
        joined += more;
        Work again = prepared(mesh, zones);
        again.counts.joinedCells += joined;
        if (again.plan.inverted.size() < work.plan.inverted.size()) work = std::move(again);
    }
    work.counts.firstInverted = firstInverted;
    keepVolume(work.mesh(), work.edited.boundaryFrom, boundary, work.plan);
    return {std::move(work.edited.mesh),
            std::move(work.plan),
            std::move(work.edited.bends),
            work.counts};
}

} // namespace polymesh
