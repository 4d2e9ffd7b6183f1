// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/adjustNodes.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/trim/adjustGuard.h"
#include "libpolymesh/trim/adjustTargets.h"
#include "libpolymesh/trim/avoidFeatures.h"
#include "libpolymesh/trim/hangingNodes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace polymesh {

namespace {

/// Smallest part of a cell that a move may leave, of the volume that the cell began with.
constexpr double leastPart = 0.1;

/// How deep nodes on the surface stand inside while the mesh is trimmed, fraction of the shortest
/// edge: deeper than a surface with a radius of 8 cells bends between the four nodes of a face, so
/// that all of the face is inside too.
constexpr double settleDepth = 0.03;

/// Of nodes that hang between nodes that hang.
constexpr int mostLevels = 4;

void sortUnique(std::vector<Label>& labels) {
    std::ranges::sort(labels);
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
}

/// The cells round some points of a mesh, with their faces.
struct CellStars {
    std::vector<Label> cells; // ascending
    Rows<Label> faces;        // one row per entry of cells
};

CellStars cellsRound(const PolyMesh& mesh, const std::vector<std::uint8_t>& isMarked) {
    std::vector<Label> place(index(mesh.cellCount), -1);
    const auto forEachCell = [&](Label f, auto&& body) {
        body(mesh.owner[index(f)]);
        if (mesh.isInternal(f)) body(mesh.neighbour[index(f)]);
    };
    for (Label f = 0; f < mesh.faceCount(); ++f)
        if (std::ranges::any_of(mesh.faces[f], [&](Label p) { return isMarked[index(p)] != 0; }))
            forEachCell(f, [&](Label c) { place[index(c)] = 0; });
    CellStars stars;
    for (Label c = 0; c < mesh.cellCount; ++c)
        if (place[index(c)] == 0) {
            place[index(c)] = toLabel(stars.cells.size());
            stars.cells.push_back(c);
        }
    auto& offsets = stars.faces.offsets;
    offsets.assign(stars.cells.size() + 1, 0);
    const auto forEachUse = [&](auto&& body) {
        for (Label f = 0; f < mesh.faceCount(); ++f)
            forEachCell(f, [&](Label c) {
                if (place[index(c)] >= 0) body(index(place[index(c)]), f);
            });
    };
    forEachUse([&](std::size_t cell, Label) { ++offsets[cell + 1]; });
    for (std::size_t c = 1; c < offsets.size(); ++c)
        offsets[c] += offsets[c - 1];
    stars.faces.values.resize(index(offsets.back()));
    std::vector<Label> next(offsets.begin(), offsets.end() - 1);
    forEachUse([&](std::size_t cell, Label f) { stars.faces.values[index(next[cell]++)] = f; });
    return stars;
}

class Adjustment {
public:
    Adjustment(PolyMesh& mesh, std::vector<NodeMove> moves, double depth)
        : mesh_(mesh), moves_(std::move(moves)), depth_(depth), isMarked_(mesh.points.size(), 0) {}

    AdjustedNodes run() {
        AdjustedNodes result;
        if (moves_.empty()) return result;
        findStars();
        for (const NodeMove& move : moves_)
            initial_.push_back(mesh_.points[index(move.node)]);
        isUndone_.assign(moves_.size(), 0);
        measureCells();
        for (const NodeMove& move : moves_)
            mesh_.points[index(move.node)] = move.place;
        std::vector<Label> doubtful(stars_.cells.size());
        for (std::size_t c = 0; c < doubtful.size(); ++c)
            doubtful[c] = toLabel(c);
        while (!doubtful.empty()) {
            placeHanging();
            doubtful = undoWorst(failing(doubtful));
        }
        for (std::size_t i = 0; i < moves_.size(); ++i)
            settle(i, result);
        placeHanging();
        return result;
    }

private:
    /// Finds the cells that may change: those round moved nodes, and those round the nodes that
    /// hang between these; nodes that hang are not moved themselves.
    void findStars() {
        for (const NodeMove& move : moves_)
            isMarked_[index(move.node)] = 1;
        stars_ = cellsRound(mesh_, isMarked_);
        for (int level = 0; level < mostLevels && findFollowers(); ++level) {
            for (const HangingNode& node : hanging_)
                isMarked_[index(node.node)] = 1;
            stars_ = cellsRound(mesh_, isMarked_);
        }
        linkMoves();
    }

