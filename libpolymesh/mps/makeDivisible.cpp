// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/makeDivisible.h"

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/joinCells.h"
#include "libpolymesh/mps/keepHexahedra.h"
#include "libpolymesh/mps/keepVolume.h"
#include "libpolymesh/mps/loopCuts.h"
#include "libpolymesh/mps/meshRegion.h"
#include "libpolymesh/mps/rejoinFaces.h"
#include "libpolymesh/mps/remedies.h"
#include "libpolymesh/mps/restoreCells.h"
#include "libpolymesh/mps/slidePoints.h"
#include "libpolymesh/mps/splitFaces.h"
#include "libpolymesh/mps/untangle.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
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
    std::vector<Label>& origin = work.edited.boundaryOrigin;
    std::vector<Label> newFrom;
    std::vector<Label> newOrigin;
    auto next = pieces.begin();
    while (next != pieces.end() && next->face < internal)
        ++next;
    for (Label i = 0; i < toLabel(from.size()); ++i) {
        std::size_t count = 1;
        if (next != pieces.end() && next->face == internal + i) count = (next++)->pieces.size();
        newFrom.insert(newFrom.end(), count, from[index(i)]);
        newOrigin.insert(newOrigin.end(), count, origin[index(i)]);
    }
    from = std::move(newFrom);
    origin = std::move(newOrigin);
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

/// Splits faces of cells that are stars, which others would only suffer from. Returns the cells to
/// help that have such faces.
std::vector<Label> splitFaces(Work& work, const FaceSplitRule& rule) {
    const auto cells = starCells(work.mesh(), work.plan, cellsToHelp(work));
    const auto pieces = piecesOfFaces(work.mesh(), work.edited.bends, work.plan, cells, rule);
    if (pieces.empty()) return {};
    std::vector<Label> touched;
    for (const FacePieces& p : pieces) {
        touched.push_back(work.mesh().owner[index(p.face)]);
        if (work.mesh().isInternal(p.face)) touched.push_back(work.mesh().neighbour[index(p.face)]);
    }
    std::ranges::sort(touched);
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    split(work, pieces);
    work.plan = planSubdivision(work.mesh(), work.edited.bends);
    std::vector<Label> toHelp;
    std::ranges::set_intersection(cellsToHelp(work), touched, std::back_inserter(toHelp));
    return toHelp;
}

/// Splits concave faces so that cells can be cut along the diagonals: until they are, no moving of
/// points can help.
void splitByDiagonals(Work& work) {
    const auto pieces = diagonalsOf(work.mesh(), work.edited.bends, work.plan, cellsToHelp(work));
    if (pieces.empty()) return;
    split(work, pieces);
    work.plan = planSubdivision(work.mesh(), work.edited.bends);
}

/// Cuts cells along loops of their own edges; of `cells` (ascending) only.
void cutAlongLoops(Work& work, std::span<const Label> cells) {
    const auto cuts = loopCutsOf(work.mesh(), work.edited.bends, work.plan, cells);
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
        cutAlongLoops(work, splitFaces(work, rule));
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
    cutAlongLoops(work, cellsToHelp(work));
}

/// Again, where bends were in the way.
void straightenAndCut(Work& work) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds && straightenEdges(work); ++round)
        cutWhereConcave(work);
}

