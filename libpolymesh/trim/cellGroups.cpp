// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/cellGroups.h"

#include "libpolymesh/trim/chains.h"
#include "libpolymesh/trim/featureNet.h"
#include "libpolymesh/trim/sharpness.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace polymesh {

namespace {

std::span<const Label> intervalsOf(const CellPieces& pieces, Label piece) {
    return {pieces.intervals.data() + pieces.polygons.offsets[index(piece)],
            index(pieces.polygons.rowSize(piece))};
}

Vec3 mean(const PointPositions& positions, std::span<const Label> polygon) {
    Vec3 sum;
    for (const Label p : polygon)
        sum += positions[index(p)];
    return sum / static_cast<double>(polygon.size());
}

/// Six times the volume of the cone from `apex` over the fan round the polygon's mean point.
double cone(const PointPositions& positions, std::span<const Label> polygon, const Vec3& apex) {
    const Vec3 centre = mean(positions, polygon) - apex;
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 a = positions[index(polygon[i])] - apex;
        const Vec3 b = positions[index(polygon[(i + 1) % polygon.size()])] - apex;
        sum += dot(centre, cross(a, b));
    }
    return sum;
}

/// Whether the point is within `tolerance` [m] of the fan round the polygon's `centre`.
bool isNearFan(const PointPositions& positions,
               const LoopPolygon& polygon,
               const Vec3& centre,
               Label point,
               double tolerance) {
    const Vec3& p = positions[index(point)];
    Label from = polygon.back();
    for (const Label to : polygon) {
        if (distanceToTriangle(p, positions[index(from)], positions[index(to)], centre) <=
            tolerance)
            return true;
        from = to;
    }
    return false;
}

/// The same for polygons with the same points, in whatever order they are.
std::uint64_t fingerprint(std::span<const Label> polygon) {
    std::uint64_t sum = 0;
    for (const Label p : polygon) {
        std::uint64_t h = static_cast<std::uint64_t>(p) + 0x9e3779b97f4a7c15U;
        h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9U;
        h = (h ^ (h >> 27)) * 0x94d049bb133111ebU;
        sum += h ^ (h >> 31);
    }
    return sum;
}

} // namespace

void CellGroups::build(const CellInput& input, Label cell, std::vector<std::uint8_t>& levels) {
    cell_ = cell;
    levels_ = &levels;
    firstPiece_ = input.pieces.offsets[index(cell)];
    pieceCount_ = input.pieces.offsets[index(cell) + 1] - firstPiece_;
    isBad_.assign(index(pieceCount_), 0);
    cuts_.clear();
    listJoins(input);
    joinPieces(input);
    while (cutAlongFeatures(input))
        joinPieces(input);
    listOutlines(input);
    walkOutlines(input);
}

bool CellGroups::raiseBad() {
    bool isRaised = false;
    for (Label i = 0; i < pieceCount_; ++i) {
        if (isBad_[index(groupOf(i))] == 0 || levelOf(i) >= CellInput::lastLevel) continue;
        ++levelOf(i);
        isRaised = true;
    }
    return isRaised;
}

/// Whether groups a and b may be one; if so its cone is stored at the lower.
bool CellGroups::fits(Label a, Label b, double cone) {
    const Cone& one = cones_[index(a)];
    const Cone& other = cones_[index(b)];
    Cone both;
    both.sum = one.sum + other.sum;
    const auto angle = [](const Vec3& u, const Vec3& v) {
        return std::atan2(norm(cross(u, v)), dot(u, v));
    };
    both.angle =
        std::max(one.angle + angle(one.sum, both.sum), other.angle + angle(other.sum, both.sum));
    if (both.angle > cone) return false;
    cones_[index(std::min(a, b))] = both;
    return true;
}

/// A side of a piece, counted through all pieces of the cell.
Label CellGroups::sideOf(const CellInput& input, Label piece, std::size_t side) const {
    const auto& offsets = input.pieces.polygons.offsets;
    return offsets[index(firstPiece_ + piece)] - offsets[index(firstPiece_)] + toLabel(side);
}

/// Finds what is across each side: of several pieces at an interval the lowest other one.
void CellGroups::pairSides() {
    for (std::size_t first = 0; first < entries_.size();) {
        std::size_t last = first + 1;
        while (last < entries_.size() && entries_[last].interval == entries_[first].interval)
            ++last;
        for (std::size_t i = first; i < last; ++i)
            for (std::size_t j = first; j < last; ++j)
                if (entries_[j].piece != entries_[i].piece) {
                    across_[index(entries_[i].side)] = entries_[j].piece;
                    break;
                }
        first = last;
    }
}