    /// Whether there are nodes that hang between marked ones and are not marked yet.
    bool findFollowers() {
        std::vector<HangingNode> found;
        for (Label c = 0; c < toLabel(stars_.cells.size()); ++c)
            findHanging(mesh_, stars_.cells[index(c)], stars_.faces[c], found);
        std::ranges::stable_sort(found, {}, &HangingNode::node);
        const auto isSameNode = [](const HangingNode& a, const HangingNode& b) {
            return a.node == b.node;
        };
        found.erase(std::unique(found.begin(), found.end(), isSameNode), found.end());
        const auto hangs = [&](Label p) {
            return std::ranges::binary_search(found, p, {}, &HangingNode::node);
        };
        std::erase_if(moves_, [&](const NodeMove& move) { return hangs(move.node); });
        std::erase_if(found, [&](const HangingNode& node) {
            return isMarked_[index(node.ends[0])] == 0 && isMarked_[index(node.ends[1])] == 0;
        });
        const bool isNew = std::ranges::any_of(
            found, [&](const HangingNode& node) { return isMarked_[index(node.node)] == 0; });
        hanging_ = std::move(found);
        return isNew;
    }

    /// The moves of each cell, and the cells of each move.
    void linkMoves() {
        std::vector<Label> moveOf(mesh_.points.size(), -1);
        for (std::size_t i = 0; i < moves_.size(); ++i)
            moveOf[index(moves_[i].node)] = toLabel(i);
        std::vector<Label> found;
        std::vector<std::array<Label, 2>> pairs;
        for (Label c = 0; c < toLabel(stars_.cells.size()); ++c) {
            found.clear();
            for (const Label f : stars_.faces[c])
                for (const Label p : mesh_.faces[f])
                    addMoves(p, moveOf, mostLevels, found);
            sortUnique(found);
            movesOfCell_.add(found);
            for (const Label move : found)
                pairs.push_back({move, c});
        }
        std::ranges::sort(pairs);
        std::size_t next = 0;
        for (Label move = 0; move < toLabel(moves_.size()); ++move) {
            found.clear();
            for (; next < pairs.size() && pairs[next][0] == move; ++next)
                found.push_back(pairs[next][1]);
            cellsOfMove_.add(found);
        }
    }

    /// The moves that a point depends on: its own, or those of the ends between which it hangs.
    void addMoves(Label p,
                  const std::vector<Label>& moveOf,
                  int levels,
                  std::vector<Label>& found) const {
        if (isMarked_[index(p)] == 0 || levels == 0) return;
        if (moveOf[index(p)] >= 0) found.push_back(moveOf[index(p)]);
        const auto at = std::ranges::lower_bound(hanging_, p, {}, &HangingNode::node);
        if (at == hanging_.end() || at->node != p) return;
        for (const Label end : at->ends)
            addMoves(end, moveOf, levels - 1, found);
    }

    void measureCells() {
        before_.resize(stars_.cells.size());
        parallelFor(toLabel(stars_.cells.size()), [&](Label c) {
            before_[index(c)] = smallestPart(mesh_, stars_.cells[index(c)], stars_.faces[c], 0);
        });
    }

    /// Hanging nodes follow; those that hang between others come right with each further pass.
    void placeHanging() {
        for (int pass = 0; pass < mostLevels; ++pass)
            for (const HangingNode& node : hanging_)
                mesh_.points[index(node.node)] = node.place(mesh_.points);
    }

    /// Those of the cells with a part that is too small, unless it was so from the beginning.
    std::vector<Label> failing(const std::vector<Label>& cells) const {
        std::vector<std::uint8_t> isBad(cells.size(), 0);
        parallelFor(toLabel(cells.size()), [&](Label i) {
            const Label c = cells[index(i)];
            const PartMeasure& was = before_[index(c)];
            const PartMeasure is =
                smallestPart(mesh_, stars_.cells[index(c)], stars_.faces[c], was.volume);
            // Rounding must not refuse a cell that is as it was.
            isBad[index(i)] = is.smallest < std::min(leastPart, was.smallest - 1e-9) ? 1 : 0;
        });
        std::vector<Label> bad;
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (isBad[i] != 0) bad.push_back(cells[i]);
        return bad;
    }

