// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/remedies.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mps/cellLoops.h"
#include "libpolymesh/mps/joinCells.h"
#include "libpolymesh/mps/pointWithin.h"
#include "libpolymesh/mps/starPieces.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>

namespace polymesh {

namespace {

/// How a face becomes triangles; -1 stands for its middle.
using FaceTriangles = std::vector<Triangle>;

/// The next step for a cell.
struct Step {
    bool isHopeless = false; // no cut helps
    bool splitsFaces = false;
    std::optional<StarPieces> pieces;
    Label partner = -1;
};

/// How well a polyhedron falls into pieces with a point each that sees all of it.
enum class Outcome { star, pieces, none };

constexpr int mostPieces = 24;

/// Whether the faces of the cells' neighbours are needed too.
enum class Reach { cells, neighbours };

class RemedySearch {
public:
    RemedySearch(const PolyMesh& mesh,
                 const SubdivisionPlan& plan,
                 std::span<const Label> cells,
                 Reach reach)
        : mesh_(mesh), plan_(plan) {
        for (const Label cell : cells)
            faces_.insert(faces_.end(), plan.cellFaces[cell].begin(), plan.cellFaces[cell].end());
        if (reach == Reach::neighbours) addNeighbours();
        std::ranges::sort(faces_);
        faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
        findViewPoints();
        findTriangles();
    }

    /// The next step of a cell that is not joined.
    Step stepOf(Label cell) const {
        const auto faces = plan_.cellFaces[cell];
        Step step;
        step.pieces = cut(seenFaces(faces, {cell, -1}));
        step.isHopeless = !step.pieces;
        step.splitsFaces =
            std::ranges::any_of(faces, [&](Label f) { return mesh_.faces.rowSize(f) > 3; });
        if (step.splitsFaces) step.pieces.reset();
        return step;
    }

    bool isStar(Label cell) const {
        const auto pieces = cut(seenFaces(plan_.cellFaces[cell], {cell, -1}), false);
        return pieces && pieces->centres.size() == 1;
    }

    /// The triangles of a face of the cells or their neighbours.
    const FaceTriangles& trianglesOf(Label face) const {
        return triangles_[static_cast<std::size_t>(std::ranges::lower_bound(faces_, face) -
                                                   faces_.begin())];
    }

    /// The neighbour with which the cell can be cut best; -1: none.
    Label partnerOf(Label cell, const KeptZones& zones) const {
        std::vector<Label> neighbours;
        for (const Label face : plan_.cellFaces[cell])
            if (mesh_.isInternal(face))
                neighbours.push_back(mesh_.owner[index(face)] == cell ? mesh_.neighbour[index(face)]
                                                                      : mesh_.owner[index(face)]);
        std::ranges::sort(neighbours);
        neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
        constexpr std::size_t mostFaces = 40;
        std::pair<Outcome, std::size_t> bestScore{Outcome::none, 0};
        Label chosen = -1;
        for (const Label other : neighbours) {
            const std::vector<SeenFace> seen = outsideOf(cell, other, zones);
            if (seen.empty() || seen.size() > mostFaces) continue;
            const auto pieces = cut(seen);
            const Outcome outcome = !pieces                       ? Outcome::none
                                    : pieces->centres.size() == 1 ? Outcome::star
                                                                  : Outcome::pieces;
            const std::pair score{outcome, seen.size()};
            if (score >= bestScore) continue;
            bestScore = score;
            chosen = other;
        }
        return chosen;
    }

private:
    /// A face and whether its loop runs as seen from outside.
    struct SeenFace {
        Label face;
        bool isOutward;
    };

    /// Faces of the cells' neighbours too, with which they may be joined.
    void addNeighbours() {
        std::vector<Label> around;
        for (const Label face : faces_) {
            if (!mesh_.isInternal(face)) continue;
            around.push_back(mesh_.owner[index(face)]);
            around.push_back(mesh_.neighbour[index(face)]);
        }
        std::ranges::sort(around);
        around.erase(std::unique(around.begin(), around.end()), around.end());
        for (const Label cell : around)
            faces_.insert(faces_.end(), plan_.cellFaces[cell].begin(), plan_.cellFaces[cell].end());
    }

    bool areJoined(Label a, Label b) const {
        const auto [low, high] = std::minmax(a, b);
        return std::ranges::binary_search(plan_.edges.points, Edge{low, high});
    }

