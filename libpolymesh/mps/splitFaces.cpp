// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/splitFaces.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mps/chords.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace polymesh {

namespace {

using Polygon = std::vector<Label>;

double scaledTriple(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double lengths = norm(a) * norm(b) * norm(c);
    return lengths > 0 ? dot(cross(a, b), c) / lengths : 0;
}

/// Splits one face after the other, and remembers the diagonals.
class FaceSplitter {
public:
    FaceSplitter(const PolyMesh& mesh,
                 const Bends& bends,
                 const SubdivisionPlan& plan,
                 std::span<const Label> cells,
                 const FaceSplitRule& rule)
        : mesh_(mesh), bends_(bends), plan_(plan), cells_(cells), rule_(rule) {}

    /// The pieces of a face; itself alone when it has no corner to split or no way to.
    std::vector<Polygon> piecesOf(Label face) {
        const auto loop = mesh_.faces[face];
        isInternal_ = mesh_.isInternal(face);
        const Vec3 area = faceArea(loop);
        inward_ = -area;
        centre_ = plan_.points[index(plan_.layout.firstCell + mesh_.owner[index(face)])];
        isOwnerIn_ = std::ranges::binary_search(cells_, mesh_.owner[index(face)]);
        if (isInternal_) {
            const Label neighbour = mesh_.neighbour[index(face)];
            otherCentre_ = plan_.points[index(plan_.layout.firstCell + neighbour)];
            isNeighbourIn_ = std::ranges::binary_search(cells_, neighbour);
        }
        std::vector<Polygon> pending{Polygon(loop.begin(), loop.end())};
        std::vector<Polygon> pieces;
        while (!pending.empty()) {
            Polygon polygon = std::move(pending.back());
            pending.pop_back();
            const auto [from, to] = bestDiagonal(polygon);
            if (from == to) {
                pieces.push_back(std::move(polygon));
                continue;
            }
            added_.insert(std::minmax(polygon[from], polygon[to]));
            pending.push_back(part(polygon, to, from));
            pending.push_back(part(polygon, from, to));
        }
        return pieces;
    }

private:
    using Diagonal = std::pair<std::size_t, std::size_t>;

    Vec3 faceArea(std::span<const Label> loop) const {
        Vec3 sum;
        const Vec3& first = point(loop[0]);
        for (std::size_t i = 2; i < loop.size(); ++i)
            sum += cross(point(loop[i - 1]) - first, point(loop[i]) - first);
        return sum;
    }

    const Vec3& point(Label p) const { return mesh_.points[index(p)]; }

    /// The middle of an edge, which may bend; the point at the other end of a diagonal.
    const Vec3& towards(Label here, Label there) const {
        const Edge ends{std::min(here, there), std::max(here, there)};
        const auto edge = std::ranges::lower_bound(plan_.edges.points, ends);
        if (edge == plan_.edges.points.end() || *edge != ends) return point(there);
        const auto number = edge - plan_.edges.points.begin();
        return plan_.points[index(plan_.layout.firstEdge + static_cast<Label>(number))];
    }

    /// How convex the face is at the corner `here`: above zero where it is.
    double convexity(Label before, Label here, Label after) const {
        const Vec3& at = point(here);
        const Vec3 a = towards(here, before) - at;
        const Vec3 b = towards(here, after) - at;
        if (!isInternal_) return scaledTriple(a, b, centre_ - at);
        if (!rule_.isStrict) return scaledTriple(a, b, inward_);
        return std::min(isOwnerIn_ ? scaledTriple(a, b, centre_ - at) : 1.0,
                        isNeighbourIn_ ? scaledTriple(b, a, otherCentre_ - at) : 1.0);
    }

    static Label cyclic(const Polygon& polygon, std::size_t i) {
        return polygon[i % polygon.size()];
    }

    double cornerConvexity(const Polygon& polygon, std::size_t i) const {
        const std::size_t n = polygon.size();
        return convexity(cyclic(polygon, i + n - 1), polygon[i], cyclic(polygon, i + 1));
    }

    bool areJoined(Label a, Label b) const {
        const auto [low, high] = std::minmax(a, b);
        return std::ranges::binary_search(plan_.edges.points, Edge{low, high}) ||
               added_.contains({low, high});
    }

    /// The corners from one to another, both included.
    static Polygon part(const Polygon& polygon, std::size_t from, std::size_t to) {
        Polygon result;
        for (std::size_t i = from;; i = (i + 1) % polygon.size()) {
            result.push_back(polygon[i]);
            if (i == to) return result;
        }
    }

    /// A pair of equal places when no diagonal makes anything better.
    Diagonal bestDiagonal(const Polygon& polygon) const {
        const std::size_t n = polygon.size();
        std::vector<double> value(n);
        int bad = 0;
        for (std::size_t i = 0; i < n; ++i) {
            value[i] = cornerConvexity(polygon, i);
            bad += value[i] < rule_.least ? 1 : 0;
        }
        Diagonal best{0, 0};
        std::pair<int, double> bestScore{bad, std::numeric_limits<double>::max()};
        for (std::size_t i = 0; bad > 0 && n > 3 && i < n; ++i)
            for (std::size_t j = 0; value[i] < rule_.least && j < n; ++j) {
                const std::size_t gap = (j + n - i) % n;
                if (gap < 2 || gap > n - 2 || areJoined(polygon[i], polygon[j]) ||
                    !isChord(mesh_, bends_, polygon, i, j))
                    continue;
                const auto score = scoreOf(polygon, {i, j}, value, bad);
                if (score < bestScore) best = {i, j};
                bestScore = std::min(bestScore, score);
            }
        return best;
    }

