// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/starFiles.h"

#include "formats/fileBytes.h"
#include "formats/star/couples.h"
#include "formats/star/patches.h"
#include "formats/textScanner.h"
#include "libpolymesh/base/error.h"

#include <algorithm>
#include <array>
#include <fstream>

namespace polymesh::star {

namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 5> endings{".vrt", ".cel", ".bnd", ".inp", ".cpl"};

fs::path withEnding(const fs::path& prefix, const char* ending) {
    fs::path path = prefix;
    path += ending;
    return path;
}

BoundaryRecords readBoundary(const fs::path& path, const CellMesh& mesh, Version version) {
    if (!fs::exists(path)) return {};
    const TextFile file(path);
    return version == Version::v4 ? readBoundary4(file, mesh) : readBoundary3(file, mesh);
}

Names readNamesOf(const fs::path& path) {
    return fs::exists(path) ? readNames(readBytes(path)) : Names{};
}

void addCellNotes(const CellRecords& cells, std::vector<std::string>& notes) {
    notes.insert(notes.end(), cells.notes.begin(), cells.notes.end());
    if (!cells.otherNumbers.empty())
        notes.push_back(fmt::format("{} shells, lines and points are left out: they bound no cell",
                                    cells.otherNumbers.size()));
    if (cells.solidCells > 0)
        notes.push_back(fmt::format("{} solid cells are cells like the fluid ones: the mesh has "
                                    "no place for their material, only for their zone",
                                    cells.solidCells));
    if (cells.baffles.size() > 0)
        notes.push_back(
            fmt::format("{} baffles became two boundary faces each", cells.baffles.size()));
}

void addPointNote(std::size_t pointsRead, const PolyMesh& mesh, std::vector<std::string>& notes) {
    if (pointsRead > mesh.points.size())
        notes.push_back(fmt::format("{} vertices that no cell uses are left out",
                                    pointsRead - mesh.points.size()));
}

} // namespace

std::optional<Version> versionOf(const fs::path& prefix) {
    for (const char* ending : {".cel", ".vrt"}) {
        std::ifstream file(withEnding(prefix, ending), std::ios::binary);
        std::array<char, 64> start{};
        file.read(start.data(), start.size());
        const auto size = static_cast<std::size_t>(file.gcount());
        if (size > 0) return hasHeader({start.data(), size}) ? Version::v4 : Version::v3;
    }
    return std::nullopt;
}

fs::path prefixOf(const fs::path& name) {
    const bool isFile = std::ranges::find(endings, name.extension()) != endings.end();
    return isFile ? fs::path(name).replace_extension() : name;
}

StarMesh read(const fs::path& prefix, Version version, double scale) {
    Vertices vertices = readVertices(TextFile(withEnding(prefix, ".vrt")), version, scale);
    const TextFile cellFile(withEnding(prefix, ".cel"));
    CellRecords cells =
        version == Version::v4 ? readCells4(cellFile, vertices) : readCells3(cellFile, vertices);
    require(cells.count() > 0, "{}: no cells", cellFile.name);
    if (const auto repeated = NumberMap(cells.numbers).repeated())
        cellFile.fail(cells.places[index(*repeated)],
                      fmt::format("cell {} is there already", cells.numbers[index(*repeated)]));
    const fs::path couples = withEnding(prefix, ".cpl");
    if (version == Version::v3 && fs::exists(couples)) joinCouples(TextFile(couples), cells);
    FacePairs pairs = pairFaces(cellFile, vertices.points, cells);
    const BaffleSides baffles = openBaffles(cellFile, cells, pairs);
    const CellMesh cellMesh{vertices, cells, pairs, baffles};
    const BoundaryRecords boundary = readBoundary(withEnding(prefix, ".bnd"), cellMesh, version);
    const Names names = readNamesOf(withEnding(prefix, ".inp"));
    PatchFaces patches = patchesOf(cellMesh, boundary, names, version);
    StarMesh result;
    addCellNotes(cells, result.notes);
    result.notes.insert(result.notes.end(), boundary.notes.begin(), boundary.notes.end());
    const std::size_t pointsRead = vertices.points.size();
    result.mesh = assemble(std::move(vertices.points), cells, pairs, std::move(patches));
    result.mesh.cellZones = zonesOf(cells, names);
    addPointNote(pointsRead, result.mesh, result.notes);
    return result;
}

} // namespace polymesh::star