    /// A point that is inside all faces of a cell, taken as flat; the cell's own where there is
    /// none.
    Vec3 viewPoint(Label cell) const {
        std::vector<HalfSpace> planes;
        const Vec3 start = plan_.points[index(plan_.layout.firstCell + cell)];
        double reach = 0;
        for (const Label face : plan_.cellFaces[cell]) {
            const FaceGeometry g = faceGeometry(mesh_.points, mesh_.faces[face]);
            const double area = norm(g.area);
            const double sense = mesh_.owner[index(face)] == cell ? -1 : 1;
            if (area > 0) planes.push_back({sense / area * g.area, g.centre});
            for (const Label p : mesh_.faces[face])
                reach = std::max(reach, norm(mesh_.points[index(p)] - start));
        }
        return pointWithin(planes, start, reach).value_or(start);
    }

    void findViewPoints() {
        for (const Label face : faces_) {
            viewCells_.push_back(mesh_.owner[index(face)]);
            if (mesh_.isInternal(face)) viewCells_.push_back(mesh_.neighbour[index(face)]);
        }
        std::ranges::sort(viewCells_);
        viewCells_.erase(std::unique(viewCells_.begin(), viewCells_.end()), viewCells_.end());
        views_.resize(viewCells_.size());
        parallelFor(toLabel(viewCells_.size()),
                    [&](Label i) { views_[index(i)] = viewPoint(viewCells_[index(i)]); });
    }

    const Vec3& viewOf(Label cell) const {
        return views_[static_cast<std::size_t>(std::ranges::lower_bound(viewCells_, cell) -
                                               viewCells_.begin())];
    }

    /// How well the cells on both sides see a triangle of a face: the least sine of the angle
    /// under which, no more than its shape is good.
    double qualityOf(Label face, const Vec3& a, const Vec3& b, const Vec3& c) const {
        const Vec3 n = cross(b - a, c - a);
        const double area = norm(n);
        const double sides = squaredNorm(b - a) + squaredNorm(c - a) + squaredNorm(c - b);
        if (!(area > 0)) return 0;
        const Vec3 middle = (a + b + c) / 3;
        const Vec3 inward = middle - viewOf(mesh_.owner[index(face)]);
        double quality = std::min(area / sides, dot(n, inward) / (area * norm(inward)));
        if (mesh_.isInternal(face)) {
            const Vec3 outward = viewOf(mesh_.neighbour[index(face)]) - middle;
            quality = std::min(quality, dot(n, outward) / (area * norm(outward)));
        }
        return quality;
    }

    const Vec3& middleOf(Label face) const {
        return plan_.points[index(plan_.layout.firstFace + face)];
    }

    FaceTriangles fanOf(Label face) const {
        FaceTriangles fan;
        const auto loop = mesh_.faces[face];
        for (std::size_t i = 0; i < loop.size(); ++i)
            fan.push_back({loop[i], loop[(i + 1) % loop.size()], -1});
        return fan;
    }

    double worstOf(Label face, const FaceTriangles& triangles) const {
        const auto at = [&](Label p) { return p < 0 ? middleOf(face) : mesh_.points[index(p)]; };
        double worst = 1;
        for (const Triangle& t : triangles)
            worst = std::min(worst, qualityOf(face, at(t[0]), at(t[1]), at(t[2])));
        return worst;
    }

    /// By diagonals if that is any good, or as good as from the middle.
    template<class IsFree>
    FaceTriangles bestTriangles(Label face, const IsFree& isFree) const {
        constexpr double good = 0.02;
        const auto at = [&](Label p) { return mesh_.points[index(p)]; };
        const auto loop = mesh_.faces[face];
        if (loop.size() == 3) return {{loop[0], loop[1], loop[2]}};
        FaceTriangles seen = triangulate(loop, isFree, [&](Label a, Label b, Label c) {
            return qualityOf(face, at(a), at(b), at(c));
        });
        const double quality = seen.empty() ? 0 : worstOf(face, seen);
        if (quality > good) return seen;
        FaceTriangles fan = fanOf(face);
        if (worstOf(face, fan) > quality) return fan;
        if (seen.empty()) seen = triangulate(mesh_.points, loop, isFree);
        return seen.empty() ? fan : seen;
    }

    /// All at once, and again, one after the other, those that take a diagonal of another face.
    void findTriangles() {
        triangles_.resize(faces_.size());
        parallelFor(toLabel(faces_.size()), [&](Label i) {
            triangles_[index(i)] =
                bestTriangles(faces_[index(i)], [&](Label a, Label b) { return !areJoined(a, b); });
        });
        std::set<Edge> added;
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            if (mesh_.faces.rowSize(faces_[i]) == 3) continue;
            std::vector<Edge> own = newEdges(triangles_[i]);
            if (std::ranges::any_of(own, [&](const Edge& e) { return added.contains(e); })) {
                triangles_[i] = bestTriangles(faces_[i], [&](Label a, Label b) {
                    const auto [low, high] = std::minmax(a, b);
                    return !areJoined(a, b) && !added.contains({low, high});
                });
                own = newEdges(triangles_[i]);
            }
            added.insert(own.begin(), own.end());
        }
    }

