// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/openCollapsed.h"

#include "libpolymesh/base/disjointSets.h"
#include "libpolymesh/base/error.h"

#include <algorithm>
#include <numeric>

namespace polymesh {
namespace {

using Corners = MacroMesh::Corners;
using Quad = std::array<Label, 4>;

/// A side of a cell at a collapsed point, by its points in ascending order.
struct Side {
    Quad points{};
    Label cell = 0;
    std::size_t side = 0;
};

Quad loopOf(const Corners& corners, std::size_t side) {
    Quad loop{};
    for (std::size_t k = 0; k < 4; ++k)
        loop[k] = corners[sideLoops[side][k]];
    return loop;
}

class Opening {
public:
    Opening(std::span<const Corners> corners, Label pointCount)
        : corners_(corners), isCollapsed_(index(pointCount), 0) {}

    OpenedCells run() {
        findCollapsed();
        uses_.reset(toLabel(8 * cells_.size()));
        joinAcrossSides();
        return opened();
    }

private:
    /// The points that a cell has more than once, and all cells that have one of them.
    void findCollapsed() {
        for (const Corners& cell : corners_) {
            Corners sorted = cell;
            std::ranges::sort(sorted);
            for (std::size_t c = 1; c < 8; ++c)
                if (sorted[c] == sorted[c - 1]) isCollapsed_[index(sorted[c])] = 1;
        }
        for (Label cell = 0; cell < toLabel(corners_.size()); ++cell)
            if (std::ranges::any_of(corners_[index(cell)],
                                    [&](Label p) { return isCollapsed_[index(p)] != 0; }))
                cells_.push_back(cell);
    }

    /// The sides of those cells that have area.
    std::vector<Side> sides() const {
        std::vector<Side> found;
        for (std::size_t i = 0; i < cells_.size(); ++i)
            for (std::size_t side = 0; side < 6; ++side) {
                Quad points = loopOf(corners_[index(cells_[i])], side);
                std::ranges::sort(points);
                Quad different = points;
                if (std::unique(different.begin(), different.end()) - different.begin() < 3)
                    continue;
                found.push_back({points, toLabel(i), side});
            }
        std::ranges::sort(found, [](const Side& a, const Side& b) {
            return a.points != b.points ? a.points < b.points : a.cell < b.cell;
        });
        return found;
    }

    void joinAcrossSides() {
        const std::vector<Side> all = sides();
        std::vector<std::array<Label, 2>> neighbours;
        for (std::size_t i = 1; i < all.size(); ++i) {
            if (all[i].points != all[i - 1].points) continue;
            join(all[i - 1], all[i]);
            neighbours.push_back({all[i - 1].cell, all[i].cell});
        }
        std::ranges::sort(neighbours);
        const auto twice = std::ranges::adjacent_find(neighbours);
        require(twice == neighbours.end(),
                "refinement: cells {} and {} have two sides in common, because there are only two "
                "round a collapsed edge; give it more",
                twice == neighbours.end() ? 0 : cells_[index((*twice)[0])],
                twice == neighbours.end() ? 0 : cells_[index((*twice)[1])]);
    }

    /// Joins the corners of two cells at their common side, one's loop running against the other's.
    void join(const Side& a, const Side& b) {
        const Quad own = loopOf(corners_[index(cells_[index(a.cell)])], a.side);
        const Quad other = loopOf(corners_[index(cells_[index(b.cell)])], b.side);
        for (std::size_t start = 0; start < 4; ++start) {
            const auto across = [&](std::size_t k) { return (start + 4 - k) % 4; };
            bool fits = true;
            for (std::size_t k = 0; k < 4; ++k)
                fits = fits && own[k] == other[across(k)];
            if (!fits) continue;
            for (std::size_t k = 0; k < 4; ++k)
                uses_.join(use(a.cell, sideLoops[a.side][k]),
                           use(b.cell, sideLoops[b.side][across(k)]));
            return;
        }
    }

    /// A corner of one of the cells.
    static Label use(Label cell, std::size_t corner) { return 8 * cell + toLabel(corner); }

    /// The first corners that are one point keep it, others get copies.
    OpenedCells opened() {
        OpenedCells result;
        result.corners.assign(corners_.begin(), corners_.end());
        result.original.resize(isCollapsed_.size());
        std::iota(result.original.begin(), result.original.end(), Label{0});
        std::vector<char> isTaken(isCollapsed_.size(), 0);
        std::vector<Label> labels(index(uses_.count()), -1);
        for (Label use = 0; use < uses_.count(); ++use) {
            Label& corner = result.corners[index(cells_[index(use / 8)])][index(use % 8)];
            if (isCollapsed_[index(corner)] == 0) continue;
            Label& label = labels[index(uses_.lowest(use))];
            if (label < 0 && isTaken[index(corner)] == 0) {
                label = corner;
                isTaken[index(corner)] = 1;
            } else if (label < 0) {
                label = toLabel(result.original.size());
                result.original.push_back(corner);
            }
            corner = label;
        }
        return result;
    }

    std::span<const Corners> corners_;
    std::vector<char> isCollapsed_; // points
    std::vector<Label> cells_;      // that have a collapsed point
    DisjointSets uses_;             // corners of these cells that stay one point, see use()
};

} // namespace

OpenedCells openCollapsed(std::span<const MacroMesh::Corners> corners, Label pointCount) {
    return Opening(corners, pointCount).run();
}

} // namespace polymesh
