// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/orient.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/surface/components.h"
#include "libpolymesh/surface/shells.h"

#include <algorithm>
#include <utility>

namespace polymesh {

namespace {

/// Twice gives the triangle back as it was.
void turn(TriSurface& surface, Label t) {
    auto& corners = surface.triangles[index(t)];
    std::swap(corners[1], corners[2]);
}

/// Turns the minority of each component that can be oriented; returns which triangles were turned.
std::vector<char> makeConsistent(TriSurface& surface, const Components& components) {
    std::vector<Label> balance(index(components.count), 0); // triangles against minus along
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        balance[index(components.ofTriangle[t])] += components.isAgainst[t] != 0 ? 1 : -1;
    std::vector<char> isTurned(surface.triangles.size(), 0);
    for (Label t = 0; t < surface.triangleCount(); ++t) {
        const Label component = components.ofTriangle[index(t)];
        if (components.isOrientable[index(component)] == 0) continue;
        const bool againstIsMinority = balance[index(component)] <= 0;
        if ((components.isAgainst[index(t)] != 0) != againstIsMinority) continue;
        turn(surface, t);
        isTurned[index(t)] = 1;
    }
    return isTurned;
}

/// For each shell, how many others it lies in.
std::vector<Label> findDepths(const TriSurface& surface, const Shells& shells) {
    std::vector<Label> depths(index(shells.count()), 0);
    parallelBlocks(shells.count(), 1, [&](Label shell, Label, Label) {
        for (Label other = 0; other < shells.count(); ++other)
            if (other != shell && isInside(surface, shells, shell, other)) ++depths[index(shell)];
    });
    return depths;
}

/// Turns the shells whose normals point the wrong way for their depth.
void turnShells(TriSurface& surface, std::vector<char>& isTurned, OrientationReport& report) {
    const Shells shells = findShells(surface);
    const std::vector<Label> depths = findDepths(surface, shells);
    report.shells = shells.count();
    report.openParts = shells.openParts;
    for (Label shell = 0; shell < shells.count(); ++shell) {
        const bool isCavity = depths[index(shell)] % 2 == 1;
        report.nestedShells += isCavity ? 1 : 0;
        const int wanted = isCavity ? -1 : 1;
        if (shells.orientation[index(shell)] != -wanted) continue;
        report.nestedTurned += isCavity ? 1 : 0;
        for (Label t : shells.triangles[shell]) {
            turn(surface, t);
            isTurned[index(t)] = isTurned[index(t)] != 0 ? 0 : 1;
        }
    }
}

} // namespace

OrientationReport orientSurface(TriSurface& surface) {
    OrientationReport report;
    std::vector<char> isTurned =
        makeConsistent(surface, findComponents(surface, collectEdgeUses(surface)));
    turnShells(surface, isTurned, report);
    report.turnedTriangles = toLabel(static_cast<std::size_t>(std::ranges::count(isTurned, 1)));
    report.turnedAll =
        report.turnedTriangles > 0 && report.turnedTriangles == surface.triangleCount();
    return report;
}

} // namespace polymesh
