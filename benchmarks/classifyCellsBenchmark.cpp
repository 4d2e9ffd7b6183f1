// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Classification of cells by their STAR-CD shapes, cells a second with all cores: a box of
// hexahedra, and one cell of each shape of the catalogue again and again.

#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/shapes/classify.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <vector>

namespace {

using polymesh::Label;

void classify(benchmark::State& state, const polymesh::PolyMesh& mesh) {
    const polymesh::Rows<Label> faces = polymesh::cellFaces(mesh);
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(polymesh::classifyCells(mesh, faces));
    state.SetItemsProcessed(state.iterations() * mesh.cellCount);
}

void hexahedra(benchmark::State& state) {
    const auto n = static_cast<Label>(state.range(0));
    classify(state, polymesh::cartesianMesh({{{0, 0, 0}, {1, 1, 1}}, {n, n, n}}));
}

/// Cells that share nothing, of all shapes in turn. Their points are in no place, which matters to
/// sammTrim1 and sammTrim3 alone.
polymesh::PolyMesh allShapes(Label cells) {
    polymesh::PolyMesh mesh;
    const auto& shapes = polymesh::Catalogue::instance().shapes();
    for (; mesh.cellCount < cells; ++mesh.cellCount) {
        const auto& shape = shapes[polymesh::index(mesh.cellCount) % shapes.size()];
        std::vector<Label> points(polymesh::tableOf(shape.base).pointCount);
        for (std::size_t v = 0; v < points.size(); ++v)
            points[v] = mesh.pointCount() + polymesh::toLabel(v);
        mesh.points.resize(mesh.points.size() + points.size());
        for (const auto& [a, b] : shape.collapsed)
            std::ranges::replace(points, points[b], Label{points[a]});
        const auto faces = polymesh::collapsedFaces(shape.base, points);
        for (Label f = 0; f < faces.size(); ++f) {
            mesh.faces.add(faces[f]);
            mesh.owner.push_back(mesh.cellCount);
        }
    }
    return mesh;
}

void catalogue(benchmark::State& state) {
    classify(state, allShapes(static_cast<Label>(state.range(0))));
}

} // namespace

BENCHMARK(hexahedra)->Arg(20)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(catalogue)->Arg(10000)->Arg(1000000)->Unit(benchmark::kMillisecond)->UseRealTime();
