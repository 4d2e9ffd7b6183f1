// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapes/recognise.h"

namespace polymesh {

std::optional<FaceGraph>
faceGraphOf(const PolyMesh& mesh, std::span<const Label> cellFaces, Label cell) {
    std::optional<FaceGraph> graph(std::in_place);
    for (const Label f : cellFaces)
        if (!graph->addFace(mesh.faces[f], mesh.owner[index(f)] != cell)) return std::nullopt;
    if (!graph->close()) return std::nullopt;
    return graph;
}

std::optional<Recognition> recognise(const FaceGraph& graph) {
    if (graph.dartCount() == 0) return std::nullopt;
    const FaceGraph::Walk walk = graph.walk(0);
    if (!walk.complete) return std::nullopt;
    const Catalogue::View* view = Catalogue::instance().find(walk.code);
    if (!view) return std::nullopt;
    Recognition found{view->shape, view->base, {}};
    for (std::size_t v = 0; v < tableOf(view->base).pointCount; ++v)
        found.points[v] = graph.label(walk.points[view->met[v]]);
    return found;
}

std::optional<Recognition>
recognise(const PolyMesh& mesh, std::span<const Label> cellFaces, Label cell) {
    const std::optional<FaceGraph> graph = faceGraphOf(mesh, cellFaces, cell);
    return graph ? recognise(*graph) : std::nullopt;
}

std::optional<Recognition> recognise(const Rows<Label>& outwardFaces) {
    FaceGraph graph;
    for (Label f = 0; f < outwardFaces.size(); ++f)
        if (!graph.addFace(outwardFaces[f], false)) return std::nullopt;
    return graph.close() ? recognise(graph) : std::nullopt;
}

} // namespace polymesh