    /// Takes back the least important move of each of the cells; returns the cells round them.
    std::vector<Label> undoWorst(const std::vector<Label>& cells) {
        std::vector<Label> undone;
        for (const Label c : cells) {
            Label worst = -1;
            for (const Label i : movesOfCell_[c])
                if (isUndone_[index(i)] == 0 &&
                    (worst < 0 || isLess(moves_[index(i)], moves_[index(worst)])))
                    worst = i;
            if (worst >= 0) undone.push_back(worst);
        }
        std::vector<Label> doubtful;
        for (const Label i : undone) {
            if (isUndone_[index(i)] != 0) continue;
            isUndone_[index(i)] = 1;
            mesh_.points[index(moves_[index(i)].node)] = initial_[index(i)];
            const auto round = cellsOfMove_[i];
            doubtful.insert(doubtful.end(), round.begin(), round.end());
        }
        sortUnique(doubtful);
        return doubtful;
    }

    /// Faces are given up before edges, edges before corners; then the longer way.
    static bool isLess(const NodeMove& a, const NodeMove& b) {
        return a.target != b.target ? a.target > b.target : a.way > b.way;
    }

    void settle(std::size_t i, AdjustedNodes& result) {
        const NodeMove& move = moves_[i];
        AdjustCounts& counts = result.counts;
        if (isUndone_[i] != 0) {
            ++counts.refused;
            return;
        }
        result.moved.push_back({move.node, move.place});
        switch (move.target) {
        case AdjustTarget::corner:
            ++counts.corners;
            break;
        case AdjustTarget::edge:
            ++counts.edges;
            break;
        case AdjustTarget::face:
            ++counts.faces;
            break;
        case AdjustTarget::away:
            ++counts.away;
            return;
        }
        const double depth = depth_ * move.size;
        mesh_.points[index(move.node)] += depth * move.inward;
        result.settled.push_back({move.node, move.place, depth, move.target});
    }

    PolyMesh& mesh_;
    std::vector<NodeMove> moves_;
    double depth_;                       // of projected nodes, fraction of the shortest edge
    std::vector<std::uint8_t> isMarked_; // points that may move
    CellStars stars_;
    std::vector<HangingNode> hanging_; // by ascending node, each once
    Rows<Label> movesOfCell_;          // beside stars_.cells
    Rows<Label> cellsOfMove_;          // places in stars_.cells
    std::vector<Vec3> initial_;        // beside moves_
    std::vector<std::uint8_t> isUndone_;
    std::vector<PartMeasure> before_; // beside stars_.cells
};

} // namespace

AdjustedNodes adjustNodes(PolyMesh& mesh,
                          const CuttingSurface& surface,
                          const SurfaceFeatures& features,
                          const AdjustOptions& options) {
    if (options.how == Adjust::none || options.distance <= 0) return {};
    const SurfaceTargets targets(surface, features);
    const bool avoids = options.how == Adjust::avoid || !options.avoided.empty();
    const std::vector<NearNode> near =
        findNearNodes(mesh, *surface.surface, farthestReach(options), avoids);
    std::vector<NodeMove> moves = findMoves(mesh, targets, near, options);
    std::optional<FeatureAvoidance> avoidance;
    CloseCounts before;
    if (avoids) {
        avoidance.emplace(mesh, targets, near, options);
        before = avoidance->count();
        moves = avoidance->extended(moves);
    }
    const auto kept = std::erase_if(moves, [&](const NodeMove& move) {
        return std::ranges::binary_search(options.kept, move.node);
    });
    AdjustedNodes adjusted =
        Adjustment(mesh, std::move(moves), options.isForTrim ? settleDepth : 0).run();
    adjusted.counts.refused += toLabel(kept);
    adjusted.counts.closeBefore = before;
    if (avoidance) adjusted.counts.closeAfter = avoidance->count();
    return adjusted;
}

} // namespace polymesh
