// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/trim/arrangement.h"

#include <algorithm>

namespace polymesh {

namespace {

/// Appends the crossing of the edge a b with a triangle, if there is one.
void cross(const Vec3& a,
           const Vec3& b,
           const CuttingSurface& cutter,
           Label t,
           std::vector<EdgeCrossing>& found) {
    const std::array<Vec3, 3> triangle = cutter.triangle(t);
    const MovedSign atA = sideOfTriangle(triangle, a);
    const MovedSign atB = sideOfTriangle(triangle, b);
    if (atA.sign == atB.sign) return;
    std::uint8_t zeros = 0;
    if (atA.wasZero) zeros |= 1;
    if (atB.wasZero) zeros |= 2;
    std::int8_t side = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const MovedSign passing = passingSide(a, b, triangle[i], triangle[(i + 1) % 3]);
        if (i > 0 && passing.sign != side) return;
        side = passing.sign;
        if (passing.wasZero) zeros = static_cast<std::uint8_t>(zeros | (4 << i));
    }
    found.push_back({t, atB.sign < 0 ? std::int8_t{1} : std::int8_t{-1}, zeros});
}

} // namespace

void crossEdges(const Probe& probe, const CuttingSurface& cutter, Arrangement& arrangement) {
    constexpr Label block = 2048;
    arrangement.nodeCount = probe.nodeCount();
    std::vector<Rows<EdgeCrossing>> parts(index((probe.edgeCount() + block - 1) / block));
    parallelBlocks(probe.edgeCount(), block, [&](Label part, Label first, Label last) {
        std::vector<EdgeCrossing> found;
        for (Label e = first; e < last; ++e) {
            found.clear();
            const Vec3& a = probe.nodePoints[index(probe.edges[index(e)][0])];
            const Vec3& b = probe.nodePoints[index(probe.edges[index(e)][1])];
            Box box;
            box.add(a);
            box.add(b);
            for (const Label t : probe.triangles[probe.edgeCell[index(e)]])
                if (overlaps(cutter.triangleBoxes[index(t)], box)) cross(a, b, cutter, t, found);
            if (found.size() > 1)
                std::ranges::sort(found, [&](const EdgeCrossing& s, const EdgeCrossing& t) {
                    const int order = compareAlongMeshEdge(
                        a, b, cutter.triangle(s.triangle), cutter.triangle(t.triangle));
                    return order != 0 ? order < 0 : s.triangle < t.triangle;
                });
            parts[index(part)].add(found);
        }
    });
    arrangement.crossings = joined(parts);
}

} // namespace polymesh
