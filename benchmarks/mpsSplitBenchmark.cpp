// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Mid-point subdivision of boxes of hexahedra: cells of the result a second, with all cores.

#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/mps/makeDivisible.h"
#include "libpolymesh/mps/relaxPoints.h"

#include <benchmark/benchmark.h>
#include <utility>

namespace {

void divideBox(benchmark::State& state) {
    const auto n = static_cast<polymesh::Label>(state.range(0));
    const polymesh::PolyMesh box = polymesh::cartesianMesh({{{0, 0, 0}, {1, 1, 1}}, {n, n, n}});
    std::int64_t cells = 0;
    for ([[maybe_unused]] auto _ : state) {
        polymesh::Divisible work = polymesh::makeDivisible(box);
        const std::vector<char> isGood = polymesh::partsOfBoxes(work.mesh, work.plan);
        polymesh::PolyMesh result = polymesh::divide(work.mesh, std::move(work.plan));
        polymesh::relaxPoints(result, work.mesh.pointCount(), isGood);
        cells += result.cellCount;
    }
    state.SetItemsProcessed(cells);
}

} // namespace

BENCHMARK(divideBox)->Arg(20)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
