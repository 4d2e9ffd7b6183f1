// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/remedies.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mps/cellLoops.h"
#include "libpolymesh/mps/joinCells.h"
#include "libpolymesh/mps/searchCells.h"
#include "libpolymesh/mps/splitFaces.h"
#include "libpolymesh/mps/triangulatedFaces.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <set>

namespace polymesh {

namespace {

using SeenFace = TriangulatedFaces::SeenFace;

/// The next step for a cell.
struct Step {
    bool isHopeless = false; // its triangles cross
    bool splitsFaces = false;
    bool needsFilling = false; // no point sees all triangles
    std::optional<CellCones> cones;
    std::vector<Label> partners;
};

/// The cells and those beside them, with which they may be joined, ascending.
std::vector<Label>
withNeighbours(const PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> cells) {
    std::vector<Label> around;
    for (const Label face : facesOf(plan, cells)) {
        around.push_back(mesh.owner[index(face)]);
        if (mesh.isInternal(face)) around.push_back(mesh.neighbour[index(face)]);
    }
    std::ranges::sort(around);
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return around;
}

/// Looks at cells with faces of triangles.
class RemedySearch {
public:
    /// `cells`: those of which the faces are triangles.
    RemedySearch(const PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> cells)
        : mesh_(mesh), plan_(plan), faces_(mesh, plan, facesOf(plan, cells)) {}

    TriangulatedFaces& faces() { return faces_; }

    /// The next step of a cell that is not joined.
    Step stepOf(Label cell) const {
        const auto faces = plan_.cellFaces[cell];
        const TriangleHull hull = faces_.hullOf(cell);
        const auto centre = pointThatSees(hull);
        Step step;
        step.splitsFaces =
            std::ranges::any_of(faces, [&](Label f) { return mesh_.faces.rowSize(f) > 3; });
        step.isHopeless = !centre && (faces.size() == 4 || crossingsOf(hull) > 0);
        step.needsFilling = !centre && !step.isHopeless && !step.splitsFaces;
        if (centre && !step.splitsFaces) step.cones = tetrahedraOver(cell, *centre, faces.size());
        return step;
    }

    bool isStar(Label cell) const { return pointThatSees(faces_.hullOf(cell)).has_value(); }

    bool isCrossed(Label cell) const {
        const TriangleHull hull = faces_.hullOf(cell);
        return !pointThatSees(hull) && crossingsOf(hull) > 0;
    }

    TriangleHull hullOf(Label cell) const { return faces_.hullOf(cell); }

    std::vector<Triangle> trianglesOf(Label face) const { return faces_.of(face); }

    /// Of the groups of up to so many neighbours that with which the cell has fewest crossings, and
    /// fewer than `most`; none.
    std::vector<Label>
    partnersOf(Label cell, std::size_t size, Label most, const KeptZones& zones) const {
        constexpr std::size_t mostFaces = 150;
        std::pair<Label, std::size_t> bestScore{most, 0};
        std::vector<Label> chosen;
        for (std::vector<Label>& group : groupsRound(cell, size)) {
            group.push_back(cell);
            const std::vector<SeenFace> seen = outsideOf(group, zones);
            if (seen.empty() || seen.size() > mostFaces) continue;
            const std::pair score{crossings(faces_.hullOf(seen)), seen.size()};
            if (score >= bestScore) continue;
            bestScore = score;
            chosen = std::move(group);
        }
        std::erase(chosen, cell);
        return chosen;
    }

    /// The neighbour with which the cell shares most area of those that it can be joined with;
    /// none.
    std::vector<Label> closestTo(Label cell, const KeptZones& zones) const {
        double most = 0;
        std::vector<Label> closest;
        for (const std::vector<Label>& group : groupsRound(cell, 1)) {
            if (outsideOf(std::vector<Label>{cell, group[0]}, zones).empty()) continue;
            double area = 0;
            for (const Label face : plan_.cellFaces[cell])
                if (mesh_.isInternal(face) && (mesh_.owner[index(face)] == group[0] ||
                                               mesh_.neighbour[index(face)] == group[0]))
                    area += norm(faceGeometry(mesh_.points, mesh_.faces[face]).area);
            if (area > most) closest = group;
            most = std::max(most, area);
        }
        return closest;
    }

    /// How many triangles of the cell cross; -1 when a point sees all.
    Label crossings(Label cell) const { return crossings(faces_.hullOf(cell)); }

private:
    static Label crossings(const TriangleHull& hull) {
        return pointThatSees(hull) ? -1 : crossingsOf(hull);
    }