    std::vector<Edge> newEdges(const FaceTriangles& triangles) const {
        std::vector<Edge> edges;
        for (const Triangle& t : triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
                if (low >= 0 && !areJoined(low, high)) edges.push_back({low, high});
            }
        return edges;
    }

    /// The faces that bound one cell, or two together.
    std::vector<SeenFace> seenFaces(std::span<const Label> faces,
                                    const std::pair<Label, Label>& cells) const {
        std::vector<SeenFace> seen;
        for (const Label face : faces) {
            const Label owner = mesh_.owner[index(face)];
            seen.push_back({face, owner == cells.first || owner == cells.second});
        }
        return seen;
    }

    /// The triangles of faces with points of their own: those of the mesh that `labels` tells, then
    /// the middles of faces.
    struct Hull {
        std::vector<Label> labels; // ascending
        std::vector<Vec3> points;
        std::vector<Triangle> triangles;
    };

    Hull hullOf(std::span<const SeenFace> faces) const {
        Hull hull;
        for (const SeenFace& s : faces)
            hull.labels.insert(
                hull.labels.end(), mesh_.faces[s.face].begin(), mesh_.faces[s.face].end());
        std::ranges::sort(hull.labels);
        hull.labels.erase(std::unique(hull.labels.begin(), hull.labels.end()), hull.labels.end());
        for (const Label p : hull.labels)
            hull.points.push_back(mesh_.points[index(p)]);
        for (const SeenFace& s : faces)
            addTriangles(s, hull);
        return hull;
    }

    void addTriangles(const SeenFace& seen, Hull& hull) const {
        const Label middle = toLabel(hull.points.size());
        bool hasMiddle = false;
        for (Triangle t : trianglesOf(seen.face)) {
            for (Label& p : t) {
                hasMiddle = hasMiddle || p < 0;
                p = p < 0 ? middle
                          : static_cast<Label>(std::ranges::lower_bound(hull.labels, p) -
                                               hull.labels.begin());
            }
            if (!seen.isOutward) std::swap(t[1], t[2]);
            hull.triangles.push_back(t);
        }
        if (hasMiddle) hull.points.push_back(middleOf(seen.face));
    }

    std::optional<StarPieces> cut(std::span<const SeenFace> faces, bool mayCut = true) const {
        const Hull hull = hullOf(faces);
        const Label firstNew = toLabel(hull.labels.size());
        const auto mayJoin = [&](Label a, Label b) {
            return a >= firstNew || b >= firstNew ||
                   !areJoined(hull.labels[index(a)], hull.labels[index(b)]);
        };
        auto pieces = starPieces(hull.points, hull.triangles, mayJoin, mayCut ? mostPieces : 1);
        if (!pieces) return pieces;
        for (PieceWall& wall : pieces->walls)
            for (Label& p : wall.triangle)
                p = p < firstNew ? hull.labels[index(p)] : -1;
        return pieces;
    }

    /// The faces round two cells; none when joining them would leave points of no face, edges of
    /// four faces, or zones that end within a cell.
    std::vector<SeenFace> outsideOf(Label cell, Label other, const KeptZones& zones) const {
        std::vector<Label> faces;
        std::vector<Label> lost;
        for (const Label own : {cell, other})
            for (const Label face : plan_.cellFaces[own]) {
                const bool isBetween = mesh_.isInternal(face) &&
                                       mesh_.owner[index(face)] == std::min(cell, other) &&
                                       mesh_.neighbour[index(face)] == std::max(cell, other);
                (isBetween ? lost : faces).push_back(face);
            }
        std::set<Label> kept;
        std::vector<Polygon> loops;
        std::vector<SeenFace> seen = seenFaces(faces, {cell, other});
        for (const SeenFace& s : seen) {
            const auto loop = mesh_.faces[s.face];
            kept.insert(loop.begin(), loop.end());
            loops.emplace_back(loop.begin(), loop.end());
            if (!s.isOutward) std::ranges::reverse(loops.back());
        }
        if (!isClosed(loops) || !areInSameZones(mesh_, zones, cell, other)) return {};
        for (const Label face : lost) {
            for (const Label p : mesh_.faces[face])
                if (!kept.contains(p)) return {};
            if (isInZone(mesh_, zones, face)) return {};
        }
        return seen;
    }

