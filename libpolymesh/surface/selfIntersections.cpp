// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/base/parallelSort.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/surface/boxTree.h"
#include "libpolymesh/surface/check.h"
#include "libpolymesh/surface/coplanar.h"
#include "libpolymesh/surface/triangleBoxes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <algorithm>
#include <cstdlib>

namespace polymesh {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Pairs = std::vector<std::array<Label, 2>>;

Kernel::Point_3 toCgal(const Vec3& p) {
    return {p.x, p.y, p.z};
}

/// A triangle's points and labels, turned so that those that it shares with another come first.
struct Corners {
    std::array<Vec3, 3> points;
    int shared = 0;
};

Corners sharedFirst(const TriSurface& surface, Label t, Label other) {
    auto labels = surface.triangles[index(t)];
    const auto& others = surface.triangles[index(other)];
    const auto middle = std::stable_partition(labels.begin(), labels.end(), [&](Label corner) {
        return std::ranges::find(others, corner) != others.end();
    });
    Corners corners;
    corners.shared = static_cast<int>(middle - labels.begin());
    for (std::size_t i = 0; i < 3; ++i)
        corners.points[i] = surface.points[index(labels[i])];
    return corners;
}

bool intersectsOppositeSide(const Corners& corners, const Corners& other) {
    const auto& p = corners.points[1];
    const auto& q = corners.points[2];
    const auto& [a, b, c] = other.points;
    const int sideOfP = orient3d(a, b, c, p);
    const int sideOfQ = orient3d(a, b, c, q);
    if (sideOfP == 0 && sideOfQ == 0)
        return CGAL::do_intersect(Kernel::Segment_3(toCgal(p), toCgal(q)),
                                  Kernel::Triangle_3(toCgal(a), toCgal(b), toCgal(c)));
    if (sideOfP == sideOfQ) return false;
    // The segment's line meets the plane in one point, which is in the triangle when no two sides
    // pass the line on opposite sides.
    const std::array<int, 3> sides{
        orient3d(p, q, a, b), orient3d(p, q, b, c), orient3d(p, q, c, a)};
    const auto [least, most] = std::ranges::minmax(sides);
    return least >= 0 || most <= 0;
}

bool areFoldedTogether(const Corners& s, const Corners& t) {
    const auto& [a, b, c] = s.points;
    const Vec3& d = t.points[2];
    // Corners may be in another order in t, but both have the shared side first.
    return orient3d(a, b, c, d) == 0 && sideOfLine(a, b, c, d) > 0;
}

bool doIntersect(const Corners& s, const Corners& t) {
    const auto isFlat = [](const Corners& corners) {
        return areCollinear(corners.points[0], corners.points[1], corners.points[2]);
    };
    if (isFlat(s) || isFlat(t)) return false;
    if (s.shared == 3) return true;
    if (s.shared == 2) return areFoldedTogether(s, t);
    if (s.shared == 1) return intersectsOppositeSide(s, t) || intersectsOppositeSide(t, s);
    return CGAL::do_intersect(
        Kernel::Triangle_3(toCgal(s.points[0]), toCgal(s.points[1]), toCgal(s.points[2])),
        Kernel::Triangle_3(toCgal(t.points[0]), toCgal(t.points[1]), toCgal(t.points[2])));
}

/// True when t's own corners lie strictly on one side of s's plane, so that t meets s at most in
/// the corners that they share: most neighbours are done with here.
bool isBeside(const TriSurface& surface, Label s, Label t) {
    const auto& corners = surface.triangles[index(s)];
    int sides = 0;
    int count = 0;
    for (Label corner : surface.triangles[index(t)]) {
        if (std::ranges::find(corners, corner) != corners.end()) continue;
        ++count;
        sides += orient3d(surface.corner(s, 0),
                          surface.corner(s, 1),
                          surface.corner(s, 2),
                          surface.points[index(corner)]);
    }
    return count > 0 && std::abs(sides) == count;
}

/// True when the triangles, whose boxes overlap, meet in more than corners and sides they share.
bool meet(const TriSurface& surface, Label s, Label t) {
    if (isBeside(surface, s, t) || isBeside(surface, t, s)) return false;
    return doIntersect(sharedFirst(surface, s, t), sharedFirst(surface, t, s));
}

/// All pairs that meet, in order.
Pairs findPairs(const TriSurface& surface) {
    const std::vector<Box> boxes = triangleBoxes(surface);
    const BoxTree tree(boxes);
    const auto nodePairs = tree.nodePairs();
    std::vector<Pairs> blocks(nodePairs.size());
    parallelBlocks(toLabel(nodePairs.size()), 1, [&](Label block, Label, Label) {
        tree.forEachPair(nodePairs[index(block)], [&](Label a, Label b) {
            const auto [s, t] = std::minmax(a, b);
            if (overlaps(boxes[index(s)], boxes[index(t)]) && meet(surface, s, t))
                blocks[index(block)].push_back({s, t});
        });
    });
    Pairs pairs;
    for (const Pairs& block : blocks)
        pairs.insert(pairs.end(), block.begin(), block.end());
    parallelSort(pairs);
    return pairs;
}

} // namespace

SelfIntersections findSelfIntersections(const TriSurface& surface, Label most) {
    SelfIntersections found;
    found.first = findPairs(surface);
    found.count = toLabel(found.first.size());
    found.first.resize(index(std::min(found.count, most)));
    return found;
}

} // namespace polymesh