    static CellCones tetrahedraOver(Label cell, const Vec3& centre, std::size_t faces) {
        CellCones cones{cell, {centre}, std::vector<int>(faces), static_cast<int>(faces), {}};
        std::iota(cones.groupOf.begin(), cones.groupOf.end(), 0);
        return cones;
    }

    /// The neighbours of a cell in groups of up to so many.
    std::vector<std::vector<Label>> groupsRound(Label cell, std::size_t most) const {
        std::vector<Label> neighbours = withNeighbours(mesh_, plan_, std::span(&cell, 1));
        std::erase(neighbours, cell);
        std::vector<std::vector<Label>> groups;
        groups.reserve(neighbours.size());
        for (const Label other : neighbours)
            groups.push_back({other});
        for (std::size_t i = 0; i < groups.size(); ++i)
            for (const Label other : neighbours) {
                if (groups[i].size() == most || other <= groups[i].back()) continue;
                groups.push_back(groups[i]);
                groups.back().push_back(other);
            }
        return groups;
    }

    /// The faces round some cells; none when joining these would leave points of no face, edges of
    /// four faces, or zones that end within a cell.
    std::vector<SeenFace> outsideOf(std::span<const Label> cells, const KeptZones& zones) const {
        const auto isOne = [&](Label c) { return std::ranges::find(cells, c) != cells.end(); };
        std::vector<SeenFace> seen;
        std::set<Label> kept;
        std::set<Label> lost;
        std::vector<Polygon> loops;
        for (const Label face : facesOf(plan_, cells)) {
            const auto loop = mesh_.faces[face];
            const bool isOutward = isOne(mesh_.owner[index(face)]);
            if (isOutward && mesh_.isInternal(face) && isOne(mesh_.neighbour[index(face)])) {
                if (isInZone(mesh_, zones, face)) return {};
                lost.insert(loop.begin(), loop.end());
                continue;
            }
            seen.push_back({face, isOutward});
            kept.insert(loop.begin(), loop.end());
            loops.emplace_back(loop.begin(), loop.end());
            if (!isOutward) std::ranges::reverse(loops.back());
        }
        const auto isInSame = [&](Label c) { return areInSameZones(mesh_, zones, c, cells[0]); };
        if (!isClosed(loops) || !std::ranges::all_of(cells, isInSame) ||
            !std::ranges::includes(kept, lost))
            return {};
        return seen;
    }

    const PolyMesh& mesh_;
    const SubdivisionPlan& plan_;
    TriangulatedFaces faces_;
};

/// Pairs of cells to join, of which none is cut or in two groups; the first of each is the first
/// of its group.
std::vector<std::pair<Label, Label>> pairsOf(std::span<const Label> cells,
                                             std::span<const Step> steps) {
    std::set<Label> taken;
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (steps[i].cones) taken.insert(cells[i]);
    std::vector<std::pair<Label, Label>> pairs;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        std::vector<Label> group = steps[i].partners;
        if (group.empty()) continue;
        group.push_back(cells[i]);
        if (std::ranges::any_of(group, [&](Label c) { return taken.contains(c); })) continue;
        std::ranges::sort(group);
        for (std::size_t k = 1; k < group.size(); ++k)
            pairs.emplace_back(group[0], group[k]);
        taken.insert(group.begin(), group.end());
    }
    return pairs;
}

/// The steps of all cells; those that no cut helps look for a neighbour.
std::vector<Step> stepsOf(const RemedySearch& search,
                          const PolyMesh& mesh,
                          const SubdivisionPlan& plan,
                          std::span<const Label> cells,
                          const RemedyMeans& means) {
    std::vector<Step> steps(cells.size());
    parallelBlocks(toLabel(cells.size()), 1, [&](Label, Label i, Label) {
        steps[index(i)] = search.stepOf(cells[index(i)]);
    });
    for (std::size_t i = 0; i < cells.size(); ++i) {
        Step& step = steps[i];
        if (!step.needsFilling) continue;
        step.cones = tetrahedraIn(cells[i], search.hullOf(cells[i]), means.tetrahedralise);
        step.isHopeless = !step.cones;
    }
    std::vector<Label> hopeless;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!steps[i].isHopeless) continue;
        hopeless.push_back(cells[i]);
        places.push_back(i);
    }
    const std::vector<Label> around = withNeighbours(mesh, plan, hopeless);
    RemedySearch wider(mesh, plan, around);
    wider.faces().avoidCrossings(around);
    parallelBlocks(toLabel(hopeless.size()), 1, [&](Label, Label i, Label) {
        Step& step = steps[places[index(i)]];
        // A flat cell crosses nothing; those round one of its edges may be a star together.
        const Label cell = hopeless[index(i)];
        const bool isFlat = plan.cellFaces.rowSize(cell) == 4;
        step.partners =
            wider.partnersOf(cell, isFlat ? 3 : 2, isFlat ? 0 : wider.crossings(cell), means.zones);
        if (!step.partners.empty()) step.splitsFaces = false;
    });
    return steps;
}

