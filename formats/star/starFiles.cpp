// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/starFiles.h"

#include "formats/star/couples.h"
#include "formats/star/fileTexts.h"
#include "formats/star/patches.h"
#include "formats/textScanner.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/validate.h"

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

std::optional<TextFile> readIfThere(const fs::path& path) {
    return fs::exists(path) ? std::optional<TextFile>(path) : std::nullopt;
}

FileTexts readSet(const fs::path& prefix, Version version) {
    return {TextFile(withEnding(prefix, ".vrt")),
            TextFile(withEnding(prefix, ".cel")),
            readIfThere(withEnding(prefix, ".bnd")),
            readIfThere(withEnding(prefix, ".inp")),
            version == Version::v3 ? readIfThere(withEnding(prefix, ".cpl")) : std::nullopt};
}

CellRecords readCells(const FileTexts& texts, const Vertices& vertices, Version version) {
    const TextFile& file = texts.cells;
    CellRecords cells =
        version == Version::v4 ? readCells4(file, vertices) : readCells3(file, vertices);
    require(cells.count() > 0, "{}: no cells", file.name);
    if (const auto repeated = NumberMap(cells.numbers).repeated())
        file.fail(cells.places[index(*repeated)],
                  fmt::format("cell {} is there already", cells.numbers[index(*repeated)]));
    if (texts.couples) joinCouples(*texts.couples, cells);
    return cells;
}

BoundaryRecords readBoundary(const FileTexts& texts, const CellMesh& mesh, Version version) {
    if (!texts.boundary) return {};
    return version == Version::v4 ? readBoundary4(*texts.boundary, mesh)
                                  : readBoundary3(*texts.boundary, mesh);
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
    if (!cells.baffles.empty())
        notes.push_back(
            fmt::format("{} baffles became two boundary faces each", cells.baffles.size()));
}

void addPointNote(std::size_t pointsRead, const PolyMesh& mesh, std::vector<std::string>& notes) {
    if (pointsRead > mesh.points.size())
        notes.push_back(fmt::format("{} vertices that no cell uses are left out",
                                    pointsRead - mesh.points.size()));
}

/// Cells may be inside out, as the caller likes; all else that is left makes no mesh.
void requireMesh(const PolyMesh& mesh, const std::string& file) {
    for (const Defect& defect : validate(mesh)) {
        const bool isInsideOut = defect.law == 1 && defect.message.starts_with("cell");
        require(isInsideOut,
                "{}: the cells do not fit together: {} (numbers from 0 on); have pro-STAR check "
                "the cells",
                file,
                defect.message);
    }
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

StarMesh read(FileTexts texts, Version version, double scale) {
    Vertices vertices = readVertices(texts.vertices, version, scale);
    texts.vertices.bytes = {}; // no place in them is asked for any more
    CellRecords cells = readCells(texts, vertices, version);
    FacePairs pairs = pairFaces(texts.cells, vertices.points, cells);
    const BaffleSides baffles = openBaffles(texts.cells, cells, pairs);
    const CellMesh cellMesh{vertices, cells, pairs, baffles};
    const BoundaryRecords boundary = readBoundary(texts, cellMesh, version);
    const Names names = texts.names ? readNames(texts.names->bytes) : Names{};
    PatchFaces patches = patchesOf(cellMesh, boundary, names, version);
    StarMesh result;
    addCellNotes(cells, result.notes);
    result.notes.insert(result.notes.end(), boundary.notes.begin(), boundary.notes.end());
    const std::size_t pointsRead = vertices.points.size();
    result.mesh = assemble(std::move(vertices.points), cells, pairs, std::move(patches));
    result.mesh.cellZones = zonesOf(cells, names);
    requireMesh(result.mesh, texts.cells.name);
    addPointNote(pointsRead, result.mesh, result.notes);
    return result;
}

StarMesh read(const fs::path& prefix, Version version, double scale) {
    return read(readSet(prefix, version), version, scale);
}

} // namespace polymesh::star
