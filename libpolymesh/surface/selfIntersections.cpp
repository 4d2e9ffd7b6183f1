// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/parallel.h"
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
    const Kernel::Segment_3 side(toCgal(corners.points[1]), toCgal(corners.points[2]));
    const Kernel::Triangle_3 triangle(
        toCgal(other.points[0]), toCgal(other.points[1]), toCgal(other.points[2]));
    return CGAL::do_intersect(side, triangle);
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

void collectPairs(const TriSurface& surface,
                  const std::vector<Box>& boxes,
                  const BoxTree& tree,
                  Label s,
                  Pairs& pairs) {
    tree.forEachNear(boxes[index(s)], [&](Label t) {
        if (t <= s || !overlaps(boxes[index(s)], boxes[index(t)])) return;
        if (isBeside(surface, s, t) || isBeside(surface, t, s)) return;
        if (doIntersect(sharedFirst(surface, s, t), sharedFirst(surface, t, s)))
            pairs.push_back({s, t});
    });
}

} // namespace

SelfIntersections findSelfIntersections(const TriSurface& surface, Label most) {
    const std::vector<Box> boxes = triangleBoxes(surface);
    const BoxTree tree(boxes);
    constexpr Label blockSize = 1024;
    std::vector<Pairs> blocks(index((surface.triangleCount() + blockSize - 1) / blockSize));
    parallelBlocks(surface.triangleCount(), blockSize, [&](Label block, Label first, Label last) {
        for (Label s = first; s < last; ++s)
            collectPairs(surface, boxes, tree, s, blocks[index(block)]);
        std::ranges::sort(blocks[index(block)]);
    });
    SelfIntersections found;
    for (const Pairs& pairs : blocks) {
        found.count += toLabel(pairs.size());
        for (const auto& pair : pairs)
            if (toLabel(found.first.size()) < most) found.first.push_back(pair);
    }
    return found;
}

} // namespace polymesh
