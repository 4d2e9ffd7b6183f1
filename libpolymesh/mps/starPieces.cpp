// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/starPieces.h"

#include "libpolymesh/mps/edgeLoops.h"
#include "libpolymesh/mps/pointWithin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace polymesh {

namespace {

constexpr std::size_t longestLoop = 6;
constexpr std::size_t mostTries = 60;
constexpr std::size_t mostFacets = 80; // of pieces that are cut

/// A triangle of a piece: of the polyhedron (source >= 0), or of wall -1 - source.
struct Facet {
    Triangle points;
    int source;
};

using Facets = std::vector<Facet>;

/// A piece with the point that sees most of it.
struct Piece {
    Facets facets;
    Vec3 centre;
    int unseen = 0; // facets that the centre does not see
};

/// An edge of a piece: `left` has it from a to b, `right` from b to a.
struct PieceEdge {
    Label a;
    Label b;
    int left;
    int right;
};

class StarCutter {
public:
    StarCutter(std::span<const Vec3> points, const MayJoin& mayJoin, int mostPieces)
        : points_(points), mayJoin_(mayJoin), mostPieces_(mostPieces) {}

    std::optional<StarPieces> cut(std::span<const Triangle> triangles) {
        Facets all;
        for (std::size_t t = 0; t < triangles.size(); ++t)
            all.push_back({triangles[t], static_cast<int>(t)});
        std::vector<Piece> pending;
        addPieces(std::move(all), pending);
        std::vector<Piece> done;
        while (!pending.empty()) {
            Piece piece = std::move(pending.back());
            pending.pop_back();
            if (piece.unseen == 0) {
                done.push_back(std::move(piece));
                continue;
            }
            if (toLabel(pending.size() + done.size()) + 2 > mostPieces_) return std::nullopt;
            if (piece.facets.size() > mostFacets) return std::nullopt;
            if (cutPiece(piece, pending)) continue;
            if (piece.facets.size() > mostFacets / 2) return std::nullopt;
            thorough_ = true;
            const bool isCut = cutPiece(piece, pending);
            thorough_ = false;
            if (!isCut) return std::nullopt;
        }
        return result(done, triangles.size());
    }

private:
    const Vec3& at(Label p) const { return points_[index(p)]; }

