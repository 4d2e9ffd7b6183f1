// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trimCell/sidedness.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/trimCell/meetings.h"

#include <algorithm>
#include <array>

namespace polymesh {

void SearchedSurface::findNear(const Box& box, std::vector<Label>& triangles) const {
    triangles.clear();
    tree_.forEachNear(box, [&](Label t) {
        if (overlaps(cutter_.triangleBoxes[index(t)], box)) triangles.push_back(t);
    });
    std::ranges::sort(triangles);
}

int SearchedSurface::windingAlong(const Vec3& from, int axis) const {
    Vec3 to = from;
    to[axis] = std::max(box_.max[axis], from[axis]) + box_.size()[axis] + 1;
    Box box;
    box.add(from);
    box.add(to);
    int winding = 0;
    tree_.forEachNear(box, [&](Label t) {
        if (!overlaps(cutter_.triangleBoxes[index(t)], box)) return;
        // Far away is outside: each way into the domain makes up for one out of it before.
        if (const auto crossing = meetTriangle(from, to, cutter_.triangle(t)))
            winding -= crossing->sign;
    });
    return winding;
}

int SearchedSurface::windingOf(const Vec3& meshPoint) const {
    const int alongY = windingAlong(meshPoint, 1);
    return alongY == windingAlong(meshPoint, 2) ? alongY : windingAlong(meshPoint, 0);
}

std::vector<std::int8_t> windCellsOneByOne(const PolyMesh& mesh,
                                           const Probe& probe,
                                           const SearchedSurface& surface,
                                           int shift) {
    std::vector<Label> nodeOf(index(mesh.cellCount));
    for (Label f = 0; f < mesh.faceCount(); ++f) {
        nodeOf[index(mesh.owner[index(f)])] = mesh.faces[f][0];
        if (mesh.isInternal(f)) nodeOf[index(mesh.neighbour[index(f)])] = mesh.faces[f][0];
    }
    std::vector<std::int8_t> winding(index(mesh.cellCount), 0);
    parallelFor(mesh.cellCount, [&](Label c) {
        if (probe.localCell[index(c)] >= 0) return;
        const Vec3& node = mesh.points[index(nodeOf[index(c)])];
        winding[index(c)] = static_cast<std::int8_t>(surface.windingOf(node) + shift);
    });
    return winding;
}

} // namespace polymesh