    const PolyMesh& mesh_;
    const SubdivisionPlan& plan_;
    std::vector<Label> faces_;             // ascending
    std::vector<FaceTriangles> triangles_; // beside faces_
    std::vector<Label> viewCells_;         // ascending
    std::vector<Vec3> views_;              // [m] beside viewCells_
};

/// The cell as tetrahedra over the one centre, or cut along the walls.
CellCones conesFrom(Label cell, const StarPieces& pieces) {
    CellCones cones{cell, pieces.centres[0], pieces.pieceOf, toLabel(pieces.centres.size()), {}};
    for (const PieceWall& wall : pieces.walls)
        cones.walls.push_back(
            {{wall.triangle.begin(), wall.triangle.end()}, wall.inside, wall.outside});
    if (pieces.centres.size() > 1) return cones;
    std::iota(cones.groupOf.begin(), cones.groupOf.end(), 0);
    cones.groupCount = static_cast<int>(cones.groupOf.size());
    return cones;
}

/// Pairs of cells of which none is in two, and that are not cut.
std::vector<std::pair<Label, Label>> pairsOf(std::span<const Label> cells,
                                             std::span<const Step> steps) {
    std::set<Label> taken;
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (steps[i].pieces) taken.insert(cells[i]);
    std::vector<std::pair<Label, Label>> pairs;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Label other = steps[i].partner;
        if (other < 0 || taken.contains(cells[i]) || taken.contains(other)) continue;
        pairs.emplace_back(cells[i], other);
        taken.insert({cells[i], other});
    }
    return pairs;
}

/// The steps of all cells; those that no cut helps look for a neighbour.
std::vector<Step> stepsOf(const RemedySearch& search,
                          const PolyMesh& mesh,
                          const SubdivisionPlan& plan,
                          std::span<const Label> cells,
                          const KeptZones& zones) {
    std::vector<Step> steps(cells.size());
    parallelBlocks(toLabel(cells.size()), 1, [&](Label, Label i, Label) {
        steps[index(i)] = search.stepOf(cells[index(i)]);
    });
    std::vector<Label> hopeless;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!steps[i].isHopeless) continue;
        hopeless.push_back(cells[i]);
        places.push_back(i);
    }
    const RemedySearch wider(mesh, plan, hopeless, Reach::neighbours);
    parallelBlocks(toLabel(hopeless.size()), 1, [&](Label, Label i, Label) {
        Step& step = steps[places[index(i)]];
        step.partner = wider.partnerOf(hopeless[index(i)], zones);
        if (step.partner >= 0) step.splitsFaces = false;
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
FacePieces piecesFrom(Label face, const FaceTriangles& triangles, Label middle) {
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
                    const KeptZones& zones) {
    const RemedySearch search(mesh, plan, cells, Reach::cells);
    const std::vector<Step> steps = stepsOf(search, mesh, plan, cells, zones);
    Remedies remedies;
    remedies.joined = pairsOf(cells, steps);
    std::set<std::pair<Label, Label>> lost;
    for (const auto& [a, b] : remedies.joined)
        lost.insert(std::minmax(a, b));
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (steps[i].pieces) remedies.cells.push_back(conesFrom(cells[i], *steps[i].pieces));
    for (const Label face : facesToSplit(mesh, plan, cells, steps, lost)) {
        const FaceTriangles& triangles = search.trianglesOf(face);
        const Label middle = mesh.pointCount() + toLabel(remedies.points.size());
        remedies.faces.push_back(piecesFrom(face, triangles, middle));
        if (std::ranges::any_of(triangles, [](const Triangle& t) { return t[2] < 0; }))
            remedies.points.push_back(plan.points[index(plan.layout.firstFace + face)]);
    }
    return remedies;
}

std::vector<Label>
starCells(const PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> cells) {
    const RemedySearch search(mesh, plan, cells, Reach::cells);
    std::vector<char> isStar(cells.size(), 0);
    parallelFor(toLabel(cells.size()),
                [&](Label i) { isStar[index(i)] = search.isStar(cells[index(i)]) ? 1 : 0; });
    std::vector<Label> stars;
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (isStar[i] != 0) stars.push_back(cells[i]);
    return stars;
}

std::vector<std::pair<Label, Label>> partnersOf(const PolyMesh& mesh,
                                                const SubdivisionPlan& plan,
                                                std::span<const Label> cells,
                                                const KeptZones& zones) {
    const RemedySearch search(mesh, plan, cells, Reach::neighbours);
    std::vector<Step> steps(cells.size());
    parallelBlocks(toLabel(cells.size()), 1, [&](Label, Label i, Label) {
        steps[index(i)].partner = search.partnerOf(cells[index(i)], zones);
    });
    return pairsOf(cells, steps);
}

PolyMesh withRemedies(PolyMesh mesh, const Remedies& remedies) {
    mesh.points.insert(mesh.points.end(), remedies.points.begin(), remedies.points.end());
    mesh = withPieces(std::move(mesh), remedies.faces);
    const Rows<Label> faces = cellFaces(mesh);
    mesh = withCones(std::move(mesh), faces, remedies.cells);
    return withJoinedCells(std::move(mesh), remedies.joined);
}

} // namespace polymesh