/// Takes the next step of the last resort; false when there is none.
bool useRemedies(Work& work, const RemedyMeans& means) {
    const Remedies remedies = remediesOf(work.mesh(), work.plan, cellsToHelp(work), means);
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

/// Joins the pieces of faces again, and straightens edges, where cells have faces that cross each
/// other as triangles: they have been split as if edges were straight.
void splitAnew(Work& work) {
    const auto cells = crossedCells(work.mesh(), work.plan, cellsToHelp(work));
    if (rejoinFaces(work.edited, work.plan, cells) > 0)
        work.plan = planSubdivision(work.mesh(), work.edited.bends);
}

/// Counts rounds without fewer cells left than ever before. More of them are tried when there are
/// few: along a column of concave cells what is bad travels from one to the next up to its end.
class Patience {
public:
    bool isOver(std::size_t left) {
        constexpr std::size_t few = 10;
        constexpr int least = 2;
        constexpr int most = 12;
        idle_ = left < fewest_ ? 0 : idle_ + 1;
        fewest_ = std::min(fewest_, left);
        return left == 0 || idle_ > (left < few ? most : least);
    }

private:
    int idle_ = 0;
    std::size_t fewest_ = std::numeric_limits<std::size_t>::max();
};

/// Whatever it takes: cells that are left become tetrahedra, step by step, and neighbours that
/// suffer from it cones.
void becomeTetrahedra(Work& work, const RemedyMeans& means) {
    splitAnew(work);
    for (Patience patience; !patience.isOver(work.plan.inverted.size()); helpLocally(work)) {
        straightenEdges(work);
        if (!useRemedies(work, means)) break;
    }
}

/// Takes a step on the mesh round the cells that are left, and again while that helps: what is good
/// for one cell may be bad for its neighbours, which have their turn then.
template<class Step>
void inRegions(Work& work, Step&& step) {
    for (Patience patience; !patience.isOver(work.plan.inverted.size());) {
        if (cellsToHelp(work).empty()) break;
        const std::vector<Label> before = work.plan.inverted;
        inRegion(work, step);
        if (std::ranges::includes(work.plan.inverted, before)) break;
    }
}

/// What keeps cells in few parts.
void helpGently(Work& work) {
    cutWhereConcave(work);
    if (work.plan.inverted.empty()) return;
    inRegion(work, [&](Work& rest) {
        straightenAndCut(rest);
        splitAndCut(rest);
        makeCones(rest);
        helpLocally(rest);
    });
}

/// Moves points of the cells that have faces which cross each other as triangles.
void slideCrossed(Work& work) {
    constexpr std::size_t most = 5;
    const auto cells = crossedCells(work.mesh(), work.plan, work.plan.inverted);
    if (cells.size() > most) return;
    if (slidePoints(work.edited.mesh, work.plan, cells) > 0) planAgain(work);
}

/// Makes cells that nothing could help, and those beside them, whole again, as what was done to one
/// may be what the other suffers from; with a `partner` each of them one with a neighbour.
void restore(Work& work, const RemedyMeans& means, std::optional<Partner> partner) {
    std::set<Label> origins;
    for (const Label cell : work.plan.inverted)
        origins.insert(work.edited.cellFrom[index(cell)]);
    const Label joined = work.counts.joinedCells;
    join(work, piecesRound(work.edited, work.plan.cellFaces, work.plan.inverted));
    work.counts.joinedCells = joined; // only made whole
    work.plan = planSubdivision(work.mesh(), work.edited.bends);
    rejoinFaces(work.edited, work.plan, work.plan.inverted);
    planAgain(work);
    slideCrossed(work);
    if (!partner) return;
    std::vector<Label> cells;
    for (Label cell = 0; cell < work.mesh().cellCount; ++cell)
        if (origins.contains(work.edited.cellFrom[index(cell)])) cells.push_back(cell);
    join(work, partnersOf(work.mesh(), work.plan, cells, means.zones, *partner));
    planAgain(work);
}

/// Helps the cells that are left for good or ill.
void helpWithTetrahedra(Work& work, const RemedyMeans& means) {
    inRegions(work, [&](Work& part) { becomeTetrahedra(part, means); });
    dropUnusedPoints(work.edited);
    planAgain(work);
}

/// Splits the boundary faces that stem from these (ascending) from their middles, after making the
/// cells at them whole again, so that they hold what they should.
void splitFromMiddles(Work& work, const RemedyMeans& means, std::span<const Label> undivided) {
    const auto boundary = [&] {
        std::vector<Label> faces;
        for (Label i = 0; i < toLabel(work.edited.boundaryFrom.size()); ++i)
            if (std::ranges::binary_search(undivided, work.edited.boundaryFrom[index(i)]))
                faces.push_back(work.mesh().internalFaceCount() + i);
        return faces;
    };
    work.plan.inverted.clear();
    for (const Label face : boundary())
        work.plan.inverted.push_back(work.mesh().owner[index(face)]);
    std::ranges::sort(work.plan.inverted);
    work.plan.inverted.erase(std::unique(work.plan.inverted.begin(), work.plan.inverted.end()),
                             work.plan.inverted.end());
    restore(work, means, std::nullopt);
    const std::vector<Label> faces = boundary();
    const std::vector<FacePieces> fans = fansOf(work.mesh(), faces);
    for (const Label face : faces)
        work.edited.mesh.points.push_back(
            faceGeometry(work.mesh().points, work.mesh().faces[face]).centre);
    split(work, fans);
    planAgain(work);
    helpWithTetrahedra(work, means);
}

/// Does so while the volume that is missing becomes less.
void makeUpVolume(Work& work,
                  const RemedyMeans& means,
                  std::span<const FaceGeometry> boundary,
                  KeptVolume kept) {
    constexpr int rounds = 3;
    constexpr double rounding = 1e-13;
    std::vector<Label> undivided;
    for (int i = 0; i < rounds; ++i) {
        if (std::abs(kept.missing) <= rounding * boundedVolume(work.mesh())) return;
        undivided.insert(undivided.end(), kept.notKept.begin(), kept.notKept.end());
        std::ranges::sort(undivided);
        undivided.erase(std::unique(undivided.begin(), undivided.end()), undivided.end());
        Work again = work;
        splitFromMiddles(again, means, undivided);
        if (again.plan.inverted.size() > work.plan.inverted.size()) return;
        const double before = std::abs(kept.missing);
        kept = keepVolume(again.mesh(), again.edited.boundaryFrom, boundary, {}, again.plan);
        if (!(std::abs(kept.missing) < before)) return;
        work = std::move(again);
    }
}

/// `mesh` has the boundary faces of the undivided mesh.
Work workOn(PolyMesh mesh) {
    Work work;
    work.edited = unedited(std::move(mesh));
    work.edited.bends = takeBends(work.edited.mesh);
    work.plan = planSubdivision(work.mesh(), work.edited.bends);
    work.counts.firstInverted = toLabel(work.plan.inverted.size());
    work.counts.movedPoints = untangle(work.mesh(), work.plan);
    return work;
}

} // namespace

