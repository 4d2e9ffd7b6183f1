// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/joinFaces.h"

#include <algorithm>
#include <utility>

namespace polymesh {
namespace {

/// A face of the new mesh: an old one, between these cells.
struct NewFace {
    Label owner = 0;
    Label neighbour = 0;
    Label old = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr): what the compiler makes of it
    auto operator<=>(const NewFace&) const = default;
};

std::vector<NewFace> internalFaces(const PolyMesh& mesh, const std::vector<FacePair>& pairs) {
    std::vector<NewFace> faces;
    faces.reserve(mesh.neighbour.size() + pairs.size());
    for (Label f = 0; f < mesh.internalFaceCount(); ++f)
        faces.push_back({mesh.owner[index(f)], mesh.neighbour[index(f)], f});
    for (const auto& [a, b] : pairs) {
        // The face of the lower cell: its normal points to the other one.
        const bool aFirst = mesh.owner[index(a)] < mesh.owner[index(b)];
        faces.push_back(
            {mesh.owner[index(aFirst ? a : b)], mesh.owner[index(aFirst ? b : a)], aFirst ? a : b});
    }
    // The old ones are in order (law 2 of PolyMesh).
    const auto joined = faces.begin() + mesh.internalFaceCount();
    std::sort(joined, faces.end());
    std::inplace_merge(faces.begin(), joined, faces.end());
    return faces;
}

void removeUnusedPoints(PolyMesh& mesh, std::vector<Label>& merged) {
    std::vector<Label> numbers(mesh.points.size());
    std::size_t kept = 0;
    for (std::size_t p = 0; p < mesh.points.size(); ++p) {
        if (index(merged[p]) != p) continue;
        mesh.points[kept] = mesh.points[p];
        numbers[p] = toLabel(kept++);
    }
    mesh.points.resize(kept);
    for (Label& p : merged)
        p = numbers[index(p)];
}

void addFace(const PolyMesh& from, Label face, const std::vector<Label>& merged, PolyMesh& to) {
    for (const Label p : from.faces[face])
        to.faces.values.push_back(merged[index(p)]);
    to.faces.offsets.push_back(toLabel(to.faces.values.size()));
    to.owner.push_back(from.owner[index(face)]);
}

} // namespace

void joinFaces(PolyMesh& mesh, std::vector<Label> merged, const std::vector<FacePair>& pairs) {
    std::vector<bool> isGone(mesh.owner.size(), false);
    for (const auto& [a, b] : pairs)
        isGone[index(a)] = isGone[index(b)] = true;
    removeUnusedPoints(mesh, merged);
    PolyMesh result;
    for (const NewFace& face : internalFaces(mesh, pairs)) {
        addFace(mesh, face.old, merged, result);
        result.neighbour.push_back(face.neighbour);
    }
    for (Patch patch : mesh.patches) {
        const Label first = patch.start;
        const Label last = patch.start + patch.size;
        patch.start = toLabel(result.owner.size());
        for (Label f = first; f < last; ++f)
            if (!isGone[index(f)]) addFace(mesh, f, merged, result);
        const bool wasEmpty = patch.size == 0;
        patch.size = toLabel(result.owner.size()) - patch.start;
        if (patch.size > 0 || wasEmpty) result.patches.push_back(std::move(patch));
    }
    result.points = std::move(mesh.points);
    result.cellZones = std::move(mesh.cellZones);
    result.cellCount = mesh.cellCount;
    mesh = std::move(result);
}

} // namespace polymesh