    /// How many bad corners there are with a diagonal, and how bad its ends are at worst.
    std::pair<int, double> scoreOf(const Polygon& polygon,
                                   const Diagonal& diagonal,
                                   const std::vector<double>& value,
                                   int bad) const {
        double worst = std::numeric_limits<double>::max();
        const auto [i, j] = diagonal;
        const std::size_t n = polygon.size();
        for (const auto& [a, b] : {Diagonal{i, j}, Diagonal{j, i}}) {
            const Label here = polygon[a];
            const double left = convexity(cyclic(polygon, a + n - 1), here, polygon[b]);
            const double right = convexity(polygon[b], here, cyclic(polygon, a + 1));
            bad -= value[a] < rule_.least ? 1 : 0;
            bad += (left < rule_.least ? 1 : 0) + (right < rule_.least ? 1 : 0);
            worst = std::min({worst, left, right});
        }
        return {bad, -worst};
    }

    const PolyMesh& mesh_;
    const Bends& bends_;
    const SubdivisionPlan& plan_;
    std::span<const Label> cells_;
    FaceSplitRule rule_;
    std::set<std::pair<Label, Label>> added_;
    bool isInternal_ = false;
    Vec3 inward_;
    Vec3 centre_;            // of the owner
    Vec3 otherCentre_;       // of the neighbour
    bool isOwnerIn_ = false; // among the cells to help
    bool isNeighbourIn_ = false;
};

/// New labels of the first piece of each face, and of the end.
std::vector<Label> firstPieces(const PolyMesh& mesh, std::span<const FacePieces> faces) {
    std::vector<Label> first(index(mesh.faceCount()) + 1, 1);
    first[0] = 0;
    for (const FacePieces& f : faces)
        first[index(f.face) + 1] = toLabel(f.pieces.size());
    std::partial_sum(first.begin(), first.end(), first.begin());
    return first;
}

Zone zoneOfPieces(const Zone& zone, const std::vector<Label>& first) {
    Zone result{zone.name, {}, {}};
    for (std::size_t i = 0; i < zone.labels.size(); ++i) {
        const Label face = zone.labels[i];
        for (Label piece = first[index(face)]; piece < first[index(face) + 1]; ++piece) {
            result.labels.push_back(piece);
            result.flip.push_back(i < zone.flip.size() && zone.flip[i]);
        }
    }
    return result;
}

} // namespace

std::vector<Label> facesOf(const SubdivisionPlan& plan, std::span<const Label> cells) {
    std::vector<Label> faces;
    for (const Label cell : cells)
        faces.insert(faces.end(), plan.cellFaces[cell].begin(), plan.cellFaces[cell].end());
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

PolyMesh withPieces(PolyMesh mesh, std::span<const FacePieces> faces) {
    if (faces.empty()) return mesh;
    const std::vector<Label> first = firstPieces(mesh, faces);
    Rows<Label> rows;
    std::vector<Label> owner;
    std::vector<Label> neighbour;
    rows.offsets.reserve(index(first.back()) + 1);
    rows.values.reserve(mesh.faces.values.size() + 4 * faces.size());
    auto next = faces.begin();
    for (Label face = 0; face < mesh.faceCount(); ++face) {
        if (next != faces.end() && next->face == face) {
            for (const Polygon& piece : next->pieces)
                rows.add(piece);
            ++next;
        } else {
            rows.add(std::as_const(mesh.faces)[face]);
        }
        owner.resize(rows.offsets.size() - 1, mesh.owner[index(face)]);
        if (mesh.isInternal(face))
            neighbour.resize(rows.offsets.size() - 1, mesh.neighbour[index(face)]);
    }
    for (Patch& patch : mesh.patches) {
        const Label last = patch.start + patch.size;
        patch.start = first[index(patch.start)];
        patch.size = first[index(last)] - patch.start;
    }
    for (Zone& zone : mesh.faceZones)
        zone = zoneOfPieces(zone, first);
    mesh.faces = std::move(rows);
    mesh.owner = std::move(owner);
    mesh.neighbour = std::move(neighbour);
    return mesh;
}

std::vector<FacePieces> piecesOfFaces(const PolyMesh& mesh,
                                      const Bends& bends,
                                      const SubdivisionPlan& plan,
                                      std::span<const Label> cells,
                                      const FaceSplitRule& rule) {
    const std::vector<Label> faces = facesOf(plan, cells);
    FaceSplitter splitter(mesh, bends, plan, cells, rule);
    std::vector<FacePieces> result;
    for (const Label face : faces)
        if (FacePieces split{face, splitter.piecesOf(face)}; split.pieces.size() > 1)
            result.push_back(std::move(split));
    return result;
}

std::vector<FacePieces> fansOf(const PolyMesh& mesh, std::span<const Label> faces) {
    std::vector<FacePieces> fans;
    Label middle = mesh.pointCount();
    for (const Label face : faces) {
        const auto loop = mesh.faces[face];
        FacePieces fan{face, {}};
        for (std::size_t i = 0; i < loop.size(); ++i)
            fan.pieces.push_back({loop[i], loop[(i + 1) % loop.size()], middle});
        fans.push_back(std::move(fan));
        ++middle;
    }
    return fans;
}

} // namespace polymesh
