// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/featureNet.h"

#include "libpolymesh/geometry/box.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace polymesh {

namespace {

class Net {
public:
    Net(std::vector<NetEdge>& edges, std::span<const Label> outline) : edges_(edges) {
        for (const NetEdge& edge : edges)
            points_.insert(points_.end(), edge.ends.begin(), edge.ends.end());
        std::ranges::sort(points_);
        points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
        edgesOf_.resize(points_.size());
        borderCount_.assign(points_.size(), 0);
        for (std::size_t n = 0; n < points_.size(); ++n) {
            line_.push_back(n);
            isOnOutline_.push_back(std::ranges::binary_search(outline, points_[n]));
        }
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const auto [a, b] = nodesOf(e);
            edgesOf_[a].push_back(e);
            edgesOf_[b].push_back(e);
            if (edges[e].isBorder) addToLine(a, b);
        }
    }

    bool run() {
        bool isDone = true;
        for (std::size_t n = 0; n < points_.size(); ++n)
            if (borderCount_[n] == 1 && !isOnOutline_[n] && !carryOn(n)) isDone = false;
        return isDone;
    }

private:
    std::pair<std::size_t, std::size_t> nodesOf(std::size_t edge) const {
        const auto node = [&](Label point) {
            return static_cast<std::size_t>(std::ranges::lower_bound(points_, point) -
                                            points_.begin());
        };
        return {node(edges_[edge].ends[0]), node(edges_[edge].ends[1])};
    }

    /// The lowest node of the line that a node belongs to.
    std::size_t lineOf(std::size_t node) const {
        while (line_[node] != node)
            node = line_[node];
        return node;
    }

    void addToLine(std::size_t a, std::size_t b) {
        ++borderCount_[a];
        ++borderCount_[b];
        const std::size_t first = lineOf(a);
        const std::size_t second = lineOf(b);
        line_[std::max(first, second)] = std::min(first, second);
    }

    /// Makes the cheapest way from a free end to the outline or another line a border. It keeps off
    /// its own line: a loop would cut out a face with a hole round it.
    bool carryOn(std::size_t end) {
        struct Step {
            double cost;
            std::size_t node;

            bool operator>(const Step& other) const {
                return cost != other.cost ? cost > other.cost : node > other.node;
            }
        };

        const std::size_t own = lineOf(end);
        std::vector<double> cost(points_.size(), Box::inf);
        std::vector<std::size_t> cameBy(points_.size(), edges_.size());
        std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
        cost[end] = 0;
        front.push({0, end});
        while (!front.empty()) {
            const Step at = front.top();
            front.pop();
            if (at.cost > cost[at.node]) continue;
            if (at.node != end && (isOnOutline_[at.node] || borderCount_[at.node] > 0)) {
                takeWay(at.node, end, cameBy);
                return true;
            }
            for (const std::size_t e : edgesOf_[at.node]) {
                const auto [a, b] = nodesOf(e);
                const std::size_t next = a == at.node ? b : a;
                const double sum = at.cost + edges_[e].cost;
                if (edges_[e].isBorder || sum >= cost[next]) continue;
                if (borderCount_[next] > 0 && lineOf(next) == own) continue;
                cost[next] = sum;
                cameBy[next] = e;
                front.push({sum, next});
            }
        }
        return false;
    }

    void takeWay(std::size_t node, std::size_t end, const std::vector<std::size_t>& cameBy) {
        while (node != end) {
            const std::size_t e = cameBy[node];
            edges_[e].isBorder = true;
            const auto [a, b] = nodesOf(e);
            addToLine(a, b);
            node = a == node ? b : a;
        }
    }

    std::vector<NetEdge>& edges_;
    std::vector<Label> points_; // node -> point label, ascending
    std::vector<std::vector<std::size_t>> edgesOf_;
    std::vector<int> borderCount_;  // per node: borders that end there
    std::vector<std::size_t> line_; // node -> a lower one of the same line, or itself
    std::vector<bool> isOnOutline_;
};

} // namespace

bool carryFeaturesOn(std::vector<NetEdge>& net, std::span<const Label> outline) {
    return Net(net, outline).run();
}

} // namespace polymesh
