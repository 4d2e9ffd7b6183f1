// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/cellLoops.h"
#include "libpolymesh/mps/chords.h"
#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/edgeLoops.h"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace polymesh {

/// How well a polyhedron divides.
struct PartQuality {
    int bad = 0;    // inverted corners
    int passed = 0; // nodes of valence 2, which are never right
    std::int64_t pyramids = 0;
    std::int64_t parts = 0;
};

/// A part of the cell: its outward loops, and where they are from: a place in the cell's row of
/// faces, or -1 - the number of a wall.
struct CellPart {
    std::vector<Polygon> loops;
    std::vector<int> sources;
    PartQuality quality;
};

struct PartCut {
    CellPart a;
    CellPart b;
    Polygon loop; // outward for a

    auto score() const {
        const std::int64_t pyramids = a.quality.pyramids + b.quality.pyramids;
        return std::tuple(
            a.quality.bad + b.quality.bad, pyramids, a.quality.parts + b.quality.parts);
    }
};

/// Cuts one cell along loops of its edges through reflex ones, and of diagonals if they are
/// allowed.
class LoopCutter {
public:
    LoopCutter(const PolyMesh& mesh, const Bends& bends, Label cell, CellPart whole)
        : mesh_(mesh), bends_(bends), cell_(cell) {
        faceCount_ = static_cast<std::size_t>(whole.sources.back()) + 1;
        whole.quality = qualityOf(whole);
        parts_.push_back(std::move(whole));
    }

    /// Lets loops go along diagonals of faces from the ends of reflex edges.
    /// None joins points that are an edge of the mesh or have been joined.
    void allowDiagonals(const std::vector<Edge>& edges, const std::set<Edge>& added) {
        joined_ = &edges;
        added_ = &added;
    }

    std::span<const CellPart> parts() const { return parts_; }

    std::optional<CellCones> find() {
        for (std::size_t p = 0; p < parts_.size() && walls_.size() < mostCuts;) {
            if (parts_[p].quality.bad > 0 && cut(p)) continue;
            ++p;
        }
        if (walls_.empty()) return std::nullopt;
        return result();
    }

private:
    static constexpr std::size_t mostTries = 24; // loops tried for one part of a cell
    static constexpr int mostCuts = 6;

    static double scaledTriple(const Vec3& a, const Vec3& b, const Vec3& c) {
        const double lengths = norm(a) * norm(b) * norm(c);
        return lengths > 0 ? dot(cross(a, b), c) / lengths : 0;
    }

    const Vec3& point(Label p) const { return mesh_.points[index(p)]; }

    PartQuality qualityOf(const CellPart& part) const {
        constexpr int hopeless = 1000000;
        if (!isClosed(part.loops)) return {hopeless, 0, 0, 0};
        const LoneCell lone = loneCell(mesh_, bends_, part.loops, {});
        const SubdivisionPlan plan = planSubdivision(lone.mesh, lone.bends);
        PartQuality quality{0, 0, plan.pyramids, plan.hexahedra + plan.pyramids};
        if (plan.inverted.empty()) return quality;
        CellCorners corners;
        corners.load({lone.mesh, plan.edges, plan.cellFaces}, 0);
        quality.passed =
            static_cast<int>(std::ranges::count(corners.nodes(), 2, &CellCorners::Node::valence));
        std::vector<PartCorner> list;
        addPartCorners(plan.parts(corners, 0), list);
        for (const PartCorner& c : list) {
            const Vec3& at = plan.points[index(c[0])];
            quality.bad += isInverted(plan.points[index(c[1])] - at,
                                      plan.points[index(c[2])] - at,
                                      plan.points[index(c[3])] - at)
                               ? 1
                               : 0;
        }
        return quality;
    }

    Vec3 meanOf(const Polygon& loop) const {
        Vec3 sum;
        for (const Label p : loop)
            sum += point(p);
        return sum / static_cast<double>(loop.size());
    }

    Vec3 areaOf(const Polygon& loop) const {
        Vec3 sum;
        for (std::size_t i = 2; i < loop.size(); ++i)
            sum += cross(point(loop[i - 1]) - point(loop[0]), point(loop[i]) - point(loop[0]));
        return sum;
    }

    /// The directions from an edge into its faces.
    std::pair<Vec3, Vec3> sidesOf(const CellPart& part, const CellEdge& e) const {
        const Vec3 along = point(e.b) - point(e.a);
        return {cross(areaOf(part.loops[static_cast<std::size_t>(e.left)]), along),
                cross(along, areaOf(part.loops[static_cast<std::size_t>(e.right)]))};
    }

    /// Whether the angle inside is more than 180 degrees.
    bool isReflex(const CellPart& part, const CellEdge& e) const {
        constexpr double flat = 1e-3;
        const auto [left, right] = sidesOf(part, e);
        return scaledTriple(point(e.b) - point(e.a), left, right) > flat;
    }

