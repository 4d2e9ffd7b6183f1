// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/shells.h"

#include "libpolymesh/base/disjointSets.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/surface/components.h"
#include "libpolymesh/surface/coplanar.h"
#include "libpolymesh/surface/triangleBoxes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace polymesh {

namespace {

/// Which components have sides that they do not close themselves: joins those that meet there, and
/// marks those that leave a gap.
class Closing {
public:
    explicit Closing(const Components& components)
        : components_(components), groups_(components.count), isOpen_(index(components.count), 0) {
        for (std::size_t c = 0; c < isOpen_.size(); ++c)
            isOpen_[c] = components.isOrientable[c] != 0 ? 0 : 1;
    }

    void addEdge(std::span<const SurfaceEdgeUse> edge) {
        excess_.clear();
        int total = 0;
        for (const SurfaceEdgeUse& use : edge) {
            const int sign = use.ascending ? 1 : -1;
            excess_[components_.ofTriangle[index(use.triangle)]] += sign;
            total += sign;
        }
        Label first = -1;
        for (const auto& [component, excess] : excess_) {
            if (excess == 0) continue;
            if (first >= 0) groups_.join(first, component);
            if (total != 0) isOpen_[index(component)] = 1;
            first = component;
        }
    }

    /// One row per closed group: its triangles. `openParts` gets the number of other groups.
    Rows<Label> closedGroups(Label& openParts) {
        std::vector<char> isOpenGroup(isOpen_.size(), 0);
        for (Label c = 0; c < components_.count; ++c)
            if (isOpen_[index(c)] != 0) isOpenGroup[index(groups_.lowest(c))] = 1;
        std::vector<Label> shellOf(isOpen_.size(), -1);
        Label count = 0;
        openParts = 0;
        for (Label c = 0; c < components_.count; ++c) {
            if (groups_.lowest(c) != c) continue;
            if (isOpenGroup[index(c)] != 0)
                ++openParts;
            else
                shellOf[index(c)] = count++;
        }
        std::vector<std::vector<Label>> members(index(count));
        for (Label t = 0; t < toLabel(components_.ofTriangle.size()); ++t) {
            const Label shell = shellOf[index(groups_.lowest(components_.ofTriangle[index(t)]))];
            if (shell >= 0) members[index(shell)].push_back(t);
        }
        Rows<Label> rows;
        for (const auto& row : members)
            rows.add(row);
        return rows;
    }

private:
    const Components& components_;
    DisjointSets groups_; // of components
    std::vector<char> isOpen_;
    std::map<Label, int> excess_; // of the edge at hand: component -> uses up minus down
};

/// Finds the points furthest along the axes and diagonals, both ways.
class Extremes {
public:
    void add(const Vec3& p) {
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const double reach = dot(directions[i], p);
            if (reach <= reach_[i]) continue;
            reach_[i] = reach;
            points_[i] = p;
        }
    }

    std::vector<Vec3> points() const { return {points_.begin(), points_.end()}; }

private:
    static constexpr std::array<Vec3, 14> directions{{{1, 0, 0},
                                                      {-1, 0, 0},
                                                      {0, 1, 0},
                                                      {0, -1, 0},
                                                      {0, 0, 1},
                                                      {0, 0, -1},
                                                      {1, 1, 1},
                                                      {-1, -1, -1},
                                                      {1, 1, -1},
                                                      {-1, -1, 1},
                                                      {1, -1, 1},
                                                      {-1, 1, -1},
                                                      {1, -1, -1},
                                                      {-1, 1, 1}}};

    std::array<Vec3, directions.size()> points_;
    std::array<double, directions.size()> reach_ = [] {
        std::array<double, directions.size()> lowest{};
        lowest.fill(-Box::inf);
        return lowest;
    }();
};

int findOrientation(const TriSurface& surface,
                    std::span<const Label> triangles,
                    const Vec3& middle) {
    long double volume = 0;
    long double size = 0;
    for (Label t : triangles) {
        const Vec3 a = surface.corner(t, 0) - middle;
        const double term =
            dot(a, cross(surface.corner(t, 1) - middle, surface.corner(t, 2) - middle));
        volume += term;
        size += std::abs(term);
    }
    constexpr long double rounding = 1e-14L;
    if (std::abs(volume) <= rounding * size) return 0;
    return volume > 0 ? 1 : -1;
}

std::array<Vec3, 3> cornersOf(const TriSurface& surface, Label t) {
    return {surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)};
}

bool isOnShell(const TriSurface& surface, std::span<const Label> triangles, const Vec3& p) {
    return std::ranges::any_of(triangles, [&](Label t) {
        return triangleBox(surface, t).contains(p) && isOnTriangle(cornersOf(surface, t), p);
    });
}

/// True when the vertical line from p up to q crosses the triangle.
bool isCrossed(const std::array<Vec3, 3>& t, const Vec3& p, const Vec3& q) {
    if (sideOfTriangle(t, p).sign == sideOfTriangle(t, q).sign) return false;
    const int side = passingSide(p, q, t[0], t[1]).sign;
    return passingSide(p, q, t[1], t[2]).sign == side && passingSide(p, q, t[2], t[0]).sign == side;
}

bool isInShell(const TriSurface& surface,
               std::span<const Label> triangles,
               const Box& box,
               const Vec3& p) {
    const Vec3 q{p.x, p.y, box.max.z + box.size().z + 1};
    const Box line{p, q};
    bool inside = false;
    for (Label t : triangles)
        if (overlaps(triangleBox(surface, t), line) && isCrossed(cornersOf(surface, t), p, q))
            inside = !inside;
    return inside;
}

bool contains(const Box& outer, const Box& inner) {
    return outer.contains(inner.min) && outer.contains(inner.max);
}

} // namespace

Shells findShells(const TriSurface& surface) {
    const Rows<SurfaceEdgeUse> uses = collectEdgeUses(surface);
    const Components components = findComponents(surface, uses);
    Closing closing(components);
    for (Label lower = 0; lower < uses.size(); ++lower)
        forEachEdge(uses[lower], [&](std::span<const SurfaceEdgeUse> edge) {
            const bool isPlain = edge.size() == 2 && edge[0].ascending != edge[1].ascending;
            if (!isPlain) closing.addEdge(edge);
        });
    Shells shells;
    shells.triangles = closing.closedGroups(shells.openParts);
    for (Label shell = 0; shell < shells.count(); ++shell) {
        const auto triangles = shells.triangles[shell];
        Box box;
        Extremes extremes;
        for (Label t : triangles) {
            box.add(triangleBox(surface, t));
            for (const Vec3& p : cornersOf(surface, t))
                extremes.add(p);
        }
        shells.box.push_back(box);
        shells.extreme.push_back(extremes.points());
        shells.orientation.push_back(findOrientation(surface, triangles, box.centre()));
    }
    return shells;
}

bool isInside(const TriSurface& surface, const Shells& shells, Label inner, Label outer) {
    const Box& box = shells.box[index(outer)];
    if (!contains(box, shells.box[index(inner)])) return false;
    const auto triangles = shells.triangles[outer];
    bool known = false;
    for (const Vec3& p : shells.extreme[index(inner)]) {
        if (isOnShell(surface, triangles, p)) continue;
        if (!isInShell(surface, triangles, box, p)) return false;
        known = true;
    }
    return known;
}

} // namespace polymesh
