// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// STAR-CD text read into a mesh and written from it, on one thread: bytes of all files a second.
// The argument is the number of cells along each side of a box.

#include "formats/star/starFiles.h"
#include "libpolymesh/base/threadLimit.h"
#include "libpolymesh/initial/cartesian.h"

#include <benchmark/benchmark.h>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using polymesh::Label;
using polymesh::PolyMesh;
using polymesh::star::Version;

PolyMesh boxOf(Label n) {
    return polymesh::cartesianMesh({{{0, 0, 0}, {1. / 3, 1. / 7, 1. / 9}}, {n, n, n}});
}

/// The same with every fourth face cut into two triangles, so that most cells are polyhedra.
PolyMesh polyhedraOf(Label n) {
    PolyMesh mesh = boxOf(n);
    polymesh::Rows<Label> faces;
    std::vector<Label> owner;
    std::vector<Label> neighbour;
    std::vector<Label> newStart;
    for (Label f = 0; f < mesh.faceCount(); ++f) {
        newStart.push_back(faces.size());
        const auto q = mesh.faces[f];
        const bool isCut = f % 4 == 0;
        if (isCut) {
            faces.add(std::array{q[0], q[1], q[2]});
            faces.add(std::array{q[0], q[2], q[3]});
        } else {
            faces.add(q);
        }
        for (int i = 0; i < (isCut ? 2 : 1); ++i) {
            owner.push_back(mesh.owner[polymesh::index(f)]);
            if (mesh.isInternal(f)) neighbour.push_back(mesh.neighbour[polymesh::index(f)]);
        }
    }
    newStart.push_back(faces.size());
    for (polymesh::Patch& patch : mesh.patches) {
        const Label end = newStart[polymesh::index(patch.start + patch.size)];
        patch.start = newStart[polymesh::index(patch.start)];
        patch.size = end - patch.start;
    }
    mesh.faces = std::move(faces);
    mesh.owner = std::move(owner);
    mesh.neighbour = std::move(neighbour);
    return mesh;
}

/// Files of a set that go with the object.
class Files {
public:
    Files() : prefix_(fs::temp_directory_path() / ("starBenchmark" + std::to_string(getpid()))) {}

    ~Files() {
        for (const char* ending : endings)
            fs::remove(prefix_.string() + ending);
    }

    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;

    const fs::path& prefix() const { return prefix_; }

    std::int64_t bytes() const {
        std::uintmax_t sum = 0;
        for (const char* ending : endings)
            sum += fs::file_size(prefix_.string() + ending);
        return static_cast<std::int64_t>(sum);
    }

private:
    static constexpr std::array<const char*, 4> endings{".vrt", ".cel", ".bnd", ".inp"};
    fs::path prefix_;
};

void readFiles(benchmark::State& state, const PolyMesh& mesh, Version version) {
    const polymesh::ThreadLimit one(1);
    const Files files;
    polymesh::star::write(mesh, files.prefix(), version, 1000);
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(polymesh::star::read(files.prefix(), version, 0.001));
    state.SetBytesProcessed(state.iterations() * files.bytes());
}

void writeFiles(benchmark::State& state, const PolyMesh& mesh, Version version) {
    const polymesh::ThreadLimit one(1);
    const Files files;
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(polymesh::star::write(mesh, files.prefix(), version, 1000));
    state.SetBytesProcessed(state.iterations() * files.bytes());
}

void read4(benchmark::State& state) {
    readFiles(state, boxOf(static_cast<Label>(state.range(0))), Version::v4);
}

void write4(benchmark::State& state) {
    writeFiles(state, boxOf(static_cast<Label>(state.range(0))), Version::v4);
}

void readPolyhedra4(benchmark::State& state) {
    readFiles(state, polyhedraOf(static_cast<Label>(state.range(0))), Version::v4);
}

void writePolyhedra4(benchmark::State& state) {
    writeFiles(state, polyhedraOf(static_cast<Label>(state.range(0))), Version::v4);
}

void read3(benchmark::State& state) {
    readFiles(state, boxOf(static_cast<Label>(state.range(0))), Version::v3);
}

void write3(benchmark::State& state) {
    writeFiles(state, boxOf(static_cast<Label>(state.range(0))), Version::v3);
}

} // namespace

BENCHMARK(read4)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(write4)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(readPolyhedra4)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(writePolyhedra4)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(read3)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(write3)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
