// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trimCell/graphLoops.h"

#include <algorithm>
#include <tuple>

namespace polymesh {

namespace {

/// An end of an edge as one of its carriers sees it.
struct End {
    Label carrier;
    PointName point;
    Label use; // see useOf
};

/// Number of an edge's side, and of an end on that side.
std::size_t sideOf(Label edge, int side) {
    return 2 * index(edge) + static_cast<std::size_t>(side);
}

Label useOf(Label edge, int side, int end) {
    return 4 * edge + 2 * side + end;
}

class LoopFinder {
public:
    LoopFinder(const CellInputs& inputs, const CellGraph& graph)
        : inputs_(inputs),
          graph_(graph),
          loopOf_(2 * graph.edges.size(), -1),
          fromOf_(2 * graph.edges.size(), 0) {}

    std::vector<GraphLoop> run() {
        pairEnds();
        for (Label e = 0; e < toLabel(graph_.edges.size()); ++e)
            for (int side = 0; side < 2; ++side)
                if (loopOf_[sideOf(e, side)] < 0) follow(e, side);
        orient();
        return std::move(loops_);
    }

private:
    const GraphEdge& edge(const LoopStep& step) const { return graph_.edges[index(step.edge)]; }

    /// Finds for each end of an edge, as a carrier sees it, the other one at its point.
    void pairEnds() {
        std::vector<End> ends;
        for (Label e = 0; e < toLabel(graph_.edges.size()); ++e)
            for (int side = 0; side < 2; ++side)
                for (int end = 0; end < 2; ++end) {
                    const GraphEdge& edge = graph_.edges[index(e)];
                    ends.push_back({edge.carriers[static_cast<std::size_t>(side)],
                                    edge.points[static_cast<std::size_t>(end)],
                                    useOf(e, side, end)});
                }
        std::ranges::sort(
            ends, {}, [](const End& end) { return std::tie(end.carrier, end.point, end.use); });
        partner_.resize(ends.size());
        const auto isSame = [](const End& a, const End& b) {
            return a.carrier == b.carrier && a.point == b.point;
        };
        for (std::size_t i = 0; i < ends.size(); i += 2) {
            const bool isPair = i + 1 < ends.size() && isSame(ends[i], ends[i + 1]) &&
                                (i + 2 == ends.size() || !isSame(ends[i], ends[i + 2]));
            if (!isPair) refuseSurfaceAt(inputs_, ends[i].point);
            partner_[index(ends[i].use)] = ends[i + 1].use;
            partner_[index(ends[i + 1].use)] = ends[i].use;
        }
    }

    /// Follows the loop that runs along an edge on one of its sides.
    void follow(Label first, int side) {
        GraphLoop loop;
        loop.carrier = graph_.edges[index(first)].carriers[static_cast<std::size_t>(side)];
        Label use = useOf(first, side, 0);
        do {
            const Label e = use / 4;
            const int at = static_cast<int>(use / 2 % 2);
            const int end = static_cast<int>(use % 2);
            loopOf_[sideOf(e, at)] = toLabel(loops_.size());
            fromOf_[sideOf(e, at)] = static_cast<std::uint8_t>(end);
            loop.steps.push_back(
                {e, static_cast<std::uint8_t>(at), static_cast<std::uint8_t>(end)});
            use = partner_[index(useOf(e, at, 1 - end))];
        } while (use != useOf(first, side, 0));
        loops_.push_back(std::move(loop));
    }

    /// 1: the loop runs as it should, -1: the other way round, 0: none of its edges tells.
    int directionOf(const GraphLoop& loop) const {
        int direction = 0;
        for (const LoopStep& step : loop.steps) {
            if (edge(step).kind == GraphEdge::Kind::segment) continue;
            const int here = step.from == step.side ? 1 : -1;
            if (direction == -here) refuseSurfaceAt(inputs_, edge(step).points[0]);
            direction = here;
        }
        return direction;
    }

    void orient() {
        std::vector<Label> front;
        isDone_.assign(loops_.size(), 0);
        for (std::size_t i = 0; i < loops_.size(); ++i)
            if (const int direction = directionOf(loops_[i]); direction != 0)
                settle(toLabel(i), direction < 0, front);
        while (!front.empty()) {
            const Label i = front.back();
            front.pop_back();
            for (const LoopStep& step : loops_[index(i)].steps)
                orientNeighbour(step, front);
        }
        for (std::size_t i = 0; i < loops_.size(); ++i)
            if (isDone_[i] == 0) refuseSurfaceAt(inputs_, edge(loops_[i].steps[0]).points[0]);
    }

    void settle(Label loop, bool isWrong, std::vector<Label>& front) {
        if (isWrong) {
            turn(loops_[index(loop)]);
            for (const LoopStep& step : loops_[index(loop)].steps)
                fromOf_[sideOf(step.edge, step.side)] = step.from;
        }
        isDone_[index(loop)] = 1;
        front.push_back(loop);
    }

    /// Turns the loop on the other side of an edge so that it runs against this one.
    void orientNeighbour(const LoopStep& step, std::vector<Label>& front) {
        const std::size_t there = sideOf(step.edge, 1 - step.side);
        const Label other = loopOf_[there];
        const bool isWrong = fromOf_[there] == step.from;
        if (isDone_[index(other)] == 0)
            settle(other, isWrong, front);
        else if (isWrong)
            refuseSurfaceAt(inputs_, edge(step).points[0]);
    }

    const CellInputs& inputs_;
    const CellGraph& graph_;
    std::vector<Label> partner_;       // use -> use
    std::vector<Label> loopOf_;        // side of an edge -> loop
    std::vector<std::uint8_t> fromOf_; // side of an edge -> the end at which its loop's step begins
    std::vector<GraphLoop> loops_;
    std::vector<std::uint8_t> isDone_; // loop: it runs as it should
};

} // namespace

void turn(GraphLoop& loop) {
    std::ranges::reverse(loop.steps);
    for (LoopStep& step : loop.steps)
        step.from = static_cast<std::uint8_t>(1 - step.from);
}

std::vector<GraphLoop> findLoops(const CellInputs& inputs, const CellGraph& graph) {
    return LoopFinder(inputs, graph).run();
}

} // namespace polymesh
