// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/boundaryFile.h"
#include "formats/foam/listReader.h"
#include "formats/foam/polyMeshIo.h"
#include "formats/foam/replaceDirectory.h"
#include "formats/foam/runAll.h"
#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

namespace polymesh::foam {
namespace {

namespace fs = std::filesystem;

/// The number of faces that the faces file announces, to bound lists of equal labels.
Label announcedFaceCount(const fs::path& path) {
    FoamReader reader(path);
    if (reader.peek() == '(') return 1; // no count: then no list of equal labels either
    const std::int64_t count = reader.integer("list length");
    const auto bytes =
        std::min<std::uint64_t>(reader.file().mostBytesLeft(), std::numeric_limits<Label>::max());
    return static_cast<Label>(std::clamp<std::int64_t>(count, 0, static_cast<Label>(bytes)));
}

void checkFacePoints(const PolyMesh& mesh, const fs::path& path) {
    const std::vector<Label>& labels = mesh.faces.values;
    const Label pointCount = mesh.pointCount();
    const auto isBad = [&](Label i) {
        const Label label = labels[index(i)];
        return label < 0 || label >= pointCount;
    };
    const Label bad = parallelSum(
        toLabel(labels.size()), Label{0}, [&](Label i) { return isBad(i) ? Label{1} : Label{0}; });
    if (bad == 0) return;
    Label at = 0;
    while (!isBad(at))
        ++at;
    const auto row = std::ranges::upper_bound(mesh.faces.offsets, at);
    throw InputError(fmt::format("{}: face {} uses point {}; the mesh has points 0 to {}",
                                 path.string(),
                                 row - mesh.faces.offsets.begin() - 1,
                                 labels[index(at)],
                                 pointCount - 1));
}

/// Checks that `cells` holds labels from 0 up and returns the largest, -1 when there is none.
/// A mesh of f faces has fewer than 2 f cells.
Label checkedLargestCell(const std::vector<Label>& cells, Label mostCells, const fs::path& path) {
    const auto isWrong = [&](Label cell) { return cell < 0 || cell >= mostCells; };
    // Any label that is wrong comes out as the largest.
    const Label largest = parallelReduce(
        toLabel(cells.size()),
        Label{-1},
        [&](Label f) { return isWrong(cells[index(f)]) ? mostCells : cells[index(f)]; },
        [](Label a, Label b) { return std::max(a, b); });
    if (largest < mostCells) return largest;
    const auto wrong = std::ranges::find_if(cells, isWrong);
    throw InputError(
        fmt::format("{}: face {} has cell {}; expected 0 to {} in a mesh of so few faces",
                    path.string(),
                    wrong - cells.begin(),
                    *wrong,
                    mostCells - 1));
}

/// Old meshes fill neighbour with -1 for boundary faces; drops these.
void dropPadding(std::vector<Label>& neighbour, Label faceCount) {
    if (toLabel(neighbour.size()) != faceCount) return;
    while (!neighbour.empty() && neighbour.back() == -1)
        neighbour.pop_back();
}

void checkCells(PolyMesh& mesh, const fs::path& directory) {
    const fs::path ownerPath = directory / "owner";
    const fs::path neighbourPath = directory / "neighbour";
    const Label faceCount = mesh.faceCount();
    require(toLabel(mesh.owner.size()) == faceCount,
            "{}: {} labels, expected {}, one a face",
            ownerPath.string(),
            mesh.owner.size(),
            faceCount);
    dropPadding(mesh.neighbour, faceCount);
    require(toLabel(mesh.neighbour.size()) <= faceCount,
            "{}: {} labels, expected at most {}, the number of faces",
            neighbourPath.string(),
            mesh.neighbour.size(),
            faceCount);
    const auto sides = mesh.owner.size() + mesh.neighbour.size();
    const Label most = toLabel(std::min<std::size_t>(sides, std::numeric_limits<Label>::max()));
    const Label largest = std::max(checkedLargestCell(mesh.owner, most, ownerPath),
                                   checkedLargestCell(mesh.neighbour, most, neighbourPath));
    mesh.cellCount = largest + 1;
}

void checkPatches(PolyMesh& mesh, const fs::path& path) {
    Label next = mesh.internalFaceCount();
    for (Patch& patch : mesh.patches) {
        if (patch.size == 0) patch.start = next; // an empty patch may say anything
        require(patch.start == next && patch.size <= mesh.faceCount() - next,
                "{}: patch {} has faces {} to {}; expected to start at {} and to end before {}",
                path.string(),
                patch.name,
                patch.start,
                std::int64_t{patch.start} + patch.size - 1,
                next,
                mesh.faceCount());
        next += patch.size;
    }
    require(next == mesh.faceCount(),
            "{}: faces {} to {} belong to no patch",
            path.string(),
            next,
            mesh.faceCount() - 1);
}

bool hasFile(const fs::path& path) {
    fs::path compressed = path;
    compressed += ".gz";
    return fs::exists(path) || fs::exists(compressed);
}

std::vector<Zone> readZoneFile(const fs::path& path, ZoneKind kind, Label elementCount) {
    if (!hasFile(path)) return {};
    FoamReader reader(path);
    return readZones(reader, kind, elementCount);
}

void readLists(PolyMesh& mesh, const fs::path& directory) {
    const Label faceCount = announcedFaceCount(directory / "faces");
    const auto readCellLabels = [&](const char* name) {
        FoamReader reader(directory / name);
        return readLabels(reader, faceCount);
    };
    const std::array<std::function<void()>, 4> tasks{
        [&] { // the longest first
            FoamReader reader(directory / "faces");
            mesh.faces = readFaces(reader);
        },
        [&] {
            FoamReader reader(directory / "points");
            mesh.points = readVectors(reader);
        },
        [&] { mesh.owner = readCellLabels("owner"); },
        [&] { mesh.neighbour = readCellLabels("neighbour"); },
    };
    runAll(tasks);
}

} // namespace

PolyMesh readPolyMesh(const fs::path& polyMeshDirectory) {
    recoverDirectory(polyMeshDirectory);
    require(fs::is_directory(polyMeshDirectory),
            "{}: no such directory; it should hold a mesh (points, faces, owner, ...)",
            polyMeshDirectory.string());
    PolyMesh mesh;
    readLists(mesh, polyMeshDirectory);
    checkFacePoints(mesh, polyMeshDirectory / "faces");
    checkCells(mesh, polyMeshDirectory);
    FoamReader boundary(polyMeshDirectory / "boundary");
    mesh.patches = readPatches(boundary);
    checkPatches(mesh, polyMeshDirectory / "boundary");
    mesh.pointZones =
        readZoneFile(polyMeshDirectory / "pointZones", ZoneKind::point, mesh.pointCount());
    mesh.faceZones =
        readZoneFile(polyMeshDirectory / "faceZones", ZoneKind::face, mesh.faceCount());
    mesh.cellZones = readZoneFile(polyMeshDirectory / "cellZones", ZoneKind::cell, mesh.cellCount);
    return mesh;
}

} // namespace polymesh::foam
