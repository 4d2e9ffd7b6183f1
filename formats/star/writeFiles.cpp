// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/cellWriter.h"
#include "formats/star/faceView.h"
#include "formats/star/fileSet.h"
#include "formats/star/names.h"
#include "formats/star/regionTypes.h"
#include "formats/star/starFiles.h"
#include "formats/star/vertices.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/topology.h"

#include <algorithm>
#include <numeric>

namespace polymesh::star {

namespace {

namespace fs = std::filesystem;

constexpr const char* vertexHeader = "PROSTAR_VERTEX\n4000 0 0 0 0 0 0 0\n";
constexpr const char* fluid = "fluid";

/// The cell table that cell zones make, and what does not fit into it.
struct CellTable {
    std::vector<Label> ofCell;
    std::map<Label, Names::Table> entries;
    std::vector<std::string> notes;
};

CellTable cellTableOf(const PolyMesh& mesh) {
    CellTable table;
    table.ofCell.assign(index(mesh.cellCount), 0);
    Label next = 1;
    for (const Zone& zone : mesh.cellZones) {
        std::size_t taken = 0;
        for (const Label cell : zone.labels) {
            if (table.ofCell[index(cell)] != 0)
                ++taken;
            else
                table.ofCell[index(cell)] = next;
        }
        if (taken > 0)
            table.notes.push_back(fmt::format("cell zone {}: {} of its {} cells are in an earlier "
                                              "zone and stay there: STAR-CD has one cell table "
                                              "entry for a cell",
                                              zone.name,
                                              taken,
                                              zone.labels.size()));
        else if (zone.labels.empty())
            table.notes.push_back(fmt::format("cell zone {} has no cells: left out", zone.name));
        if (taken < zone.labels.size()) table.entries[next++] = {zone.name, fluid};
    }
    const bool hasRest = std::ranges::count(table.ofCell, 0) > 0;
    std::ranges::replace(table.ofCell, 0, next);
    if (hasRest) table.entries[next] = {next == 1 ? "" : std::string(unzonedCells), fluid};
    return table;
}

/// The first of each two boundary faces that have the same points; of those with more than
/// `mostVertices`, which no baffle can have, only a note.
std::vector<Label>
coincidentFaces(const PolyMesh& mesh, Label mostVertices, std::vector<std::string>& notes) {
    std::vector<FaceView> views;
    views.reserve(index(mesh.faceCount() - mesh.internalFaceCount()));
    for (Label f = mesh.internalFaceCount(); f < mesh.faceCount(); ++f)
        views.emplace_back(mesh.faces[f], f);
    std::sort(views.begin(), views.end());
    std::vector<Label> found;
    Label tooLarge = 0;
    for (std::size_t i = 1; i < views.size(); ++i) {
        if (!views[i].isSame(views[i - 1])) continue;
        if (mesh.faces.rowSize(views[i].face()) > mostVertices)
            ++tooLarge;
        else
            found.push_back(views[i - 1].face());
    }
    if (tooLarge > 0)
        notes.push_back(fmt::format("{} pairs of boundary faces with the same points become faces "
                                    "between cells: baffles of version 3 have 4 vertices at most",
                                    tooLarge));
    std::ranges::sort(found);
    return found;
}

Names::Region regionOf(const Patch& patch, const std::string& starType) {
    const Patch told = patchOfType(starType); // what a reader makes of the type alone
    Names::Region region{patch.name, starType, {}, {}};
    if (told.type != patch.type) region.foamType = patch.type;
    if (told.entries != patch.entries) region.entries = patch.entries;
    return region;
}

void addZoneNotes(const std::vector<Zone>& zones,
                  std::string_view kind,
                  std::vector<std::string>& notes) {
    for (const Zone& zone : zones)
        notes.push_back(fmt::format("{} zone {} ({} {}s) is left out: STAR-CD files have no such "
                                    "zones",
                                    kind,
                                    zone.name,
                                    zone.labels.size(),
                                    kind));
}

void writeVertices(foam::OutputFile& file, const PolyMesh& mesh, Version version, double scale) {
    if (version == Version::v4) file.write(vertexHeader);
    writeElements(file, mesh.pointCount(), [&](std::string& text, Label p) {
        appendVertex(text, version, p + 1, scale * mesh.points[index(p)]);
    });
}

void removeOldCouples(const fs::path& path, std::vector<std::string>& notes) {
    std::error_code ignored;
    if (fs::remove(path, ignored))
        notes.push_back(fmt::format("{} belonged to other files and is removed", path.string()));
}

} // namespace

PatchOfFace::PatchOfFace(const PolyMesh& mesh) {
    for (const Patch& patch : mesh.patches)
        ends_.push_back(patch.start + patch.size);
}

Label PatchOfFace::operator()(Label face) const {
    return toLabel(static_cast<std::size_t>(std::ranges::upper_bound(ends_, face) - ends_.begin()));
}

std::vector<std::string>
write(const PolyMesh& mesh, const fs::path& prefix, Version version, double scale) {
    const bool isVersion4 = version == Version::v4;
    CellTable table = cellTableOf(mesh);
    std::vector<std::string> notes = std::move(table.notes);
    MeshToWrite toWrite{mesh, cellFaces(mesh), std::move(table.ofCell), {}, {}, 0};
    toWrite.baffles =
        coincidentFaces(mesh, isVersion4 ? mesh.pointCount() : mostBaffleVertices, notes);
    Names names{std::move(table.entries), {}};
    toWrite.baffleTable = names.tables.empty() ? 1 : names.tables.rbegin()->first + 1;
    if (!toWrite.baffles.empty()) names.tables[toWrite.baffleTable] = {"baffles", "baffle"};
    for (const Patch& patch : mesh.patches) {
        toWrite.starTypes.push_back(starTypeOf(patch));
        names.regions[toLabel(toWrite.starTypes.size())] =
            regionOf(patch, toWrite.starTypes.back());
    }
    FileSet files(prefix);
    files.write(".cel", [&](foam::OutputFile& file) {
        isVersion4 ? writeCells4(file, toWrite) : writeCells3(file, toWrite);
    });
    files.write(".bnd", [&](foam::OutputFile& file) {
        isVersion4 ? writeBoundary4(file, toWrite) : writeBoundary3(file, toWrite);
    });
    files.write(".vrt", [&](foam::OutputFile& file) { writeVertices(file, mesh, version, scale); });
    files.write(".inp", [&](foam::OutputFile& file) {
        file.write(writeNames(names, prefix.filename().string()));
    });
    files.commit();
    addZoneNotes(mesh.faceZones, "face", notes);
    addZoneNotes(mesh.pointZones, "point", notes);
    removeOldCouples(files.finalPath(".cpl"), notes);
    return notes;
}

} // namespace polymesh::star