/// Lists the intervals of the cell's pieces, and the edges across which two may be joined.
void CellGroups::listJoins(const CellInput& input) {
    entries_.clear();
    for (Label i = 0; i < pieceCount_; ++i) {
        const auto intervals = intervalsOf(input.pieces, firstPiece_ + i);
        for (std::size_t k = 0; k < intervals.size(); ++k)
            if (intervals[k] >= 0) entries_.push_back({intervals[k], i, sideOf(input, i, k)});
    }
    std::ranges::sort(entries_, [](const Entry& a, const Entry& b) {
        return a.interval != b.interval ? a.interval < b.interval : a.piece < b.piece;
    });
    across_.assign(index(sideOf(input, pieceCount_, 0)), -1);
    pairSides();
    joins_.clear();
    features_.clear();
    for (std::size_t k = 0; k + 1 < entries_.size(); ++k) {
        if (entries_[k].interval != entries_[k + 1].interval) continue;
        const Label a = entries_[k].piece;
        const Label b = entries_[k + 1].piece;
        const double sharpness =
            input.sharpness[index(input.edgeOfInterval[index(entries_[k].interval)])];
        const Join join{sharpness, a, b, entries_[k].interval};
        const bool isKept = !isBlunt(a) || !isBlunt(b);
        if (sharpness >= featureSharpness && isKept) features_.push_back(join);
        if (levelOf(a) == levelOf(b) && sharpness <= input.levels[levelOf(a)].sharpest)
            joins_.push_back(join);
    }
}

void CellGroups::joinPieces(const CellInput& input) {
    const auto coneOf = [&](Label piece) { return input.levels[levelOf(piece)].cone; };
    bool haveCones = false;
    groups_.reset(pieceCount_);
    for (Label i = 0; i < pieceCount_; ++i)
        haveCones = haveCones || coneOf(i) < std::numbers::pi;
    if (haveCones) {
        cones_.clear();
        for (Label i = 0; i < pieceCount_; ++i) {
            const auto t = input.cutter.triangle(input.pieces.triangle[index(firstPiece_ + i)]);
            cones_.push_back({cross(t[1] - t[0], t[2] - t[0]), 0});
        }
        std::ranges::stable_sort(joins_, {}, &Join::sharpness);
    }
    for (const Join& join : joins_) {
        const Label a = groupOf(join.a);
        const Label b = groupOf(join.b);
        const double cone = coneOf(join.a);
        if (a == b || std::ranges::binary_search(cuts_, join.interval)) continue;
        if (cone < std::numbers::pi && !fits(a, b, cone)) continue;
        groups_.join(a, b);
    }
}

/// Makes borders that let feature edges part groups; false when there is nothing (more) to be done.
bool CellGroups::cutAlongFeatures(const CellInput& input) {
    boost::container::small_vector<Label, 4> groups;
    for (const Join& feature : features_)
        if (groupOf(feature.a) == groupOf(feature.b)) groups.push_back(groupOf(feature.a));
    std::ranges::sort(groups);
    const std::size_t before = cuts_.size();
    for (std::size_t i = 0; i < groups.size(); ++i)
        if (i == 0 || groups[i] != groups[i - 1]) cutGroup(input, groups[i]);
    std::ranges::sort(cuts_);
    if (cuts_.size() == before)
        for (const Label group : groups)
            isBad_[index(group)] = 1;
    return cuts_.size() != before;
}

void CellGroups::cutGroup(const CellInput& input, Label group) {
    std::vector<NetEdge> net;
    std::vector<Label> intervals; // beside net
    std::vector<Label> outline;
    for (Label i = 0; i < pieceCount_; ++i) {
        if (groupOf(i) != group) continue;
        const auto points = input.pieces.polygons[firstPiece_ + i];
        const auto pieceIntervals = intervalsOf(input.pieces, firstPiece_ + i);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Label to = points[(k + 1) % points.size()];
            const Label interval = pieceIntervals[k];
            const Label other = across_[index(sideOf(input, i, k))];
            if (other < 0 || groupOf(other) != group) {
                outline.push_back(points[k]);
                outline.push_back(to);
            } else if (i < other) {
                const double sharpness =
                    input.sharpness[index(input.edgeOfInterval[index(interval)])];
                const double length =
                    norm(input.positions[index(to)] - input.positions[index(points[k])]);
                net.push_back(
                    {{points[k], to},
                     length * (3 - 4 * std::clamp(sharpness, 0.0, 0.5)),
                     sharpness >= featureSharpness || std::ranges::binary_search(cuts_, interval)});
                intervals.push_back(interval);
            }
        }
    }
    std::ranges::sort(outline);
    std::vector<NetEdge> carried = net;
    if (!carryFeaturesOn(carried, outline)) isBad_[index(group)] = 1;
    for (std::size_t k = 0; k < net.size(); ++k)
        if (carried[k].isBorder && !net[k].isBorder) cuts_.push_back(intervals[k]);
}