    /// The part's faces on the left of the loop; none when they are all or the loop is a face.
    std::vector<char>
    leftOf(const CellPart& part, std::span<const CellEdge> edges, const Polygon& loop) const {
        std::vector<char> isLeft(part.loops.size(), 0);
        const auto isStep = [&](Label a, Label b) {
            const auto at = std::ranges::find(loop, a);
            if (at == loop.end()) return false;
            return (at + 1 == loop.end() ? loop.front() : *(at + 1)) == b;
        };
        std::vector<char> isRim(edges.size(), 0);
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const bool forward = isStep(edges[e].a, edges[e].b);
            const bool backward = isStep(edges[e].b, edges[e].a);
            isRim[e] = forward || backward ? 1 : 0;
            if (forward) isLeft[static_cast<std::size_t>(edges[e].left)] = 1;
            if (backward) isLeft[static_cast<std::size_t>(edges[e].right)] = 1;
        }
        for (bool grows = true; grows;) {
            grows = false;
            for (std::size_t e = 0; e < edges.size(); ++e) {
                char& left = isLeft[static_cast<std::size_t>(edges[e].left)];
                char& right = isLeft[static_cast<std::size_t>(edges[e].right)];
                if (isRim[e] != 0 || left == right) continue;
                left = right = 1;
                grows = true;
            }
        }
        const auto count = std::ranges::count(isLeft, 1);
        const auto all = static_cast<std::ptrdiff_t>(isLeft.size());
        if (count < 2 || count > all - 2) isLeft.clear();
        return isLeft;
    }

    /// The part in two; none when they have more inverted corners than `mostBad`.
    std::optional<PartCut> cutAlong(const CellPart& part, const Polygon& loop, int mostBad) const {
        const std::vector<char> isLeft = leftOf(part, edgesOf(part.loops), loop);
        if (isLeft.empty()) return std::nullopt;
        PartCut cut;
        for (std::size_t f = 0; f < isLeft.size(); ++f) {
            CellPart& side = isLeft[f] != 0 ? cut.a : cut.b;
            side.loops.push_back(part.loops[f]);
            side.sources.push_back(part.sources[f]);
        }
        // The faces on the left run along the loop, so that the wall closes them the other way.
        cut.loop = Polygon(loop.rbegin(), loop.rend());
        cut.a.loops.push_back(cut.loop);
        cut.b.loops.push_back(loop);
        const int wall = -1 - static_cast<int>(walls_.size());
        cut.a.sources.push_back(wall);
        cut.b.sources.push_back(wall);
        cut.a.quality = qualityOf(cut.a);
        if (cut.a.quality.bad > mostBad) return std::nullopt;
        cut.b.quality = qualityOf(cut.b);
        if (cut.a.quality.bad + cut.b.quality.bad > mostBad) return std::nullopt;
        return cut;
    }

    /// A diagonal of a face of a part.
    struct Diagonal {
        Label a;
        Label b;
        std::size_t face;
    };

    /// The diagonals from an end of an edge across faces that have that end only.
    void addDiagonals(const CellPart& part,
                      const CellEdge& reflex,
                      std::vector<Diagonal>& diagonals) const {
        const auto isJoined = [&](Label a, Label b) {
            const Edge ends{std::min(a, b), std::max(a, b)};
            return std::ranges::binary_search(*joined_, ends) || added_->contains(ends);
        };
        for (std::size_t f = 0; f < part.loops.size(); ++f) {
            const Polygon& loop = part.loops[f];
            if (part.sources[f] < 0 || loop.size() < 4) continue;
            const bool hasA = std::ranges::find(loop, reflex.a) != loop.end();
            const bool hasB = std::ranges::find(loop, reflex.b) != loop.end();
            if (hasA == hasB) continue;
            const Label from = hasA ? reflex.a : reflex.b;
            const auto start =
                static_cast<std::size_t>(std::ranges::find(loop, from) - loop.begin());
            for (std::size_t i = 0; i < loop.size(); ++i)
                if (i != start && !isJoined(from, loop[i]) &&
                    isChord(mesh_, bends_, loop, start, i))
                    diagonals.push_back({from, loop[i], f});
        }
    }

    /// How promising a wall along a loop that begins with a reflex edge is; 0 when it is not.
    double promise(const CellPart& part, const CellEdge& reflex, const Polygon& loop) const {
        constexpr double leastFlatness = 0.8;
        constexpr double straight = 0.02;
        const Vec3 mean = meanOf(loop);
        Vec3 area;
        double magnitude = 0;
        const std::size_t n = loop.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3 own = cross(point(loop[i]) - mean, point(loop[(i + 1) % n]) - mean);
            area += own;
            magnitude += norm(own);
        }
        const double flatness = magnitude > 0 ? norm(area) / magnitude : 0;
        if (flatness < leastFlatness) return 0;
        for (std::size_t i = 0; i < n; ++i)
            if (scaledTriple(point(loop[(i + 1) % n]) - point(loop[i]),
                             point(loop[(i + n - 1) % n]) - point(loop[i]),
                             area) < straight)
                return 0;
        const Vec3 along = point(reflex.b) - point(reflex.a);
        const Vec3 wall = cross(area, along);
        const auto [left, right] = sidesOf(part, reflex);
        const double angle =
            std::min(-scaledTriple(along, left, wall), -scaledTriple(along, wall, right));
        if (angle < straight) return 0;
        return flatness + 0.5 * angle + 1 - 0.1 * static_cast<double>(n);
    }

    struct Candidate {
        double promise;
        Polygon loop;
    };

    /// Loops through reflex edges, the most promising first.
    std::vector<Candidate> candidates(const CellPart& part,
                                      std::span<const CellEdge> edges,
                                      std::vector<Diagonal>& diagonals) const {
        std::vector<Candidate> found;
        for (const CellEdge& e : edges) {
            if (!isReflex(part, e)) continue;
            std::vector<Diagonal> own;
            if (joined_ != nullptr) addDiagonals(part, e, own);
            EdgeLoops finder;
            for (const CellEdge& edge : edges)
                finder.add(edge.a, edge.b);
            for (const Diagonal& d : own)
                finder.add(d.a, d.b);
            finder.sort();
            finder.through(e.a, e.b, [&](const Polygon& loop) {
                const double promised = promise(part, e, loop);
                if (promised > 0) found.push_back({promised, loop});
            });
            diagonals.insert(diagonals.end(), own.begin(), own.end());
        }
        std::ranges::stable_sort(found, std::ranges::greater{}, &Candidate::promise);
        if (found.size() > mostTries) found.resize(mostTries);
        return found;
    }

    /// The part with those of its faces split whose diagonals the loop takes; none when two are of
    /// one face.
    static std::optional<CellPart>
    splitAlong(const CellPart& part, std::span<const Diagonal> diagonals, const Polygon& loop) {
        CellPart split = part;
        std::vector<char> isSplit(part.loops.size(), 0);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Label a = loop[i];
            const Label b = loop[(i + 1) % loop.size()];
            const auto d = std::ranges::find_if(diagonals, [&](const Diagonal& x) {
                return (x.a == a && x.b == b) || (x.a == b && x.b == a);
            });
            if (d == diagonals.end()) continue;
            if (isSplit[d->face] != 0) return std::nullopt;
            isSplit[d->face] = 1;
            Polygon face = part.loops[d->face];
            std::rotate(face.begin(), std::ranges::find(face, a), face.end());
            const auto end = std::ranges::find(face, b);
            split.loops[d->face] = Polygon(face.begin(), end + 1);
            Polygon rest(end, face.end());
            rest.push_back(a);
            split.loops.push_back(std::move(rest));
            split.sources.push_back(part.sources[d->face]);
        }
        return split;
    }

    /// Makes the best cut of a part; false when none is any good.
    bool cut(std::size_t p) {
        const CellPart part = parts_[p];
        const std::vector<CellEdge> edges = edgesOf(part.loops);
        std::vector<Diagonal> diagonals;
        std::optional<PartCut> best;
        int mostBad = part.quality.bad - 1;
        for (const Candidate& candidate : candidates(part, edges, diagonals)) {
            const auto split = splitAlong(part, diagonals, candidate.loop);
            if (!split) continue;
            auto found = cutAlong(*split, candidate.loop, mostBad);
            if (!found || found->a.quality.passed + found->b.quality.passed > part.quality.passed)
                continue;
            if (!best || found->score() < best->score()) best = std::move(found);
            mostBad = std::get<0>(best->score());
            if (mostBad == 0 && std::get<1>(best->score()) == 0) break;
        }
        if (!best) return false;
        walls_.push_back(best->loop);
        parts_[p] = std::move(best->a);
        parts_.push_back(std::move(best->b));
        return true;
    }

    CellCones result() const {
        CellCones cuts;
        cuts.cell = cell_;
        cuts.groupOf.assign(faceCount_, 0);
        cuts.groupCount = static_cast<int>(parts_.size());
        cuts.walls.resize(walls_.size());
        for (std::size_t p = 0; p < parts_.size(); ++p)
            for (std::size_t f = 0; f < parts_[p].sources.size(); ++f) {
                const int source = parts_[p].sources[f];
                const int group = static_cast<int>(p);
                if (source >= 0) {
                    cuts.groupOf[static_cast<std::size_t>(source)] = group;
                    continue;
                }
                CellWall& wall = cuts.walls[static_cast<std::size_t>(-1 - source)];
                wall.loop = walls_[static_cast<std::size_t>(-1 - source)];
                (parts_[p].loops[f] == wall.loop ? wall.inside : wall.outside) = group;
            }
        return cuts;
    }

    const PolyMesh& mesh_;
    const Bends& bends_;
    Label cell_;
    std::size_t faceCount_ = 0;
    std::vector<CellPart> parts_;
    std::vector<Polygon> walls_;
    const std::vector<Edge>* joined_ = nullptr;
    const std::set<Edge>* added_ = nullptr;
};

} // namespace polymesh
