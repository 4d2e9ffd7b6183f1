// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/polyMeshWriter.h"

#include "formats/foam/polyMeshIo.h"
#include "formats/foam/runAll.h"

#include <array>
#include <vector>

namespace polymesh::foam {
namespace {

namespace fs = std::filesystem;

/// The directory as seen from its case, such as constant/polyMesh or constant/fluid/polyMesh.
std::string locationInCase(const fs::path& directory) {
    const std::vector<fs::path> parts(directory.begin(), directory.end());
    std::size_t start = parts.size() > 1 ? parts.size() - 2 : 0;
    for (std::size_t i = parts.size(); i-- > 0;) {
        if (parts[i] != "constant") continue;
        start = i;
        break;
    }
    fs::path location;
    for (std::size_t i = start; i < parts.size(); ++i)
        location /= parts[i];
    return location.generic_string();
}

struct ZoneWords {
    const char* file;
    const char* type;
    const char* labels;
};

ZoneWords wordsOf(ZoneKind kind) {
    switch (kind) {
    case ZoneKind::point:
        return {"pointZones", "pointZone", "pointLabels"};
    case ZoneKind::face:
        return {"faceZones", "faceZone", "faceLabels"};
    case ZoneKind::cell:
        break;
    }
    return {"cellZones", "cellZone", "cellLabels"};
}

/// One entry of a dictionary; a nested dictionary has no semicolon, neither has a bare macro's key.
std::string entryLine(const std::string& key, const std::string& value) {
    if (value.starts_with('{')) return fmt::format("        {}\n        {}\n", key, value);
    if (value.empty()) return fmt::format("        {};\n", key);
    return fmt::format("        {:<15} {};\n", key, value);
}

std::string patchText(const Patch& patch) {
    std::string text = fmt::format("    {}\n    {{\n", patch.name);
    text += entryLine("type", patch.type);
    for (const auto& [key, value] : patch.entries)
        text += entryLine(key, value);
    text += entryLine("nFaces", std::to_string(patch.size));
    text += entryLine("startFace", std::to_string(patch.start));
    return text + "    }\n";
}

} // namespace

PolyMeshWriter::PolyMeshWriter(const fs::path& polyMeshDirectory,
                               const WriteFormat& format,
                               const MeshCounts& counts)
    : format_(format), counts_(counts), replacement_(polyMeshDirectory) {}

void PolyMeshWriter::writeFile(const HeaderText& header,
                               bool compress,
                               const WriteBody& writeBody) const {
    OutputFile file(
        replacement_.temporary() / header.object, replacement_.target() / header.object, compress);
    const bool alwaysText = header.className == "polyBoundaryMesh";
    writeHeader(file, header, alwaysText ? Format::ascii : format_.format);
    writeBody(file);
    file.close();
}

HeaderText PolyMeshWriter::header(std::string className, std::string object) const {
    return {std::move(className), std::move(object), locationInCase(replacement_.target()), ""};
}

void PolyMeshWriter::writeCellLabels(const char* object, const WriteBody& writeBody) const {
    HeaderText text = header("labelList", object);
    text.note = fmt::format("nPoints:{}  nCells:{}  nFaces:{}  nInternalFaces:{}",
                            counts_.points,
                            counts_.cells,
                            counts_.faces,
                            counts_.internalFaces);
    writeFile(text, format_.compress, writeBody);
}

void PolyMeshWriter::writePoints(const Fill<Vec3>& fill) const {
    writeFile(header("vectorField", "points"), format_.compress, [&](OutputFile& file) {
        writeVectors(file, format_, counts_.points, fill);
    });
}

void PolyMeshWriter::writePoints(std::span<const Vec3> points) const {
    writeFile(header("vectorField", "points"), format_.compress, [&](OutputFile& file) {
        writeVectors(file, format_, points);
    });
}

void PolyMeshWriter::writeFaces(const Rows<Label>& faces) const {
    const HeaderText text = header(faceListClass(format_.format), "faces");
    writeFile(text, format_.compress, [&](OutputFile& file) {
        foam::writeFaces(file, format_.format, faces);
    });
}

void PolyMeshWriter::writeQuads(const Fill<Quad>& fill) const {
    const HeaderText text = header(faceListClass(format_.format), "faces");
    writeFile(text, format_.compress, [&](OutputFile& file) {
        foam::writeQuads(file, format_.format, counts_.faces, fill);
    });
}

void PolyMeshWriter::writeOwner(const Fill<Label>& fill) const {
    writeCellLabels(
        "owner", [&](OutputFile& file) { writeLabels(file, format_.format, counts_.faces, fill); });
}

void PolyMeshWriter::writeOwner(std::span<const Label> owner) const {
    writeCellLabels("owner", [&](OutputFile& file) { writeLabels(file, format_.format, owner); });
}

void PolyMeshWriter::writeNeighbour(const Fill<Label>& fill) const {
    writeCellLabels("neighbour", [&](OutputFile& file) {
        writeLabels(file, format_.format, counts_.internalFaces, fill);
    });
}

void PolyMeshWriter::writeNeighbour(std::span<const Label> neighbour) const {
    writeCellLabels("neighbour",
                    [&](OutputFile& file) { writeLabels(file, format_.format, neighbour); });
}

void PolyMeshWriter::writePatches(std::span<const Patch> patches) const {
    constexpr bool compress = false; // OpenFOAM looks for the plain file
    writeFile(header("polyBoundaryMesh", "boundary"), compress, [&](OutputFile& file) {
        std::string text = fmt::format("{}\n(\n", patches.size());
        for (const Patch& patch : patches)
            text += patchText(patch);
        file.write(text + ")\n");
    });
}

void PolyMeshWriter::writeZones(ZoneKind kind, std::span<const Zone> zones) const {
    if (zones.empty()) return;
    const ZoneWords words = wordsOf(kind);
    const Format format = format_.format;
    writeFile(header("regIOobject", words.file), format_.compress, [&](OutputFile& file) {
        file.write(fmt::format("{}\n(\n", zones.size()));
        for (const Zone& zone : zones) {
            file.write(fmt::format("{}\n{{\n    type {};\n", zone.name, words.type));
            file.write(fmt::format("{:<15} List<label> ", words.labels));
            writeLabels(file, format, zone.labels);
            file.write(";\n");
            if (kind == ZoneKind::face) {
                file.write("flipMap         List<bool> ");
                writeFlags(file, format, zone.flip);
                file.write(";\n");
            }
            file.write("}\n");
        }
        file.write(")\n");
    });
}

void PolyMeshWriter::writeLabelList(const std::string& object,
                                    std::span<const Label> labels) const {
    writeFile(header("labelList", object), format_.compress, [&](OutputFile& file) {
        writeLabels(file, format_.format, labels);
    });
}

void PolyMeshWriter::writeUniformScalar(const std::string& object,
                                        const std::string& dimensions,
                                        double value) const {
    constexpr bool compress = false; // one line
    writeFile(header("uniformDimensionedScalarField", object), compress, [&](OutputFile& file) {
        file.write(fmt::format("dimensions      {};\n\nvalue           {};\n", dimensions, value));
    });
}

void writePolyMesh(const PolyMesh& mesh,
                   const fs::path& polyMeshDirectory,
                   const WriteFormat& format) {
    writePolyMesh(mesh, polyMeshDirectory, format, [](const PolyMeshWriter&) {});
}

void writePolyMesh(const PolyMesh& mesh,
                   const fs::path& polyMeshDirectory,
                   const WriteFormat& format,
                   const std::function<void(const PolyMeshWriter&)>& writeMore) {
    const MeshCounts counts{
        mesh.pointCount(), mesh.cellCount, mesh.faceCount(), mesh.internalFaceCount()};
    PolyMeshWriter writer(polyMeshDirectory, format, counts);
    const std::array<std::function<void()>, 4> tasks{
        [&] { writer.writeFaces(mesh.faces); }, // the longest first
        [&] { writer.writePoints(mesh.points); },
        [&] { writer.writeOwner(mesh.owner); },
        [&] { writer.writeNeighbour(mesh.neighbour); },
    };
    runAll(tasks);
    writer.writePatches(mesh.patches);
    writer.writeZones(ZoneKind::point, mesh.pointZones);
    writer.writeZones(ZoneKind::face, mesh.faceZones);
    writer.writeZones(ZoneKind::cell, mesh.cellZones);
    writeMore(writer);
    writer.commit();
}

} // namespace polymesh::foam