void CellGroups::listOutlines(const CellInput& input) {
    edges_.clear();
    borderEnds_.clear();
    for (Label i = 0; i < pieceCount_; ++i) {
        const auto points = input.pieces.polygons[firstPiece_ + i];
        const auto intervals = intervalsOf(input.pieces, firstPiece_ + i);
        const Label group = groupOf(i);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Label to = points[(k + 1) % points.size()];
            if (intervals[k] >= 0) {
                const Label other = across_[index(sideOf(input, i, k))];
                if (other >= 0 && groupOf(other) == group) continue;
                borderEnds_.push_back(points[k]);
                borderEnds_.push_back(to);
            }
            edges_.push_back({group, points[k], to, false});
        }
    }
    std::ranges::sort(edges_, [](const OutlineEdge& a, const OutlineEdge& b) {
        return a.group != b.group ? a.group < b.group : a.from < b.from;
    });
}

void CellGroups::walkOutlines(const CellInput& input) {
    faces_.clear();
    faceOfPiece_.assign(index(pieceCount_), -1);
    for (std::size_t k = 0; k < edges_.size(); ++k) {
        const Label group = edges_[k].group;
        if (k > 0 && group == edges_[k - 1].group && edges_[k].from == edges_[k - 1].from)
            isBad_[index(group)] = 1;
        if (edges_[k].isUsed) continue;
        Face face;
        face.group = group;
        face.region =
            input.cutter.surface->region[index(input.pieces.triangle[index(firstPiece_ + group)])];
        for (std::size_t at = k; at < edges_.size() && !edges_[at].isUsed; at = next(at)) {
            edges_[at].isUsed = true;
            face.points.push_back(edges_[at].from);
        }
        Label& known = faceOfPiece_[index(group)];
        if (known >= 0) isBad_[index(group)] = 1; // a second outline
        known = toLabel(faces_.size());
        faces_.push_back(std::move(face));
    }
    for (Label i = 0; i < pieceCount_; ++i) {
        faceOfPiece_[index(i)] = faceOfPiece_[index(groupOf(i))];
        if (faceOfPiece_[index(i)] < 0) isBad_[index(groupOf(i))] = 1; // closed: no outline at all
    }
}

/// The unused edge of the same group that goes on where this one ends.
std::size_t CellGroups::next(std::size_t at) const {
    const Label group = edges_[at].group;
    const Label from = edges_[at].to;
    auto found = std::lower_bound(
        edges_.begin(), edges_.end(), from, [group](const OutlineEdge& e, Label point) {
            return e.group != group ? e.group < group : e.from < point;
        });
    while (found != edges_.end() && found->isUsed && found + 1 != edges_.end() &&
           (found + 1)->group == group && (found + 1)->from == from)
        ++found;
    return static_cast<std::size_t>(found - edges_.begin());
}

void CellGroups::keepVertices(const CellInput& input, double tolerance) {
    const Label firstVertex = input.arrangement.firstVertex();
    std::vector<Label> seen;
    bool keepsCorners = false;
    for (const Face& face : faces_) {
        keepsCorners = keepsCorners || !isBlunt(face.group);
        for (const Label p : face.points)
            if (p >= firstVertex) seen.push_back(p);
    }
    std::ranges::sort(seen);
    keptVertices_.clear();
    for (std::size_t i = 0; i < seen.size();) {
        std::size_t j = i;
        while (j < seen.size() && seen[j] == seen[i])
            ++j;
        const bool isCorner = keepsCorners && input.isCorner[index(seen[i] - firstVertex)] != 0;
        if (j - i != 2 || isCorner) keptVertices_.push_back(seen[i]); // more than two faces meet
        i = j;
    }
    for (const Face& face : faces_) {
        const auto isKept = [&](std::size_t i) {
            return face.points[i] < firstVertex ||
                   std::ranges::binary_search(keptVertices_, face.points[i]);
        };
        const auto keep = [&](std::size_t i) {
            if (face.points[i] >= firstVertex)
                keptVertices_.insert(std::ranges::lower_bound(keptVertices_, face.points[i]),
                                     face.points[i]);
        };
        keepWithin(input.positions,
                   std::span<const Label>(face.points.data(), face.points.size()),
                   tolerance,
                   isKept,
                   keep);
    }
}

