// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Comparing meshes whose faces may begin at other points and, between the same two cells, come in
// another order.

#include "libpolymesh/mesh/polyMesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

namespace polymesh::test {

/// A face: its cells (-1: none) and patch (-1: none), its loop from the lowest point on.
using FaceKey = std::tuple<Label, Label, Label, std::vector<Label>>;

/// The faces of a mesh, sorted.
inline std::vector<FaceKey> faceKeys(const PolyMesh& mesh) {
    std::vector<FaceKey> keys;
    std::size_t patch = 0;
    for (Label f = 0; f < mesh.faceCount(); ++f) {
        std::vector<Label> loop(mesh.faces[f].begin(), mesh.faces[f].end());
        std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
        const bool isInternal = mesh.isInternal(f);
        while (!isInternal && f >= mesh.patches[patch].start + mesh.patches[patch].size)
            ++patch;
        keys.emplace_back(mesh.owner[index(f)],
                          isInternal ? mesh.neighbour[index(f)] : -1,
                          isInternal ? -1 : toLabel(patch),
                          std::move(loop));
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

/// The first way in which the meshes differ in points (by more than `tolerance`), cells, faces and
/// the sizes of patches; empty when they do not. Names, types and zones are not looked at.
inline std::string differenceOf(const PolyMesh& a, const PolyMesh& b, double tolerance) {
    if (a.cellCount != b.cellCount) return fmt::format("{} and {} cells", a.cellCount, b.cellCount);
    if (a.faceCount() != b.faceCount())
        return fmt::format("{} and {} faces", a.faceCount(), b.faceCount());
    if (a.pointCount() != b.pointCount())
        return fmt::format("{} and {} points", a.pointCount(), b.pointCount());
    for (std::size_t p = 0; p < a.points.size(); ++p)
        if (const double d = norm(a.points[p] - b.points[p]); !(d <= tolerance))
            return fmt::format("point {} is {} away", p, d);
    const std::vector<FaceKey> facesOfA = faceKeys(a);
    const std::vector<FaceKey> facesOfB = faceKeys(b);
    const auto [inA, inB] = std::mismatch(facesOfA.begin(), facesOfA.end(), facesOfB.begin());
    if (inA == facesOfA.end()) return "";
    return fmt::format(
        "a face of cell {} in one, of cell {} in the other", std::get<0>(*inA), std::get<0>(*inB));
}

} // namespace polymesh::test
