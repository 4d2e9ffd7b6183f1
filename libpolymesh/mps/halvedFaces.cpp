// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/halvedFaces.h"

#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <atomic>

namespace polymesh {

HalvedFaces::HalvedFaces(const PolyMesh& mesh,
                         const SubdivisionPlan& plan,
                         std::span<const Fate> fates)
    : mesh_(mesh), plan_(plan), isHalved_(index(plan.edges.size()), 0) {
    const auto isDivided = [&](Label cell) { return fates[index(cell)] == Fate::divided; };
    parallelFor(mesh.faceCount(), [&](Label f) {
        if (!isDivided(mesh.owner[index(f)]) &&
            !(mesh.isInternal(f) && isDivided(mesh.neighbour[index(f)])))
            return;
        for (Label i = mesh.faces.offsets[index(f)]; i < mesh.faces.offsets[index(f) + 1]; ++i)
            std::atomic_ref<std::uint8_t>(isHalved_[index(plan.edges.ofCorner[index(i)])])
                .store(1, std::memory_order_relaxed);
    });
}

bool HalvedFaces::hasHalvedEdge(Label cell) const {
    const Rows<Label>& rows = mesh_.faces;
    return std::ranges::any_of(plan_.cellFaces[cell], [&](Label f) {
        const auto edges = std::span(plan_.edges.ofCorner)
                               .subspan(index(rows.offsets[index(f)]), index(rows.rowSize(f)));
        return std::ranges::any_of(edges, [&](Label e) { return isHalved_[index(e)] != 0; });
    });
}

HalvedPieces HalvedFaces::piecesOf(Label face) const {
    const auto points = mesh_.faces[face];
    HalvedFace quadrilateral;
    for (std::size_t i = 0; i < 4; ++i) {
        const Label edge = plan_.edges.ofCorner[index(mesh_.faces.offsets[index(face)]) + i];
        quadrilateral.corners[i] = points[i];
        if (isHalved_[index(edge)] != 0) quadrilateral.middles[i] = plan_.layout.firstEdge + edge;
    }
    quadrilateral.centre = plan_.layout.firstFace + face;
    return polymesh::piecesOf(quadrilateral);
}

} // namespace polymesh
