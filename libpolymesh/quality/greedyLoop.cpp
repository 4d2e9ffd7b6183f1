// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/greedyLoop.h"

#include "libpolymesh/quality/polygons.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace polymesh {

namespace {

/// A way from one point of a cell to another.
struct Way {
    Label from = -1;
    Label to = -1;
    Label face = -1; // to be cut; -1: along an edge

    bool operator==(const Way&) const = default;

    bool operator<(const Way& other) const {
        return std::tie(from, to, face) < std::tie(other.from, other.to, other.face);
    }
};

bool isChordInside(const MeshEditor& editor,
                   const Polygon& polygon,
                   const Vec3& normal,
                   std::pair<Label, Label> chord) {
    for (const double t : {0.1, 0.5, 0.9}) {
        const Vec3 p = (1 - t) * editor.point(chord.first) + t * editor.point(chord.second);
        if (!isInsidePolygon(editor, polygon, normal, p)) return false;
    }
    return true;
}

void addChords(MeshEditor& editor, Label f, std::vector<Way>& ways) {
    if (editor.isFrozenFace(f)) return;
    const Polygon& polygon = editor.face(f).points;
    const Vec3 normal = editor.faceGeometry(f).area;
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n - (i == 0); ++j) {
            if (!isChordInside(editor, polygon, normal, {polygon[i], polygon[j]})) continue;
            ways.push_back({polygon[i], polygon[j], f});
            ways.push_back({polygon[j], polygon[i], f});
        }
}

/// All ways on the cell, sorted.
std::vector<Way> waysOf(MeshEditor& editor, Label cell, const EdgeList& forbidden) {
    std::vector<Way> ways;
    for (const Label f : editor.cell(cell).faces) {
        addChords(editor, f, ways);
        Label a = editor.face(f).points.back();
        for (const Label b : editor.face(f).points) {
            const std::pair<Label, Label> edge = std::minmax({a, b});
            if (std::find(forbidden.begin(), forbidden.end(), edge) == forbidden.end()) {
                ways.push_back({a, b, -1});
                ways.push_back({b, a, -1});
            }
            a = b;
        }
    }
    std::sort(ways.begin(), ways.end());
    ways.erase(std::unique(ways.begin(), ways.end()), ways.end());
    return ways;
}

/// How far a closed loop is out of plane; 0 for a plane convex one.
double outOfPlane(const MeshEditor& editor, const std::vector<Label>& loop) {
    const std::size_t n = loop.size();
    const auto side = [&](std::size_t i) {
        return editor.point(loop[(i + 1) % n]) - editor.point(loop[i % n]);
    };
    const auto turn = [&](std::size_t i) {
        const Vec3 v = cross(side(i), side(i + 1));
        const double length = norm(v);
        return length > 0 ? v / length : Vec3{};
    };
    double sum = 0;
    for (std::size_t i = 0; n > 3 && i < n; ++i)
        sum += 1 - dot(turn(i), turn(i + 1));
    return sum;
}

/// A point that has been reached, or may be next.
struct Reached {
    Label point = -1;
    double weight = std::numeric_limits<double>::infinity();
    std::size_t before = 0; // place of the point on the way to it
    Label face = -1;        // cut on the way to it
    bool done = false;
};

class GreedySearch {
public:
    GreedySearch(MeshEditor& editor, std::vector<Way> ways)
        : editor_(editor), ways_(std::move(ways)) {
        for (const Way& way : ways_)
            if (reached_.empty() || reached_.back().point != way.from)
                reached_.push_back({.point = way.from});
    }

    std::optional<CellLoop> loopThrough(Label a, Label b) {
        const std::size_t goal = placeOf(a);
        const std::size_t start = placeOf(b);
        if (goal == reached_.size() || start == reached_.size()) return std::nullopt;
        reached_[start].weight = 0;
        for (std::size_t at = next(); at < reached_.size(); at = next()) {
            if (at == goal) return walkBack(start, goal);
            reached_[at].done = true;
            goOn(at, start, a);
        }
        return std::nullopt;
    }

private:
    std::size_t placeOf(Label p) const {
        const auto found =
            std::lower_bound(reached_.begin(), reached_.end(), p, [](const Reached& r, Label q) {
                return r.point < q;
            });
        if (found == reached_.end() || found->point != p) return reached_.size();
        return static_cast<std::size_t>(found - reached_.begin());
    }

    std::size_t next() const {
        std::size_t best = reached_.size();
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < reached_.size(); ++i)
            if (!reached_[i].done && reached_[i].weight < least) {
                best = i;
                least = reached_[i].weight;
            }
        return best;
    }

    void goOn(std::size_t at, std::size_t start, Label a) {
        std::vector<Label> loop{a};
        const auto first = static_cast<std::ptrdiff_t>(loop.size());
        for (std::size_t i = at;; i = reached_[i].before) {
            loop.insert(loop.begin() + first, reached_[i].point);
            if (i == start) break;
        }
        const Way from{reached_[at].point, -1, -1};
        for (auto way = std::lower_bound(ways_.begin(), ways_.end(), from);
             way != ways_.end() && way->from == from.from;
             ++way) {
            if (at == start && way->to == a) continue;
            Reached& other = reached_[placeOf(way->to)];
            if (other.done) continue;
            if (way->to != a) loop.push_back(way->to);
            const double weight = reached_[at].weight + 1 + outOfPlane(editor_, loop);
            if (way->to != a) loop.pop_back();
            if (weight >= other.weight) continue;
            other = {way->to, weight, at, way->face, false};
        }
    }

    /// From a, against the search to b; the way from b to a is the edge.
    CellLoop walkBack(std::size_t start, std::size_t goal) const {
        CellLoop loop;
        for (std::size_t at = goal; at != start; at = reached_[at].before) {
            loop.push_back({.point = reached_[at].point,
                            .position = editor_.point(reached_[at].point),
                            .faceToNext = reached_[at].face});
        }
        loop.push_back(
            {.point = reached_[start].point, .position = editor_.point(reached_[start].point)});
        return loop;
    }

    MeshEditor& editor_;
    std::vector<Way> ways_;
    std::vector<Reached> reached_; // by label
};

} // namespace

std::optional<CellLoop> greedyLoop(MeshEditor& editor,
                                   Label cell,
                                   std::pair<Label, Label> edge,
                                   const EdgeList& forbidden) {
    return GreedySearch(editor, waysOf(editor, cell, forbidden))
        .loopThrough(edge.first, edge.second);
}

} // namespace polymesh