void CellGroups::reduce(const CellInput& input, double tolerance, const KeptPoints& kept) {
    const Label firstVertex = input.arrangement.firstVertex();
    const auto drop = [](LoopPolygon& points, auto&& isDropped) {
        points.erase(std::remove_if(points.begin(), points.end(), isDropped), points.end());
    };
    for (Face& face : faces_)
        drop(face.points, [&](Label p) { return p < firstVertex && !kept(p); });
    keepVertices(input, tolerance);
    for (Face& face : faces_)
        drop(face.points, [&](Label p) {
            return p >= firstVertex && !std::ranges::binary_search(keptVertices_, p);
        });
}

/// Lists the polygons of the cell: those of mesh faces, then the faces of the groups.
void CellGroups::listPolygons(const CellInput& input,
                              const FaceLoops& loops,
                              const KeptPoints& kept) {
    polygons_.clear();
    for (const Label f : input.probe.cellFaces[cell_]) {
        const bool isTurned = input.probe.faceCells[index(f)][0] != cell_;
        for (Label k = loops.offsets[index(f)]; k < loops.offsets[index(f) + 1]; ++k) {
            CellPolygon polygon{{}, isTurned, -1};
            for (const Label p : loops.polygons[k])
                if (kept(p)) polygon.points.push_back(p);
            polygons_.push_back(std::move(polygon));
        }
    }
    for (const Face& face : faces_)
        polygons_.push_back({face.points, false, face.group});
}

/// Marks the groups of shells as bad that have fewer than four faces, two faces with the same
/// points, or no volume; and all groups where an edge is used more than twice.
void CellGroups::checkShells(const CellInput& input) {
    shells_.clear();
    bool isSound = true;
    for (const CellPolygon& p : polygons_) {
        const std::span<const Label> points(p.points.data(), p.points.size());
        isSound = isSound && points.size() >= 3;
        shells_.add(points, p.isTurned);
    }
    shells_.join();
    if (!isSound || !shells_.isSimple()) {
        isBad_.assign(isBad_.size(), 1);
        return;
    }

    struct Shell { // NOLINT(bugprone-exception-escape): boost's move may allocate
        Label faces = 0;
        double volume = 0;
        bool mayBeVoid = true; // surface alone: a void in the cell encloses a negative volume
        boost::container::small_vector<std::uint64_t, 16> seen;
    };

    boost::container::small_vector<Shell, 2> shells(polygons_.size());
    const Vec3 apex = input.positions[index(polygons_[0].points[0])];
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
        Shell& shell = shells[index(shells_.shellOf(toLabel(i)))];
        const std::span<const Label> points(polygons_[i].points.data(), polygons_[i].points.size());
        ++shell.faces;
        shell.volume += (polygons_[i].isTurned ? -1 : 1) * cone(input.positions, points, apex);
        shell.mayBeVoid = shell.mayBeVoid && polygons_[i].group >= 0;
        shell.seen.push_back(fingerprint(points));
    }
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
        Shell& shell = shells[index(shells_.shellOf(toLabel(i)))];
        std::ranges::sort(shell.seen);
        const bool hasVolume = shell.mayBeVoid ? shell.volume != 0 : shell.volume > 0;
        const bool isGood = shell.faces >= 4 && hasVolume &&
                            std::ranges::adjacent_find(shell.seen) == shell.seen.end();
        if (!isGood && polygons_[i].group >= 0) isBad_[index(polygons_[i].group)] = 1;
    }
}

void CellGroups::checkFaces(const CellInput& input,
                            const FaceLoops& loops,
                            double tolerance,
                            const KeptPoints& kept) {
    listPolygons(input, loops, kept);
    checkShells(input);
    checkDeviation(input, tolerance);
}

/// Marks the groups as bad that have a point of a piece farther from their face than `tolerance`.
void CellGroups::checkDeviation(const CellInput& input, double tolerance) {
    dropped_.clear();
    for (Label i = 0; i < pieceCount_; ++i) {
        const Label f = faceOfPiece_[index(i)];
        if (f < 0 || isBad_[index(groupOf(i))] != 0) continue;
        for (const Label p : input.pieces.polygons[firstPiece_ + i])
            if (std::ranges::find(faces_[index(f)].points, p) == faces_[index(f)].points.end())
                dropped_.push_back({groupOf(i), p});
    }
    std::ranges::sort(dropped_);
    Label group = -1;
    Vec3 centre;
    for (std::size_t i = 0; i < dropped_.size(); ++i) {
        if (i > 0 && dropped_[i] == dropped_[i - 1]) continue;
        const LoopPolygon& face = faces_[index(faceOfPiece_[index(dropped_[i].group)])].points;
        if (dropped_[i].group != group)
            centre = mean(input.positions, std::span<const Label>(face.data(), face.size()));
        group = dropped_[i].group;
        if (isBad_[index(group)] == 0 &&
            !isNearFan(input.positions, face, centre, dropped_[i].point, tolerance))
            isBad_[index(group)] = 1;
    }
}

} // namespace polymesh
