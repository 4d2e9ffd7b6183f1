// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/numberedEdges.h"

#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <numeric>

namespace polymesh {

namespace {

/// One use of an edge by a face, kept with the edge's lower point.
struct EdgeUse {
    Label high;
    Label corner;
};

/// Calls use(point, next point, corner) for every corner of every face.
template<class Use>
void forEachCorner(const Rows<Label>& faces, Use&& use) {
    for (Label face = 0; face < faces.size(); ++face) {
        const Label first = faces.offsets[index(face)];
        const Label last = faces.offsets[index(face) + 1];
        for (Label i = first; i < last; ++i)
            use(faces.values[index(i)], faces.values[index(i + 1 < last ? i + 1 : first)], i);
    }
}

Rows<EdgeUse> edgeUses(const PolyMesh& mesh) {
    Rows<EdgeUse> uses;
    uses.offsets.assign(index(mesh.pointCount()) + 1, 0);
    forEachCorner(mesh.faces,
                  [&](Label a, Label b, Label) { ++uses.offsets[index(std::min(a, b)) + 1]; });
    std::partial_sum(uses.offsets.begin(), uses.offsets.end(), uses.offsets.begin());
    uses.values.resize(mesh.faces.values.size());
    std::vector<Label> next(uses.offsets.begin(), uses.offsets.end() - 1);
    forEachCorner(mesh.faces, [&](Label a, Label b, Label corner) {
        uses.values[index(next[index(std::min(a, b))]++)] = {std::max(a, b), corner};
    });
    return uses;
}

} // namespace

NumberedEdges numberEdges(const PolyMesh& mesh) {
    Rows<EdgeUse> uses = edgeUses(mesh);
    std::vector<Label> firstEdge(index(uses.size()) + 1, 0);
    parallelFor(uses.size(), [&](Label point) {
        const std::span<EdgeUse> here = uses[point];
        std::ranges::sort(here, {}, &EdgeUse::high);
        Label count = 0;
        for (std::size_t i = 0; i < here.size(); ++i)
            count += i == 0 || here[i].high != here[i - 1].high ? 1 : 0;
        firstEdge[index(point) + 1] = count;
    });
    std::partial_sum(firstEdge.begin(), firstEdge.end(), firstEdge.begin());
    NumberedEdges edges;
    edges.points.resize(index(firstEdge.back()));
    edges.ofCorner.resize(mesh.faces.values.size());
    parallelFor(uses.size(), [&](Label point) {
        Label edge = firstEdge[index(point)] - 1;
        Label high = -1;
        for (const EdgeUse& use : uses[point]) {
            if (use.high != high) edges.points[index(++edge)] = {point, use.high};
            high = use.high;
            edges.ofCorner[index(use.corner)] = edge;
        }
    });
    return edges;
}

} // namespace polymesh