/// The faces to split into triangles, ascending: all of the cells whose step it is, but for those
/// that stay or are lost.
std::vector<Label> facesToSplit(const PolyMesh& mesh,
                                const SubdivisionPlan& plan,
                                std::span<const Label> cells,
                                std::span<const Step> steps,
                                const std::set<std::pair<Label, Label>>& lost) {
    std::vector<Label> split;
    const auto isLost = [&](Label face) {
        return mesh.isInternal(face) &&
               lost.contains({mesh.owner[index(face)], mesh.neighbour[index(face)]});
    };
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!steps[i].splitsFaces) continue;
        for (const Label face : plan.cellFaces[cells[i]])
            if (mesh.faces.rowSize(face) > 3 && !isLost(face)) split.push_back(face);
    }
    std::ranges::sort(split);
    split.erase(std::unique(split.begin(), split.end()), split.end());
    return split;
}

/// The triangles of a face; `middle` is the label of its point if that takes part.
FacePieces piecesFrom(Label face, std::span<const Triangle> triangles, Label middle) {
    FacePieces pieces{face, {}};
    for (const Triangle& t : triangles) {
        pieces.pieces.emplace_back(t.begin(), t.end());
        std::ranges::replace(pieces.pieces.back(), -1, middle);
    }
    return pieces;
}

} // namespace

Remedies remediesOf(const PolyMesh& mesh,
                    const SubdivisionPlan& plan,
                    std::span<const Label> cells,
                    const RemedyMeans& means) {
    RemedySearch search(mesh, plan, cells);
    search.faces().avoidCrossings(cells);
    std::vector<Step> steps = stepsOf(search, mesh, plan, cells, means);
    Remedies remedies;
    remedies.joined = pairsOf(cells, steps);
    std::set<std::pair<Label, Label>> lost;
    for (const auto& [a, b] : remedies.joined)
        lost.insert(std::minmax(a, b));
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (steps[i].cones) remedies.cells.push_back(std::move(*steps[i].cones));
    for (const Label face : facesToSplit(mesh, plan, cells, steps, lost)) {
        const std::vector<Triangle> triangles = search.trianglesOf(face);
        const Label middle = mesh.pointCount() + toLabel(remedies.points.size());
        remedies.faces.push_back(piecesFrom(face, triangles, middle));
        if (std::ranges::any_of(triangles, [](const Triangle& t) { return t[2] < 0; }))
            remedies.points.push_back(plan.points[index(plan.layout.firstFace + face)]);
    }
    return remedies;
}

std::vector<Label>
starCells(const PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> cells) {
    const RemedySearch search(mesh, plan, cells);
    return chosen(cells, [&](Label cell) { return search.isStar(cell); });
}

std::vector<Label>
crossedCells(const PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> cells) {
    const RemedySearch search(mesh, plan, cells);
    return chosen(cells, [&](Label cell) { return search.isCrossed(cell); });
}

std::vector<std::pair<Label, Label>> partnersOf(const PolyMesh& mesh,
                                                const SubdivisionPlan& plan,
                                                std::span<const Label> cells,
                                                const KeptZones& zones,
                                                Partner which) {
    constexpr Label any = std::numeric_limits<Label>::max();
    const std::vector<Label> around = withNeighbours(mesh, plan, cells);
    RemedySearch search(mesh, plan, around);
    if (which == Partner::uncrossed) search.faces().avoidCrossings(around);
    std::vector<Step> steps(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        steps[i].partners = which == Partner::closest ? search.closestTo(cells[i], zones)
                                                      : search.partnersOf(cells[i], 2, any, zones);
    return pairsOf(cells, steps);
}

} // namespace polymesh
