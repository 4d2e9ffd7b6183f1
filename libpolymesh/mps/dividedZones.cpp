// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/dividedZones.h"

#include <algorithm>
#include <utility>

namespace polymesh {

namespace {

Zone dividedFaceZone(const PolyMesh& mesh, const std::vector<Label>& children, const Zone& zone) {
    std::vector<std::pair<Label, bool>> faces;
    for (std::size_t i = 0; i < zone.labels.size(); ++i) {
        const Label face = zone.labels[i];
        const bool isFlipped = i < zone.flip.size() && zone.flip[i];
        for (Label at = mesh.faces.offsets[index(face)]; at < mesh.faces.offsets[index(face) + 1];
             ++at)
            faces.emplace_back(children[index(at)], isFlipped);
    }
    std::ranges::sort(faces);
    Zone divided{zone.name, {}, {}};
    for (const auto& [face, isFlipped] : faces) {
        divided.labels.push_back(face);
        divided.flip.push_back(isFlipped);
    }
    return divided;
}

} // namespace

std::vector<Label> dividedCells(const SubdivisionPlan& plan, std::span<const Label> cells) {
    std::vector<Label> parts;
    for (const Label cell : cells)
        for (Label part = plan.firstPart[index(cell)]; part < plan.firstPart[index(cell) + 1];
             ++part)
            parts.push_back(part);
    return parts;
}

std::vector<Label>
dividedPoints(const PolyMesh& mesh, const SubdivisionPlan& plan, std::span<const Label> points) {
    std::vector<char> isIn(plan.points.size(), 0);
    for (const Label point : points)
        isIn[index(point)] = 1;
    for (Label edge = 0; edge < plan.edges.size(); ++edge) {
        const auto [a, b] = plan.edges.points[index(edge)];
        isIn[index(plan.layout.firstEdge + edge)] =
            isIn[index(a)] != 0 && isIn[index(b)] != 0 ? 1 : 0;
    }
    const auto isFaceIn = [&](Label face) {
        return std::ranges::all_of(mesh.faces[face], [&](Label p) { return isIn[index(p)] != 0; });
    };
    for (Label face = 0; face < mesh.faceCount(); ++face)
        isIn[index(plan.layout.firstFace + face)] = isFaceIn(face) ? 1 : 0;
    for (Label cell = 0; cell < mesh.cellCount; ++cell) {
        const bool isCellIn = std::ranges::all_of(plan.cellFaces[cell], [&](Label face) {
            return isIn[index(plan.layout.firstFace + face)] != 0;
        });
        isIn[index(plan.layout.firstCell + cell)] = isCellIn ? 1 : 0;
        for (Label a = plan.firstApex[index(cell)]; a < plan.firstApex[index(cell) + 1]; ++a)
            isIn[index(plan.layout.firstApex + a)] = isCellIn ? 1 : 0;
    }
    std::vector<Label> all;
    for (std::size_t p = 0; p < isIn.size(); ++p)
        if (isIn[p] != 0) all.push_back(toLabel(p));
    return all;
}

void divideZones(const PolyMesh& mesh,
                 const SubdivisionPlan& plan,
                 const std::vector<Label>& children,
                 PolyMesh& result) {
    for (const Zone& zone : mesh.pointZones)
        result.pointZones.push_back({zone.name, dividedPoints(mesh, plan, zone.labels), {}});
    for (const Zone& zone : mesh.faceZones)
        result.faceZones.push_back(dividedFaceZone(mesh, children, zone));
    for (const Zone& zone : mesh.cellZones)
        result.cellZones.push_back({zone.name, dividedCells(plan, zone.labels), {}});
}

} // namespace polymesh
