// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapes/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>

namespace polymesh {

namespace {

/// The edges of a base shape, ascending.
std::vector<ShapeEdge> edgesOf(const BaseShapeTable& table) {
    std::vector<ShapeEdge> edges;
    for (const ShapeFace face : table.faces)
        for (std::size_t i = 0; i < face.size(); ++i) {
            const ShapeVertex a = face[i];
            const ShapeVertex b = face[(i + 1) % face.size()];
            if (a < b) edges.push_back({a, b}); // each edge runs this way in one of its faces
        }
    std::ranges::sort(edges);
    return edges;
}

/// Which point each vertex becomes when edges collapse: the lowest vertex that it is joined to.
std::vector<Label> collapsedPoints(std::size_t pointCount, std::span<const ShapeEdge> collapsed) {
    std::vector<Label> points(pointCount);
    std::iota(points.begin(), points.end(), Label{0});
    for (const ShapeEdge& edge : collapsed) {
        const auto [low, high] = std::minmax({points[edge[0]], points[edge[1]]});
        std::ranges::replace(points, high, low);
    }
    return points;
}

/// The face graph of a base shape with these points; none when that is no acceptable shape.
std::optional<FaceGraph> graphOf(BaseShape base, std::span<const Label> points) {
    const Rows<Label> faces = collapsedFaces(base, points);
    if (toLabel(tableOf(base).faces.size()) != faces.size()) return std::nullopt;
    FaceGraph graph;
    for (Label f = 0; f < faces.size(); ++f) {
        std::vector<Label> sorted(faces[f].begin(), faces[f].end());
        std::ranges::sort(sorted);
        if (std::ranges::adjacent_find(sorted) != sorted.end()) return std::nullopt;
        if (!graph.addFace(faces[f], false)) return std::nullopt;
    }
    if (!graph.close() || !graph.walk(0).complete) return std::nullopt;
    return graph;
}

/// The face graph of the mirror image of that shape.
FaceGraph mirrored(BaseShape base, std::span<const Label> points) {
    const Rows<Label> faces = collapsedFaces(base, points);
    FaceGraph graph;
    for (Label f = 0; f < faces.size(); ++f)
        graph.addFace(faces[f], true);
    graph.close();
    return graph;
}

/// Calls visit(edges) for every set of edges of the base shape of which no face has more than it
/// can lose; fewer edges first.
void forEdgeSets(const BaseShapeTable& table,
                 const std::function<void(const std::vector<ShapeEdge>&)>& visit) {
    const std::vector<ShapeEdge> edges = edgesOf(table);
    const auto losesTooMuch = [&](const std::vector<ShapeEdge>& set) {
        return std::ranges::any_of(table.faces, [&](const ShapeFace face) {
            const auto inFace = std::ranges::count_if(set, [&](const ShapeEdge& edge) {
                return std::ranges::count(face, edge[0]) && std::ranges::count(face, edge[1]);
            });
            return static_cast<std::size_t>(inFace) + 3 > face.size();
        });
    };
    std::vector<std::vector<ShapeEdge>> sets{{}};
    while (!sets.empty()) {
        std::vector<std::vector<ShapeEdge>> larger;
        for (std::vector<ShapeEdge>& set : sets) {
            visit(set);
            for (const ShapeEdge& edge : edges) {
                if (!set.empty() && edge <= set.back()) continue;
                set.push_back(edge);
                if (!losesTooMuch(set)) larger.push_back(set);
                set.pop_back();
            }
        }
        sets = std::move(larger);
    }
}

std::string nameOf(BaseShape base, const std::vector<ShapeEdge>& collapsed) {
    std::string name(tableOf(base).name);
    for (std::size_t i = 0; i < collapsed.size(); ++i)
        name += fmt::format("{}{}-{}", i == 0 ? ':' : ',', collapsed[i][0], collapsed[i][1]);
    return name;
}

} // namespace

const Catalogue& Catalogue::instance() {
    static const Catalogue catalogue;
    return catalogue;
}

Catalogue::Catalogue() {
    for (const BaseShape base : allBaseShapes())
        addBase(base);
}

void Catalogue::addBase(BaseShape base) {
    forEdgeSets(tableOf(base), [&](const std::vector<ShapeEdge>& set) { addVariant(base, set); });
}

void Catalogue::addVariant(BaseShape base, const std::vector<ShapeEdge>& collapsed) {
    const std::vector<Label> points = collapsedPoints(tableOf(base).pointCount, collapsed);
    const std::optional<FaceGraph> graph = graphOf(base, points);
    if (!graph) return;
    const View* known = find(graph->walk(0).code);
    ShapeId shape = 0;
    if (known) {
        shape = known->shape;
    } else {
        const View* mirror = find(mirrored(base, points).walk(0).code);
        shape = mirror ? mirror->shape : addShape(base, collapsed, *graph);
        addViews(*graph, points, base, shape);
    }
    std::vector<BaseShape>& bases = shapes_[shape].bases;
    if (std::ranges::find(bases, base) == bases.end()) bases.push_back(base);
}

ShapeId Catalogue::addShape(BaseShape base,
                            const std::vector<ShapeEdge>& collapsed,
                            const FaceGraph& graph) {
    CatalogueShape shape{base, collapsed, {}, nameOf(base, collapsed), graph.pointCount(), {}};
    const Rows<Label> faces =
        collapsedFaces(base, collapsedPoints(tableOf(base).pointCount, collapsed));
    for (Label f = 0; f < faces.size(); ++f)
        shape.faceSizes.push_back(faces[f].size());
    std::ranges::sort(shape.faceSizes);
    shapes_.push_back(std::move(shape));
    return static_cast<ShapeId>(shapes_.size() - 1);
}

void Catalogue::addViews(const FaceGraph& graph,
                         std::span<const Label> pointOfVertex,
                         BaseShape base,
                         ShapeId shape) {
    for (std::size_t dart = 0; dart < graph.dartCount(); ++dart) {
        const FaceGraph::Walk walk = graph.walk(dart);
        if (find(walk.code)) continue; // a symmetry of the shape
        View view{walk.code, {}, shape, base};
        for (std::size_t vertex = 0; vertex < pointOfVertex.size(); ++vertex)
            for (std::size_t met = 0; met < graph.pointCount(); ++met)
                if (graph.label(walk.points[met]) == pointOfVertex[vertex])
                    view.met[vertex] = static_cast<std::uint8_t>(met);
        enter(view);
    }
}

std::size_t Catalogue::variantCount(BaseShape base) const {
    return static_cast<std::size_t>(std::ranges::count_if(shapes_, [&](const auto& shape) {
        return std::ranges::find(shape.bases, base) != shape.bases.end();
    }));
}

std::size_t Catalogue::slotOf(const RootedCode& code) {
    std::uint64_t hash = code.words[0] * 0x9e3779b97f4a7c15U;
    hash = (hash ^ (hash >> 29U) ^ code.words[1]) * 0xbf58476d1ce4e5b9U;
    hash = (hash ^ (hash >> 32U) ^ code.words[2]) * 0x94d049bb133111ebU;
    return static_cast<std::size_t>(hash >> 40U) % tableSize;
}

void Catalogue::enter(const View& view) {
    std::size_t slot = slotOf(view.code);
    while (table_[slot] != 0)
        slot = (slot + 1) % tableSize;
    views_.push_back(view);
    table_[slot] = static_cast<std::uint16_t>(views_.size());
}

const Catalogue::View* Catalogue::find(const RootedCode& code) const {
    for (std::size_t slot = slotOf(code); table_[slot] != 0; slot = (slot + 1) % tableSize) {
        const View& view = views_[table_[slot] - std::size_t{1}];
        if (view.code == code) return &view;
    }
    return nullptr;
}

} // namespace polymesh