    Vec3 area(const Triangle& t) const { return cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])); }

    /// A facet at one of its edges.
    struct EdgeUse {
        Label low;
        Label high;
        int facet;
        bool isForward; // from low to high
        double angle;   // where the edge has more than two facets

        std::pair<Label, Label> key() const { return {low, high}; }
    };

    static std::vector<EdgeUse> usesOf(const Facets& facets) {
        std::vector<EdgeUse> uses;
        for (std::size_t f = 0; f < facets.size(); ++f)
            for (std::size_t i = 0; i < 3; ++i) {
                const Label a = facets[f].points[i];
                const Label b = facets[f].points[(i + 1) % 3];
                uses.push_back({std::min(a, b), std::max(a, b), static_cast<int>(f), a < b, 0});
            }
        std::ranges::stable_sort(uses, {}, &EdgeUse::key);
        return uses;
    }

    /// The facet that faces one use of an edge among all its uses; -1: none. The inside is before
    /// the facet, turning with the edge as axis.
    static int facing(const EdgeUse& use, std::span<const EdgeUse> all) {
        double least = std::numeric_limits<double>::max();
        int partner = -1;
        for (const EdgeUse& other : all) {
            if (other.isForward) continue;
            double turn = use.angle - other.angle;
            if (turn < 0) turn += 2 * std::numbers::pi;
            if (turn < least) partner = other.facet;
            least = std::min(least, turn);
        }
        return partner;
    }

    /// The edges of a piece. Where four or more facets have one, those that face each other.
    std::vector<PieceEdge> edgesOf(const Facets& facets) const {
        std::vector<EdgeUse> uses = usesOf(facets);
        std::vector<PieceEdge> edges;
        for (std::size_t i = 0; i < uses.size();) {
            std::size_t end = i;
            while (end < uses.size() && uses[end].key() == uses[i].key())
                ++end;
            const std::span<EdgeUse> own = std::span(uses).subspan(i, end - i);
            if (own.size() > 2)
                for (EdgeUse& use : own)
                    use.angle = angleOf(
                        facets[static_cast<std::size_t>(use.facet)].points, use.low, use.high);
            for (const EdgeUse& use : own)
                if (const int partner = use.isForward ? facing(use, own) : -1; partner >= 0)
                    edges.push_back({use.low, use.high, use.facet, partner});
            i = end;
        }
        return edges;
    }

    /// The angle of a triangle round the axis from a to b.
    double angleOf(const Triangle& t, Label a, Label b) const {
        const Vec3 axis = at(b) - at(a);
        const Vec3 unit = axis / norm(axis);
        const Vec3 helper = std::abs(unit.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        Vec3 u = cross(unit, helper);
        u = u / norm(u);
        const Vec3 v = cross(unit, u);
        for (const Label p : t)
            if (p != a && p != b) return std::atan2(dot(at(p) - at(a), v), dot(at(p) - at(a), u));
        return 0;
    }

    /// The facets connected over the edges, each group a piece.
    void addPieces(Facets facets, std::vector<Piece>& pieces) const {
        const std::vector<PieceEdge> edges = edgesOf(facets);
        std::vector<int> group(facets.size());
        for (std::size_t f = 0; f < group.size(); ++f)
            group[f] = static_cast<int>(f);
        for (bool isChanged = true; isChanged;) {
            isChanged = false;
            for (const PieceEdge& e : edges) {
                int& g = group[static_cast<std::size_t>(e.left)];
                int& h = group[static_cast<std::size_t>(e.right)];
                if (g == h) continue;
                g = h = std::min(g, h);
                isChanged = true;
            }
        }
        for (std::size_t g = 0; g < group.size(); ++g) {
            Facets own;
            for (std::size_t f = 0; f < group.size(); ++f)
                if (group[f] == static_cast<int>(g)) own.push_back(facets[f]);
            if (!own.empty()) pieces.push_back(pieceOf(std::move(own)));
        }
    }

    /// Finds the point that sees most facets.
    Piece pieceOf(Facets facets) const {
        Piece piece{std::move(facets), {}, 0};
        std::vector<HalfSpace> planes;
        for (const Facet& f : piece.facets) {
            const Vec3 n = area(f.points);
            const double length = norm(n);
            planes.push_back({length > 0 ? n / -length : Vec3{}, at(f.points[0])});
        }
        double reach = 0;
        Vec3 mean;
        for (const Facet& f : piece.facets)
            mean += (at(f.points[0]) + at(f.points[1]) + at(f.points[2])) / 3;
        mean = mean / static_cast<double>(planes.size());
        for (const Facet& f : piece.facets)
            for (const Label p : f.points)
                reach = std::max(reach, norm(at(p) - mean));
        constexpr Search deep{.least = 1e-6};
        if (const auto point = pointWithin(planes, mean, reach, deep)) {
            piece.centre = *point;
            piece.unseen = isOnce(piece) ? 0 : static_cast<int>(planes.size());
            return piece;
        }
        piece.unseen = static_cast<int>(planes.size());
        for (std::size_t f = 0; f < planes.size(); ++f) {
            const Triangle& t = piece.facets[f].points;
            const Vec3 middle = (at(t[0]) + at(t[1]) + at(t[2])) / 3;
            for (const double depth : {0.01, 0.1, 0.3}) {
                const Vec3 x = middle + depth * reach * planes[f].normal;
                const auto unseen = std::ranges::count_if(planes, [&](const HalfSpace& h) {
                    return !(dot(h.normal, x - h.at) > 1e-6 * reach);
                });
                if (unseen >= piece.unseen) continue;
                piece.unseen = static_cast<int>(unseen);
                piece.centre = x;
            }
        }
        piece.unseen = std::max(piece.unseen, 1);
        return piece;
    }

    /// Whether the facets lie round the centre once.
    bool isOnce(const Piece& piece) const {
        double sum = 0;
        for (const Facet& f : piece.facets) {
            const Vec3 a = at(f.points[0]) - piece.centre;
            const Vec3 b = at(f.points[1]) - piece.centre;
            const Vec3 c = at(f.points[2]) - piece.centre;
            const double la = norm(a);
            const double lb = norm(b);
            const double lc = norm(c);
            sum += 2 * std::atan2(dot(a, cross(b, c)),
                                  la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
        }
        return std::abs(sum - 4 * std::numbers::pi) < 1;
    }

    struct Loop {
        double promise;
        std::vector<Label> points;
    };

    /// Cuts along the best of the promising loops; false when none leaves less to see.
    bool cutPiece(const Piece& piece, std::vector<Piece>& pending) {
        const std::vector<PieceEdge> edges = edgesOf(piece.facets);
        std::vector<Loop> loops = loopsOf(piece.facets, edges);
        std::ranges::stable_sort(loops, std::ranges::greater{}, &Loop::promise);
        const std::size_t most = thorough_ ? 4 * mostTries : mostTries;
        if (loops.size() > most) loops.resize(most);
        std::vector<Piece> best;
        std::vector<Triangle> bestWall;
        std::tuple<int, std::size_t> bestScore{piece.unseen, 0};
        for (const Loop& loop : loops) {
            const auto isFree = [&](Label a, Label b) {
                const Label low = std::min(a, b);
                const Label high = std::max(a, b);
                return mayJoin_(a, b) && std::ranges::none_of(edges, [&](const PieceEdge& e) {
                           return e.a == low && e.b == high;
                       });
            };
            const std::vector<Triangle> wall = triangulate(points_, loop.points, isFree);
            if (wall.empty()) continue;
            std::vector<Piece> parts = partsAlong(piece.facets, edges, loop.points, wall);
            if (parts.size() < 2) continue;
            int unseen = 0;
            for (const Piece& part : parts)
                unseen += part.unseen;
            const std::tuple score{unseen, wall.size()};
            if (score >= bestScore) continue;
            bestScore = score;
            best = std::move(parts);
            bestWall = wall;
            if (unseen == 0 && wall.size() == 1) break;
        }
        if (best.empty()) return false;
        for (const Triangle& t : bestWall)
            walls_.push_back(t);
        for (Piece& part : best)
            pending.push_back(std::move(part));
        return true;
    }

    /// On which side of a loop the facets are, 1: left, 2: right; none when it does not part the
    /// piece, as one through a hole.
    static std::vector<char> sidesOf(const Facets& facets,
                                     std::span<const PieceEdge> edges,
                                     const std::vector<Label>& loop) {
        const auto isStep = [&](Label a, Label b) {
            const auto found = std::ranges::find(loop, a);
            if (found == loop.end()) return false;
            return (found + 1 == loop.end() ? loop.front() : *(found + 1)) == b;
        };
        std::vector<char> side(facets.size(), 0);
        const auto at = [&](int facet) -> char& { return side[static_cast<std::size_t>(facet)]; };
        std::vector<PieceEdge> inner;
        for (const PieceEdge& e : edges) {
            const bool forward = isStep(e.a, e.b);
            if (!forward && !isStep(e.b, e.a)) {
                inner.push_back(e);
                continue;
            }
            at(e.left) = forward ? 1 : 2;
            at(e.right) = forward ? 2 : 1;
        }
        for (bool grows = true; grows;) {
            grows = false;
            for (const PieceEdge& e : inner) {
                if (at(e.left) == at(e.right) || (at(e.left) != 0 && at(e.right) != 0)) continue;
                at(e.left) = at(e.right) = std::max(at(e.left), at(e.right));
                grows = true;
            }
        }
        const auto parts = [&](const PieceEdge& e) { return at(e.left) == at(e.right); };
        if (!std::ranges::all_of(inner, parts)) side.clear();
        return side;
    }

    /// The pieces on either side of a wall over a loop.
    std::vector<Piece> partsAlong(const Facets& facets,
                                  std::span<const PieceEdge> edges,
                                  const std::vector<Label>& loop,
                                  const std::vector<Triangle>& wall) const {
        const std::vector<char> side = sidesOf(facets, edges, loop);
        if (side.empty()) return {};
        Facets first;
        Facets second;
        for (std::size_t f = 0; f < facets.size(); ++f)
            (side[f] == 1 ? first : second).push_back(facets[f]);
        if (first.size() < 2 || second.size() < 2) return {};
        // Facets on the left run along the loop, so their wall runs against it.
        int source = -1 - static_cast<int>(walls_.size());
        for (const Triangle& t : wall) {
            first.push_back({{t[0], t[2], t[1]}, source});
            second.push_back({t, source});
            --source;
        }
        std::vector<Piece> parts;
        addPieces(std::move(first), parts);
        addPieces(std::move(second), parts);
        return parts;
    }

    /// Simple loops through the reflex edges of a piece.
    std::vector<Loop> loopsOf(const Facets& facets, std::span<const PieceEdge> edges) const {
        constexpr std::size_t mostSteps = 2000;
        EdgeLoops finder(longestLoop);
        for (const PieceEdge& e : edges)
            finder.add(e.a, e.b);
        finder.sort();
        std::vector<Loop> loops;
        for (const PieceEdge& e : edges) {
            const Vec3 along = at(e.b) - at(e.a);
            const Vec3 left = cross(area(facets[static_cast<std::size_t>(e.left)].points), along);
            const Vec3 right = cross(along, area(facets[static_cast<std::size_t>(e.right)].points));
            const bool isReflex = dot(along, cross(left, right)) > 0;
            if (!isReflex && !thorough_) continue;
            const auto use = [&](const std::vector<Label>& loop) {
                if (const double p = promise(loop, along, left, right); p > 0)
                    loops.push_back({isReflex ? p : p - 0.3, loop});
            };
            finder.through(e.a, e.b, use, mostSteps);
        }
        return loops;
    }

    double promise(const std::vector<Label>& loop,
                   const Vec3& along,
                   const Vec3& left,
                   const Vec3& right) const {
        Vec3 mean;
        for (const Label p : loop)
            mean += at(p);
        mean = mean / static_cast<double>(loop.size());
        Vec3 sum;
        double magnitude = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec3 own = cross(at(loop[i]) - mean, at(loop[(i + 1) % loop.size()]) - mean);
            sum += own;
            magnitude += norm(own);
        }
        const double flatness = magnitude > 0 ? norm(sum) / magnitude : 0;
        if (flatness < 0.5) return 0;
        const Vec3 wall = cross(sum, along);
        const auto scaled = [&](const Vec3& a, const Vec3& b) {
            const double lengths = norm(along) * norm(a) * norm(b);
            return lengths > 0 ? dot(along, cross(a, b)) / lengths : 0;
        };
        const double angle = std::min(-scaled(left, wall), -scaled(wall, right));
        if (angle < -0.2) return 0;
        return flatness + 0.5 * angle + 2 - 0.2 * static_cast<double>(loop.size());
    }

    StarPieces result(const std::vector<Piece>& pieces, std::size_t triangleCount) const {
        StarPieces r;
        r.pieceOf.assign(triangleCount, -1);
        r.walls.resize(walls_.size());
        for (std::size_t p = 0; p < pieces.size(); ++p) {
            r.centres.push_back(pieces[p].centre);
            for (const Facet& f : pieces[p].facets) {
                const int piece = static_cast<int>(p);
                if (f.source >= 0) {
                    r.pieceOf[static_cast<std::size_t>(f.source)] = piece;
                    continue;
                }
                PieceWall& wall = r.walls[static_cast<std::size_t>(-1 - f.source)];
                // On the right of its loop a wall has the sense in which it was made.
                const bool isOutside = f.points == walls_[static_cast<std::size_t>(-1 - f.source)];
                wall.triangle = {f.points[0], f.points[1], f.points[2]};
                if (isOutside) std::swap(wall.triangle[1], wall.triangle[2]);
                (isOutside ? wall.outside : wall.inside) = piece;
            }
        }
        return r;
    }

    std::span<const Vec3> points_;
    const MayJoin& mayJoin_;
    int mostPieces_;
    std::vector<Triangle> walls_;
    bool thorough_ = false;
};

} // namespace

std::optional<StarPieces> starPieces(std::span<const Vec3> points,
                                     std::span<const Triangle> triangles,
                                     const MayJoin& mayJoin,
                                     int mostPieces) {
    return StarCutter(points, mayJoin, mostPieces).cut(triangles);
}

} // namespace polymesh
