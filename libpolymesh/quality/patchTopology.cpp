// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/patchTopology.h"

#include "libpolymesh/base/disjointSets.h"

#include <algorithm>
#include <tuple>

namespace polymesh {

namespace {

/// One side of an edge; corners are numbered through all faces of the patch.
struct Use {
    Label low;
    Label high;
    Label lowCorner;
    Label highCorner;

    bool isSameEdge(const Use& other) const { return low == other.low && high == other.high; }
};

std::vector<Use> edgeUses(const PolyMesh& mesh, std::span<const Label> faces) {
    std::vector<Use> uses;
    Label corner = 0;
    for (const Label face : faces) {
        const std::span<const Label> points = mesh.faces[face];
        const Label size = toLabel(points.size());
        for (Label i = 0; i < size; ++i) {
            const Label j = i + 1 == size ? 0 : i + 1;
            const Label a = points[index(i)];
            const Label b = points[index(j)];
            uses.push_back(a < b ? Use{a, b, corner + i, corner + j}
                                 : Use{b, a, corner + j, corner + i});
        }
        corner += size;
    }
    std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
        return std::tie(a.low, a.high, a.lowCorner) < std::tie(b.low, b.high, b.lowCorner);
    });
    return uses;
}

void makeUnique(std::vector<Label>& labels) {
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
}

/// Points of a closed surface at which its faces fall into several rings.
std::vector<Label>
sharedPoints(const PolyMesh& mesh, std::span<const Label> faces, const std::vector<Use>& uses) {
    DisjointSets corners(toLabel(uses.size())); // as many corners as uses
    for (std::size_t i = 1; i < uses.size(); ++i)
        if (uses[i].isSameEdge(uses[i - 1])) {
            corners.join(uses[i].lowCorner, uses[i - 1].lowCorner);
            corners.join(uses[i].highCorner, uses[i - 1].highCorner);
        }
    std::vector<std::pair<Label, Label>> rings; // point, lowest corner
    Label corner = 0;
    for (const Label face : faces)
        for (const Label point : mesh.faces[face])
            rings.emplace_back(point, corners.lowest(corner++));
    std::sort(rings.begin(), rings.end());
    rings.erase(std::unique(rings.begin(), rings.end()), rings.end());
    std::vector<Label> shared;
    for (std::size_t i = 1; i < rings.size(); ++i)
        if (rings[i].first == rings[i - 1].first) shared.push_back(rings[i].first);
    makeUnique(shared);
    return shared;
}

} // namespace

PatchTopology
patchTopology(const PolyMesh& mesh, const std::string& name, std::span<const Label> faces) {
    PatchTopology result;
    result.name = name;
    result.faces = toLabel(faces.size());
    if (faces.empty()) return result;
    std::vector<Label> points;
    for (const Label face : faces)
        points.insert(points.end(), mesh.faces[face].begin(), mesh.faces[face].end());
    makeUnique(points);
    result.points = toLabel(points.size());
    for (const Label point : points)
        result.box.add(mesh.points[index(point)]);

    const std::vector<Use> uses = edgeUses(mesh, faces);
    bool isOpen = false;
    for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
        while (last < uses.size() && uses[last].isSameEdge(uses[first]))
            ++last;
        isOpen = isOpen || last - first == 1;
        if (last - first > 2)
            result.conflictingPoints.insert(result.conflictingPoints.end(),
                                            {uses[first].low, uses[first].high});
    }
    makeUnique(result.conflictingPoints);
    if (!result.conflictingPoints.empty()) {
        result.kind = SurfaceKind::sharedEdge;
    } else if (isOpen) {
        result.kind = SurfaceKind::open;
    } else {
        result.conflictingPoints = sharedPoints(mesh, faces, uses);
        result.kind =
            result.conflictingPoints.empty() ? SurfaceKind::closed : SurfaceKind::sharedPoint;
    }
    return result;
}

std::string describe(SurfaceKind kind) {
    switch (kind) {
    case SurfaceKind::empty:
        return "ok (empty)";
    case SurfaceKind::closed:
        return "ok (closed singly connected)";
    case SurfaceKind::sharedPoint:
        return "multiply connected (shared point)";
    case SurfaceKind::open:
        return "ok (non-closed singly connected)";
    case SurfaceKind::sharedEdge:
        return "multiply connected (shared edge)";
    }
    return {};
}

} // namespace polymesh
