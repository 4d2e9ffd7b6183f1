// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/edges.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/surface/coplanar.h"
#include "libpolymesh/surface/edgeUses.h"

#include <algorithm>

namespace polymesh {

namespace {

using Uses = std::vector<SurfaceEdgeUse>;

/// Orders the triangles round an edge by angle, counted right-handedly about lower -> upper.
class AngularOrder {
public:
    AngularOrder(const TriSurface& surface, Label lower, Label upper)
        : surface_(surface),
          lower_(surface.points[index(lower)]),
          upper_(surface.points[index(upper)]) {}

    /// Puts triangles without an angle last, by label.
    void sort(Uses& uses) {
        const auto flat =
            std::stable_partition(uses.begin(), uses.end(), [&](const SurfaceEdgeUse& use) {
                return !areCollinear(lower_, upper_, apex(use));
            });
        if (flat == uses.begin()) return;
        reference_ = apex(uses.front());
        std::sort(uses.begin(), flat, [&](const SurfaceEdgeUse& a, const SurfaceEdgeUse& b) {
            return isBefore(a, b);
        });
    }

private:
    const Vec3& apex(const SurfaceEdgeUse& use) const {
        return surface_.corner(use.triangle, (use.corner + 2) % 3);
    }

    /// 0 at the reference, 1 up to half a turn, 2 at half a turn, 3 beyond.
    int sector(const Vec3& p) const {
        const int side = orient3d(lower_, upper_, reference_, p);
        if (side != 0) return side > 0 ? 1 : 3;
        return sideOfLine(lower_, upper_, reference_, p) > 0 ? 0 : 2;
    }

    bool isBefore(const SurfaceEdgeUse& a, const SurfaceEdgeUse& b) const {
        const int sectorA = sector(apex(a));
        const int sectorB = sector(apex(b));
        if (sectorA != sectorB) return sectorA < sectorB;
        const int turn = orient3d(lower_, upper_, apex(a), apex(b));
        if (turn != 0) return turn > 0;
        if (a.ascending != b.ascending) return a.ascending;
        return a.triangle < b.triangle;
    }

    const TriSurface& surface_;
    Vec3 lower_;
    Vec3 upper_;
    Vec3 reference_;
};

/// Reorders the uses of an edge so that places 2i and 2i + 1 are partners, ascending one first.
///
/// Going round the edge, a descending use begins an interior and an ascending one ends it, so
/// partners are matched like brackets; two rounds also match those that enclose the first place.
void matchRound(Uses& uses) {
    Uses open;
    Uses paired;
    std::vector<bool> isPaired(uses.size(), false);
    for (int round = 0; round < 2; ++round) {
        for (std::size_t i = 0; i < uses.size(); ++i) {
            if (isPaired[i]) continue;
            if (!uses[i].ascending) {
                if (round == 0) open.push_back(uses[i]);
            } else if (!open.empty()) {
                paired.insert(paired.end(), {uses[i], open.back()});
                open.pop_back();
                isPaired[i] = true;
            }
        }
    }
    uses = std::move(paired);
}

/// The uses of one edge as partners, see matchRound.
Uses pairUses(const TriSurface& surface, Label lower, std::span<const SurfaceEdgeUse> row) {
    Uses uses(row.begin(), row.end());
    AngularOrder(surface, lower, row.front().upper).sort(uses);
    matchRound(uses);
    return uses;
}

bool isBalanced(std::span<const SurfaceEdgeUse> uses) {
    const auto ascending = std::ranges::count_if(uses, &SurfaceEdgeUse::ascending);
    return 2 * static_cast<std::size_t>(ascending) == uses.size();
}

bool areClosed(const Rows<SurfaceEdgeUse>& uses) {
    return parallelReduce(
        uses.size(),
        true,
        [&](Label point) {
            bool closed = true;
            forEachEdge(uses[point], [&](auto edge) { closed = closed && isBalanced(edge); });
            return closed;
        },
        [](bool a, bool b) { return a && b; });
}

void requireClosed(const TriSurface& surface, const Rows<SurfaceEdgeUse>& uses) {
    if (areClosed(uses)) return;
    const auto open = openEdges(surface);
    const Vec3& a = surface.points[index(open.front()[0])];
    const Vec3& b = surface.points[index(open.front()[1])];
    throw InputError(
        fmt::format("the surface is not closed: {} open or wrongly oriented edges, the "
                    "first from ({} {} {}) to ({} {} {})",
                    open.size(),
                    a.x,
                    a.y,
                    a.z,
                    b.x,
                    b.y,
                    b.z));
}

void addEdge(SurfaceEdges& edges,
             Label label,
             Label lower,
             const SurfaceEdgeUse& up,
             const SurfaceEdgeUse& down) {
    edges.edges[index(label)] = {lower, up.upper, up.triangle, down.triangle};
    edges.ofTriangle[index(up.triangle)][static_cast<std::size_t>(up.corner)] = label;
    edges.ofTriangle[index(down.triangle)][static_cast<std::size_t>(down.corner)] = label;
}

} // namespace

SurfaceEdges pairEdges(const TriSurface& surface) {
    const Rows<SurfaceEdgeUse> uses = collectEdgeUses(surface);
    requireClosed(surface, uses);
    SurfaceEdges edges;
    edges.edges.resize(uses.values.size() / 2);
    edges.ofTriangle.resize(surface.triangles.size());
    parallelFor(uses.size(), [&](Label lower) {
        Label label = uses.offsets[index(lower)] / 2; // every earlier use has its partner
        forEachEdge(uses[lower], [&](std::span<const SurfaceEdgeUse> row) {
            if (row.size() == 2) {
                const std::size_t up = row[0].ascending ? 0 : 1;
                addEdge(edges, label++, lower, row[up], row[1 - up]);
                return;
            }
            const Uses paired = pairUses(surface, lower, row);
            for (std::size_t i = 0; i < paired.size(); i += 2)
                addEdge(edges, label++, lower, paired[i], paired[i + 1]);
        });
    });
    return edges;
}

bool isPinched(const SurfaceEdges& edges) {
    const auto isSame = [](const SurfaceEdge& a, const SurfaceEdge& b) {
        return a.start == b.start && a.end == b.end;
    };
    return std::ranges::adjacent_find(edges.edges, isSame) != edges.edges.end();
}

std::vector<std::array<Label, 2>> openEdges(const TriSurface& surface) {
    const Rows<SurfaceEdgeUse> uses = collectEdgeUses(surface);
    std::vector<std::array<Label, 2>> open;
    for (Label lower = 0; lower < uses.size(); ++lower) {
        forEachEdge(uses[lower], [&](std::span<const SurfaceEdgeUse> row) {
            const auto size = static_cast<std::ptrdiff_t>(row.size());
            const auto excess = 2 * std::ranges::count_if(row, &SurfaceEdgeUse::ascending) - size;
            const std::array<Label, 2> up{lower, row.front().upper};
            const std::array<Label, 2> down{row.front().upper, lower};
            open.insert(
                open.end(), static_cast<std::size_t>(std::abs(excess)), excess > 0 ? up : down);
        });
    }
    return open;
}

} // namespace polymesh