Divisible makeDivisible(PolyMesh mesh, const RemedyMeans& means, Hexahedra hexahedra) {
    constexpr std::array<std::optional<Partner>, 3> restorings{
        std::nullopt, Partner::closest, Partner::uncrossed};
    const std::vector<FaceGeometry> boundary = boundaryGeometry(mesh);
    const Label cells = mesh.cellCount;
    Work work = workOn(std::move(mesh));
    if (!work.plan.inverted.empty()) {
        inRegion(work, helpGently);
        helpWithTetrahedra(work, means);
    }
    for (const auto& partner : restorings) {
        if (work.plan.inverted.empty()) break;
        Work again = work;
        restore(again, means, partner);
        helpWithTetrahedra(again, means);
        if (again.plan.inverted.size() <= work.plan.inverted.size()) work = std::move(again);
    }
    std::vector<Fate> fates;
    if (hexahedra == Hexahedra::kept) fates = fatesOf(work.mesh(), work.plan, work.edited.bends);
    const KeptVolume kept =
        keepVolume(work.mesh(), work.edited.boundaryFrom, boundary, fates, work.plan);
    if (hexahedra == Hexahedra::divided) makeUpVolume(work, means, boundary, kept);
    work.counts.newCells = work.mesh().cellCount - cells;
    return {std::move(work.edited.mesh),
            std::move(work.plan),
            std::move(work.edited.bends),
            work.counts};
}

} // namespace polymesh
