// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/uniteCollapsed.h"

#include "libpolymesh/base/error.h"

#include <algorithm>
#include <numeric>

namespace polymesh {
namespace {

/// For each point the lowest one that coincides with it.
std::vector<Label>
lowestCoincident(const CollapsedEdges& collapsed, const PointTable& table, std::size_t pointCount) {
    std::vector<Label> same(pointCount);
    std::iota(same.begin(), same.end(), Label{0});
    std::vector<std::pair<EdgePlace, Label>> onEdges;
    const auto add = [&](Label tree, const LatticePoint& p, Label label) {
        const auto place = collapsed.placeOf(tree, p);
        if (!place) return;
        if (place->low == place->high)
            same[index(label)] = place->low;
        else
            onEdges.push_back({*place, label});
    };
    for (const Label tree : collapsed.trees()) {
        for (std::size_t c = 0; c < 8; ++c)
            add(tree, Octant{}.corner(c), table.find(tree, Octant{}.corner(c)));
        table.forPointsOf(tree, [&](const LatticePoint& p, Label label) { add(tree, p, label); });
    }
    std::ranges::sort(onEdges);
    for (std::size_t i = 1; i < onEdges.size(); ++i)
        if (onEdges[i].first == onEdges[i - 1].first)
            same[index(onEdges[i].second)] = same[index(onEdges[i - 1].second)];
    return same;
}

/// Removes the points that others stand for; turns `same` into their new labels.
void removePoints(std::vector<Label>& same, RefinedMesh& refined) {
    std::size_t count = 0;
    for (std::size_t p = 0; p < same.size(); ++p) {
        if (index(same[p]) != p) {
            same[p] = same[index(same[p])]; // lower, so it has its new label
            continue;
        }
        same[p] = toLabel(count);
        refined.mesh.points[count] = refined.mesh.points[p];
        refined.pointLevel[count++] = refined.pointLevel[p];
    }
    refined.mesh.points.resize(count);
    refined.pointLevel.resize(count);
}

/// Appends a face with new labels, none twice in turn; false when it has no area.
bool addFace(std::span<const Label> face, const std::vector<Label>& labels, Rows<Label>& faces) {
    const std::size_t first = faces.values.size();
    for (const Label p : face)
        if (faces.values.size() == first || faces.values.back() != labels[index(p)])
            faces.values.push_back(labels[index(p)]);
    while (faces.values.size() > first + 1 && faces.values.back() == faces.values[first])
        faces.values.pop_back();
    if (faces.values.size() < first + 3) {
        faces.values.resize(first);
        return false;
    }
    faces.offsets.push_back(toLabel(faces.values.size()));
    return true;
}

void removeFaces(const std::vector<Label>& labels, PolyMesh& mesh) {
    Rows<Label> faces;
    std::vector<Label> owner;
    const auto copy = [&](Label f) {
        if (!addFace(mesh.faces[f], labels, faces)) return false;
        owner.push_back(mesh.owner[index(f)]);
        return true;
    };
    for (Label f = 0; f < mesh.internalFaceCount(); ++f)
        if (!copy(f)) throw WorkError("a face between two cells of the refined mesh has no area");
    for (Patch& patch : mesh.patches) {
        const Label end = patch.start + patch.size;
        const Label start = toLabel(owner.size());
        for (Label f = patch.start; f < end; ++f)
            copy(f);
        patch.start = start;
        patch.size = toLabel(owner.size()) - start;
    }
    mesh.faces = std::move(faces);
    mesh.owner = std::move(owner);
}

} // namespace

void uniteCollapsed(const CollapsedEdges& collapsed,
                    const PointTable& table,
                    RefinedMesh& refined) {
    std::vector<Label> labels = lowestCoincident(collapsed, table, refined.mesh.points.size());
    removePoints(labels, refined);
    removeFaces(labels, refined.mesh);
}

} // namespace polymesh
